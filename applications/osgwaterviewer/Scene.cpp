#include "Scene.h"

#include "Complain.h"
#include "DemoScenes.h"
#include "Sky.h"

#include <osg/ComputeBoundsVisitor>
#include <osgDB/FileUtils>
#include <osgDB/Registry>
#include <osgUtil/Optimizer>

#include <iostream>

using namespace osgwaterviewer;

namespace
{

// Null, with a message, where one of the files cannot be read.
osg::ref_ptr<osg::Group> readModels(const std::vector<std::string>& files)
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    for (const std::string& file : files)
    {
        osgDB::ReaderWriter::ReadResult result =
            osgDB::Registry::instance()->readNode(file, osgDB::Registry::instance()->getOptions());
        if (!result.validNode())
        {
            const bool found = !osgDB::findDataFile(file).empty();
            complain(file + ": expected a model, got " +
                     (found ? "what cannot be read (" + result.statusMessage() + ")" : "no file"));
            return nullptr;
        }
        root->addChild(result.getNode());
    }
    return root;
}

osg::BoundingBoxd boundOf(osg::Node& node)
{
    osg::ComputeBoundsVisitor visitor(osg::NodeVisitor::TRAVERSE_ACTIVE_CHILDREN);
    node.accept(visitor);
    return visitor.getBoundingBox();
}

void setLook(osgWaterReflect::WaterSurface& water, const WaterLook& look,
             osgWaterReflect::WaveModel* waves, osg::TextureCubeMap* sky)
{
    water.setReflection(look.reflection);
    water.setViewSettings(look.viewSettings);
    water.setOptics(look.optics);
    water.setDetail(look.detail);
    water.setDebugView(look.debugView);
    water.setWaves(look.moving ? waves : nullptr);
    water.setSky(sky);
}

std::string joined(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + word;
    return text;
}

} // namespace

std::optional<Scene> osgwaterviewer::createScene(const Options& options, double fovyDegrees)
{
    const std::vector<std::string> files =
        options.models.empty() ? std::vector<std::string>{defaultModel()} : options.models;
    const DemoScene* demo = files.size() == 1 ? findDemoScene(files.front()) : nullptr;

    Scene scene;
    scene.models = joined(files);
    scene.root = readModels(files);
    if (!scene.root) return std::nullopt;
    scene.waters = replaceWaterGeodes(*scene.root);
    osgUtil::Optimizer().optimize(scene.root);

    const osg::BoundingBoxd bound = boundOf(*scene.root);
    scene.look = options.look;
    std::optional<double> waterZ;
    if (options.waterLevel)
    {
        if (scene.waters.empty() && bound.valid()) scene.look.fitTo(2.0 * bound.radius());
        scene.waters.push_back(options.waterLevel->createWater(bound));
        if (!scene.waters.back()) return std::nullopt;
        scene.root->addChild(scene.waters.back());
        waterZ = options.waterLevel->over(bound);
    }
    if (scene.waters.empty())
        std::cout << "The model is shown without water; --water auto or --water LEVEL lays some."
                  << std::endl;

    scene.waves = scene.look.breeze.createWaves();
    const std::string skyDirectory =
        options.skyDirectory.value_or(demo ? demoSkyDirectory() : std::string());
    const osg::ref_ptr<osg::TextureCubeMap> sky =
        skyDirectory.empty() ? nullptr : readSky(skyDirectory);
    if (!sky && !skyDirectory.empty()) return std::nullopt;
    for (const osg::ref_ptr<osgWaterReflect::WaterSurface>& water : scene.waters)
        setLook(*water, scene.look, scene.waves, sky);

    scene.fovyDegrees = options.fovyDegrees.value_or(demo ? demo->fovyDegrees : fovyDegrees);
    scene.home = options.camera.value_or(demo ? demo->home
                                              : HomeView::over(bound, waterZ, scene.fovyDegrees));
    return scene;
}

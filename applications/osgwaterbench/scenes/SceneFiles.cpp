#include "SceneFiles.h"

#include "osgwaterviewer/DemoScenes.h"
#include "osgwaterviewer/Sky.h"
#include "osgwaterviewer/WaterGeodes.h"

#include <osgWaterReflect/Check.h>

#include <osg/NodeVisitor>
#include <osgDB/FileNameUtils>
#include <osgDB/Registry>

#include <typeinfo>

using namespace osgwaterbench;
using osgWaterReflect::refuse;
using osgWaterReflect::WaterSurface;

namespace
{

// Pictures of trees, blended, that write no depth: no ray can hit them in screen space.
const char* const BLENDED_GROUP = "tree cards";

const double LEVEL_TOLERANCE = 1e-4; // [m] what no picture shows

// Null, with a message, where a file of the data directory cannot be read.
osg::ref_ptr<osg::Group> readModel(const std::string& file)
{
    const std::string path = osgDB::concatPaths(osgwaterviewer::dataDirectory(), file);
    osgDB::ReaderWriter::ReadResult result =
        osgDB::Registry::instance()->readNode(path, osgDB::Registry::instance()->getOptions());
    osg::Node* const node = result.getNode();
    osg::ref_ptr<osg::Group> model = node ? node->asGroup() : nullptr;
    if (!model) refuse("readModel", "a scene that can be read", "none from " + path);
    return model;
}

class FindByName : public osg::NodeVisitor
{
public:
    explicit FindByName(const std::string& name) :
        osg::NodeVisitor(TRAVERSE_ALL_CHILDREN), _name(name)
    {
    }

    void apply(osg::Node& node) override
    {
        if (node.getName() == _name)
            found.push_back(&node);
        else
            traverse(node);
    }

    std::vector<osg::ref_ptr<osg::Node>> found;

private:
    std::string _name;
};

std::vector<osg::ref_ptr<osg::Node>> findByName(osg::Node& root, const std::string& name)
{
    FindByName visitor(name);
    root.accept(visitor);
    return visitor.found;
}

void takeOut(osg::Node& node)
{
    const osg::Node::ParentList parents = node.getParents(); // it shrinks meanwhile
    for (osg::Group* parent : parents)
        parent->removeChild(&node);
}

// All water in one surface; null, with a message, where there is none or it is not at one level.
osg::ref_ptr<WaterSurface> takeWater(osg::Group& model)
{
    osg::ref_ptr<WaterSurface> water = new WaterSurface;
    water->setName("water");
    for (const osg::ref_ptr<WaterSurface>& sheet : osgwaterviewer::replaceWaterGeodes(model))
    {
        const osg::MatrixList places = sheet->getWorldMatrices();
        if (places.size() != 1 || !places.front().isIdentity())
        {
            refuse("takeWater", "water that is placed once and not moved", places.size());
            return nullptr;
        }
        for (unsigned int i = 0; i < sheet->getNumDrawables(); ++i)
            water->addDrawable(sheet->getDrawable(i));
        takeOut(*sheet);
    }
    const osg::BoundingBox bound = water->getBoundingBox();
    if (bound.valid() && bound.zMax() - bound.zMin() <= LEVEL_TOLERANCE) return water;
    refuse("takeWater", "water at one level", bound.zMax() - bound.zMin());
    return nullptr;
}

} // namespace

std::optional<BenchScene> osgwaterbench::readDemoScene(const char* file)
{
    BenchScene bench;
    bench.scene = readModel(file);
    if (!bench.scene) return std::nullopt;
    for (const osg::ref_ptr<osg::Node>& blended : findByName(*bench.scene, BLENDED_GROUP))
        takeOut(*blended);
    bench.water = takeWater(*bench.scene);
    const osg::ref_ptr<osg::TextureCubeMap> sky = readDemoSky();
    if (!bench.water || !sky) return std::nullopt;
    bench.water->setSky(sky);
    bench.waterLevel = bench.water->getBoundingBox().center().z();
    return bench;
}

osg::ref_ptr<osg::TextureCubeMap> osgwaterbench::readDemoSky()
{
    return osgwaterviewer::readSky(osgwaterviewer::demoSkyDirectory());
}

osg::ref_ptr<osg::Group> osgwaterbench::createUnderSky()
{
    const osg::ref_ptr<osg::Group> lake = readModel("lake.osgb");
    if (!lake) return nullptr;
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    for (const osg::ref_ptr<osg::Node>& sky : findByName(*lake, "sky"))
        group->addChild(sky);
    return group;
}

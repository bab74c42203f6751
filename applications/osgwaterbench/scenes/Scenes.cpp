#include "Scenes.h"

#include "Bough.h"
#include "Boxes.h"
#include "SceneFiles.h"

#include "osgwaterviewer/DemoScenes.h"

#include <osgWaterReflect/Check.h>
#include <osgWaterReflect/TrochoidalWaves>

#include <osg/Math>
#include <osgDB/FileNameUtils>

#include <cmath>

using namespace osgwaterbench;
using osgWaterReflect::refuse;
using osgWaterReflect::TrochoidalWave;
using osgWaterReflect::TrochoidalWaves;
using osgWaterReflect::WaterSurface;
using osgwaterviewer::DemoScene;

namespace
{

// [m] The sides of the boxes' water, about the eye: its far edge is 0.25 degrees below the horizon.
const double BOXES_WATER_SIZE = 1000.0;

std::optional<BenchScene> createDemo(const char* file)
{
    std::optional<BenchScene> bench = readDemoScene(file);
    if (!bench) return std::nullopt;
    const DemoScene* demo =
        osgwaterviewer::findDemoScene(osgDB::concatPaths(osgwaterviewer::dataDirectory(), file));
    bench->eye = demo->home.eye;
    bench->centre = demo->home.centre;
    bench->fovyDegrees = demo->fovyDegrees;
    return bench;
}

std::optional<BenchScene> createLake()
{
    return createDemo("lake.osgb");
}

std::optional<BenchScene> createStreet()
{
    return createDemo("street.osgb");
}

// data/README.md has this view of things afloat.
std::optional<BenchScene> createFloating()
{
    std::optional<BenchScene> bench = readDemoScene("lake.osgb");
    if (!bench) return std::nullopt;
    bench->eye.set(-0.5, -26.9, 1.1);
    bench->centre.set(0.3, -21.0, 0.4);
    bench->fovyDegrees = 50.0;
    return bench;
}

std::optional<BenchScene> createBranch()
{
    std::optional<BenchScene> bench = createLake();
    if (bench) bench->scene->addChild(createBough(bench->eye));
    return bench;
}

std::optional<BenchScene> createBoxesOf(const BoxesFile& file, const std::vector<Box>& boxes)
{
    BenchScene bench;
    bench.scene = createUnderSky();
    const osg::ref_ptr<osg::TextureCubeMap> sky = bench.scene ? readDemoSky() : nullptr;
    if (!sky) return std::nullopt;
    bench.scene->addChild(createBoxes(boxes));
    bench.water = WaterSurface::createRectangle(osg::Vec3(file.eye.x(), file.eye.y(), 0.0),
                                                osg::Vec3(BOXES_WATER_SIZE, 0, 0),
                                                osg::Vec3(0, BOXES_WATER_SIZE, 0));
    bench.water->setSky(sky);
    bench.eye = file.eye;
    bench.centre = file.eye + osg::Vec3d(0.0, std::cos(file.pitch), -std::sin(file.pitch));
    bench.fovyDegrees = file.fovyDegrees;
    return bench;
}

std::optional<BenchScene> createPlainBoxes()
{
    const std::optional<BoxesFile> file = BoxesFile::read();
    return file ? createBoxesOf(*file, file->boxes) : std::nullopt;
}

std::optional<BenchScene> createBoxesWithBranch()
{
    const std::optional<BoxesFile> file = BoxesFile::read();
    if (!file) return std::nullopt;
    std::vector<Box> boxes = file->boxes;
    boxes.push_back(file->branch);
    return createBoxesOf(*file, boxes);
}

struct NamedScene
{
    const char* name;
    std::optional<BenchScene> (*create)();
};

const NamedScene SCENES[] = {{"lake", createLake},        {"floating", createFloating},
                             {"street", createStreet},    {"branch", createBranch},
                             {"boxes", createPlainBoxes}, {"boxes-branch", createBoxesWithBranch}};

// Lengths of the longest wave of a breeze, so that slopes of 0.15 are heights of a few centimetres;
// on the street so low that they stay within the puddle.
struct BreezeLength
{
    const char* sceneName;
    double length; // [m]
};

const BreezeLength BREEZE_LENGTHS[] = {
    {"lake", 2.0}, {"floating", 1.5}, {"street", 0.25}, {"branch", 2.0}, {"scaling", 2.0}};

// None for the boxes.
std::optional<double> breezeLengthOf(const std::string& sceneName)
{
    for (const BreezeLength& entry : BREEZE_LENGTHS)
        if (sceneName == entry.sceneName) return entry.length;
    return std::nullopt;
}

// Of waves that are not steep: each slope is a sine, and all are uncorrelated. At a slope of 0.15
// that is 0.5 % below the true one.
double rmsSlopeOf(const TrochoidalWaves& waves)
{
    double sum = 0.0;
    for (const TrochoidalWave& wave : waves.getWaves())
    {
        const double steepness = 2.0 * osg::PI / wave.length * wave.amplitude;
        sum += 0.5 * steepness * steepness;
    }
    return std::sqrt(sum);
}

osg::ref_ptr<TrochoidalWaves> createBreeze(double length, double rmsSlope)
{
    const double trialSteepness = 0.1; // any: the slope goes with it
    const osg::ref_ptr<TrochoidalWaves> trial =
        TrochoidalWaves::createBreeze(length, trialSteepness);
    return TrochoidalWaves::createBreeze(length, trialSteepness * rmsSlope / rmsSlopeOf(*trial));
}

} // namespace

std::vector<std::string> osgwaterbench::sceneNames()
{
    std::vector<std::string> names;
    for (const NamedScene& scene : SCENES)
        names.push_back(scene.name);
    return names;
}

std::optional<BenchScene> osgwaterbench::createScene(const std::string& name)
{
    std::string expected = "one of";
    for (const NamedScene& scene : SCENES)
    {
        if (name == scene.name)
        {
            std::optional<BenchScene> bench = scene.create();
            if (bench) bench->name = name;
            return bench;
        }
        expected += std::string(" ") + scene.name;
    }
    refuse("createScene", expected.c_str(), name);
    return std::nullopt;
}

osg::ref_ptr<osgWaterReflect::WaveModel> osgwaterbench::createWaves(const std::string& sceneName,
                                                                    double slope)
{
    const std::optional<double> length = breezeLengthOf(sceneName);
    if (!length && sceneName != "boxes" && sceneName != "boxes-branch")
    {
        refuse("createWaves", "the name of a scene", sceneName);
        return nullptr;
    }
    if (slope == 0.0) return nullptr;
    const std::optional<BoxesFile> file = BoxesFile::read();
    const osg::ref_ptr<HarnessWaves> waves = new HarnessWaves;
    if (!file || !waves->setWaves(file->waves, slope)) return nullptr;
    if (!length) return waves;
    return createBreeze(*length, waves->getRmsSlope());
}

// How long the truth takes: test_bench "[.time]".

#include "DrawnStillWater.h"
#include "support/Catch.h"

#include <osgwaterbench/measures/ImageTruth.h>
#include <osgwaterbench/measures/Measures.h>
#include <osgwaterbench/measures/PictureError.h>
#include <osgwaterbench/measures/TessellationError.h>

#include <osgWaterReflect/Transforms.h>
#include <osgWaterReflect/TrochoidalWaves>

#include <osgDB/ReadFile>

#include <glm/geometric.hpp>

#include <chrono>

using namespace osgwaterbench;
using osgWaterReflect::toOsg;
using osgWaterReflect::reference::SceneTracer;

namespace
{

// The lake without the stand-in for its water and without its sky.
osg::ref_ptr<osg::Group> readLake()
{
    const osg::ref_ptr<osg::Node> lake =
        osgDB::readRefNodeFile(std::string(OSGWATERREFLECT_DATA_DIRECTORY) + "/lake.osgb");
    REQUIRE(lake);
    const osg::ref_ptr<osg::Group> group = lake->asGroup();
    for (unsigned int i = group->getNumChildren(); i-- > 0;)
        if (group->getChild(i)->getName() == "water" || group->getChild(i)->getName() == "sky")
            group->removeChild(i);
    return group;
}

// The water's pixels and the captured image, both by rays.
DrawnWater drawLake(const SceneTracer& scene)
{
    const ViewAhead view{{0.0, -30.0, 2.2}, -0.76, 46.0, 640, 480}; // data/README.md's good view
    const auto isSeen = [&](const glm::dvec3& place)
    { return glm::length(place) < 400.0 && !scene.occluded(toOsg(view.eye), toOsg(place), 1e-4); };
    DrawnWater drawn = drawStillWater(view, isSeen);
    drawn.capture.geometry = drawn.view;
    for (int i = 0; i < view.width * view.height; ++i)
    {
        const glm::dvec2 window(i % view.width + 0.5, i / view.width + 0.5);
        const glm::dvec3 way = placeAtWindow(drawn, window, 1.0) - view.eye;
        const auto hit = scene.trace(toOsg(view.eye), toOsg(way), 0.2);
        const glm::dvec3 hitEye =
            hit ? glm::dvec3(drawn.eyeFromWorld *
                             glm::dvec4(osgWaterReflect::fromOsg(hit->point), 1.0))
                : glm::dvec3(0.0);
        drawn.capture.windowZ.push_back(hit ? static_cast<float>(drawn.view.windowFromEye(hitEye).z)
                                            : 1.0f);
    }
    return drawn;
}

template <class Work>
void printPerSecond(const char* name, std::size_t pixels, const Work& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    WARN(name << ": " << pixels << " pixels in " << seconds.count() << " s, "
              << pixels / seconds.count() << " a second");
}

} // namespace

TEST_CASE("bench: how long the measures of the lake take", "[.time]")
{
    const osg::ref_ptr<osg::Group> lake = readLake();
    const SceneTracer scene(*lake);
    const DrawnWater drawn = drawLake(scene);
    const SkyLookup sky(glm::dvec3(0.6, 0.7, 0.9));
    const std::size_t pixels = waterPixels(drawn).size();
    WARN(scene.triangleCount() << " triangles");

    Truth truth;
    printPerSecond("truth", pixels, [&] { truth = findTruth(drawn, {scene, sky, {}}); });
    ImageTruth imageTruth;
    printPerSecond("image truth", pixels, [&] { imageTruth = findImageTruth(drawn, 0.5); });

    Answers answers(drawn.isWater.size());
    for (const ImagePixel& own : imageTruth)
        answers[own.pixel] = {!own.found(), own.placeWorld, 0.0f};
    Measures measures;
    printPerSecond("measures", pixels, [&] { measures = measure(drawn, truth, answers, 0.5); });
    const char* const names[] = {"sky", "visible", "hidden", "outside top", "outside sides"};
    for (int i = 0; i < TRUE_CLASS_COUNT; ++i)
    {
        const Tally& tally = measures.classes[i];
        WARN(names[i] << ": " << tally.total() << ", correct "
                      << tally.percent(Outcome::CORRECT).value_or(-1.0) << " %, misplaced "
                      << tally.percent(Outcome::MISPLACED).value_or(-1.0) << " %, missed "
                      << tally.percent(Outcome::MISSED).value_or(-1.0) << " %, false "
                      << tally.percent(Outcome::FALSE_HIT).value_or(-1.0) << " %");
    }
    WARN("hit error " << measures.hitErrorPixels->median << ", " << measures.hitErrorPixels->p90
                      << ", " << measures.hitErrorPixels->p99 << " px");

    const Picture picture = {drawn.width(), drawn.height(),
                             std::vector<glm::dvec3>(drawn.isWater.size(), glm::dvec3(0.5))};
    printPerSecond("picture error", pixels,
                   [&] { comparePictures(withTruth(picture, truth), picture, drawn.isWater); });
    const osg::ref_ptr<osgWaterReflect::TrochoidalWaves> model =
        osgWaterReflect::TrochoidalWaves::createBreeze(4.0, 0.1);
    printPerSecond("tessellation error", pixels,
                   [&] {
                       measureTessellation(drawn, {*model, 0.0, drawn.eyeFromWorld}, scene);
                   });
}

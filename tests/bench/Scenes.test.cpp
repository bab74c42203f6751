// The scenes, waters and waves that osgwaterbench measures with.

#include "support/Catch.h"
#include "support/Refusals.h"

#include <osgwaterbench/scenes/HarnessWaves.h>
#include <osgwaterbench/scenes/Scenes.h>

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/reference/SceneTracer.h>
#include <osgWaterReflect/surface/StillWater.h>

#include <osg/Geometry>
#include <osg/Math>
#include <osgDB/FileUtils>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

using namespace osgwaterbench;
using osgWaterReflect::StillWater;
using osgWaterReflect::WaterSurface;
using osgWaterReflect::WaveModel;
using osgWaterReflect::reference::SceneHit;
using osgWaterReflect::reference::SceneTracer;

namespace
{

// [m^2] The scaling scene's rectangle of water: 140 m by 66 m.
const double SCALING_AREA = 140.0 * 66.0;

double areaOf(const WaterSurface& water)
{
    double area = 0.0;
    for (unsigned int i = 0; i < water.getNumDrawables(); ++i)
        for (const auto& sheet :
             StillWater::createSheets(const_cast<osg::Drawable&>(*water.getDrawable(i))))
        {
            const std::vector<glm::dvec2>& corners = sheet->corners();
            const std::vector<unsigned int>& triangles = sheet->triangles();
            for (std::size_t t = 0; t + 2 < triangles.size(); t += 3)
            {
                const glm::dvec2 a = corners[triangles[t + 1]] - corners[triangles[t]];
                const glm::dvec2 b = corners[triangles[t + 2]] - corners[triangles[t]];
                area += 0.5 * std::abs(a.x * b.y - a.y * b.x);
            }
        }
    return area;
}

class CountTriangles : public osg::NodeVisitor
{
public:
    CountTriangles() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}

    void apply(osg::Drawable& drawable) override
    {
        ++drawables;
        const osg::Geometry& geometry = *drawable.asGeometry();
        for (const auto& set : geometry.getPrimitiveSetList())
            triangles += set->getNumIndices() / 3;
    }

    std::size_t drawables = 0;
    std::size_t triangles = 0;
};

// Root of the mean square slope over a square of surface about a place.
double sampledRmsSlope(const WaveModel& waves)
{
    // Many of the longest waves, at places that no wave's length divides.
    const int count = 300;
    const double step = 0.377; // [m]
    double sum = 0.0;
    for (int y = 0; y < count; ++y)
        for (int x = 0; x < count; ++x)
        {
            const osg::Vec3d normal = waves.getNormal(osg::Vec2d(x * step, y * step), 0.0);
            sum += (normal.x() * normal.x() + normal.y() * normal.y()) / (normal.z() * normal.z());
        }
    return std::sqrt(sum / (count * count));
}

// While it lives, the data directory is another one.
class OtherData
{
public:
    explicit OtherData(const std::string& directory)
    {
        if (const char* const old = std::getenv(VARIABLE)) _old = old;
        setenv(VARIABLE, directory.c_str(), 1);
    }
    ~OtherData() { _old ? setenv(VARIABLE, _old->c_str(), 1) : unsetenv(VARIABLE); }

private:
    static constexpr const char* VARIABLE = "OSGWATERREFLECT_DATA";
    std::optional<std::string> _old;
};

// The waves of data/bench/boxes.json at a slope.
osg::Vec2d harnessSlope(double x, double y, double slope)
{
    const double a = std::cos(3.0 * (0.8 * x + 0.6 * y));
    const double b = 0.6 * std::cos(5.0 * (-0.4 * x + 0.9 * y) + 1.0);
    const double c = 0.3 * std::cos(9.0 * (0.9 * x - 0.2 * y));
    return osg::Vec2d(0.8 * a - 0.4 * b + 0.9 * c, 0.6 * a + 0.9 * b - 0.2 * c) * slope;
}

// Its mean square, of three sines whose directions have squared lengths of 1, 0.97 and 0.85.
const double HARNESS_RMS_SLOPE =
    std::sqrt(0.5 * (1.0 + 0.6 * 0.6 * 0.97 + 0.3 * 0.3 * 0.85)); // at slope 1

const osg::Vec2d PLACES[] = {{0.0, 0.0}, {1.7, -0.3}, {-12.4, 33.1}, {480.0, -495.5}};

} // namespace

TEST_CASE("every scene to measure in has triangles and level water beside it")
{
    for (const std::string& name : sceneNames())
        DYNAMIC_SECTION(name)
        {
            const std::optional<BenchScene> bench = createScene(name);
            REQUIRE(bench);
            CHECK(bench->name == name);
            CHECK(SceneTracer(*bench->scene).triangleCount() > 500);

            REQUIRE(bench->water);
            CHECK(bench->water->getNumParents() == 0);
            CHECK(bench->water->getSky());
            CHECK_FALSE(bench->water->getWaves());
            const osg::BoundingBox bound = bench->water->getBoundingBox();
            CHECK(bound.zMin() == Approx(bench->waterLevel).margin(1e-4));
            CHECK(bound.zMax() == Approx(bench->waterLevel).margin(1e-4));
            CHECK(areaOf(*bench->water) > 10.0);
            CHECK(bench->eye.z() > bench->waterLevel);
            CHECK(bench->fovyDegrees > 40.0);

            // The sky is the only thing that writes no depth.
            const osg::Vec3d up(0, 0, 1);
            const SceneTracer all(*bench->scene, SceneTracer::Kept::ALL);
            const std::optional<SceneHit> hit = all.trace(bench->eye + up * 50.0, up);
            REQUIRE(hit);
            CHECK_FALSE(hit->writesDepth);
            CHECK(all.triangleCount() == SceneTracer(*bench->scene).triangleCount() + 12);
        }
}

TEST_CASE("a scene of another name is refused")
{
    Refusals refusals;
    CHECK_FALSE(createScene("ocean"));
    const std::string message = refusals.take();
    CHECK(isRefusalOf("createScene", message));
    for (const std::string& name : sceneNames())
        CHECK(message.find(" " + name) != std::string::npos);
    CHECK(message.find("got ocean") != std::string::npos);

    CHECK_FALSE(createWaves("ocean", 0.05));
    CHECK(isRefusalOf("createWaves", refusals.take()));
    CHECK_FALSE(createWaves("boxes", -0.05));
    CHECK(isRefusalOf("HarnessWaves::setWaves slope", refusals.take()));
}

TEST_CASE("a scene whose data is missing or broken is refused")
{
    const std::string directory = OSGWATERREFLECT_TEST_OUTPUT_DIRECTORY "/broken-data";
    const std::string boxes = directory + "/bench/boxes.json";
    osgDB::makeDirectoryForFile(boxes);
    std::remove(boxes.c_str());
    const OtherData otherData(directory);

    Refusals refusals;
    CHECK_FALSE(createScene("lake"));
    CHECK(isRefusalOf("readModel", refusals.take()));
    CHECK_FALSE(createScene("boxes"));
    CHECK(isRefusalOf("BoxesFile::read", refusals.take()));
    for (const char* text : {"", "{", "[]", "{\"camera\": 3}"})
    {
        std::ofstream(boxes) << text;
        CHECK_FALSE(createWaves("boxes", 0.05));
        CHECK(isRefusalOf("BoxesFile::read", refusals.take()));
    }
    CHECK_FALSE(createScalingScene(1000).scene);
}

TEST_CASE("a bough hides much of what the eye sees above the lake")
{
    const std::optional<BenchScene> lake = createScene("lake");
    const std::optional<BenchScene> branch = createScene("branch");
    REQUIRE(lake);
    REQUIRE(branch);
    const SceneTracer without(*lake->scene), with(*branch->scene);
    int hidden = 0, rays = 0;
    double nearest = 1e3, farthest = 0.0;           // [m]
    for (double x = -0.5; x <= 0.5; x += 0.01)      // tangents: the picture from side to side,
        for (double z = 0.05; z <= 0.25; z += 0.01) // and what is up to 14 degrees up
        {
            const osg::Vec3d dir(x, 1.0, z);
            const std::optional<SceneHit> hit = with.trace(branch->eye, dir);
            const std::optional<SceneHit> behind = without.trace(lake->eye, dir);
            ++rays;
            if (!hit || (behind && behind->t <= hit->t)) continue;
            ++hidden;
            nearest = std::min(nearest, hit->t);
            farthest = std::max(farthest, hit->t);
        }
    CHECK(nearest > 3.0);
    CHECK(farthest < 7.0);
    CHECK(hidden > 0.35 * rays);
    CHECK(hidden < 0.75 * rays); // leaves leave holes
}

TEST_CASE("the boxes are looked at as they were measured before")
{
    const std::optional<BenchScene> bench = createScene("boxes");
    const std::optional<BenchScene> branch = createScene("boxes-branch");
    REQUIRE(bench);
    REQUIRE(branch);
    CHECK(bench->eye == osg::Vec3d(0, 0, 2));
    const osg::Vec3d look = bench->centre - bench->eye;
    CHECK(std::atan2(-look.z(), look.y()) == Approx(0.15));
    CHECK(osg::DegreesToRadians(bench->fovyDegrees) == Approx(0.8));
    CHECK(SceneTracer(*bench->scene).triangleCount() == 48 * 12);
    CHECK(SceneTracer(*branch->scene).triangleCount() == 49 * 12);

    // The branch's front, 5 m away, and the first box's, each in squares of half a metre.
    const SceneTracer tracer(*branch->scene);
    const auto colourAt = [&](double x, double y, double z)
    {
        const std::optional<SceneHit> hit =
            tracer.trace(osg::Vec3d(x, y - 0.5, z), osg::Vec3d(0, 1, 0));
        REQUIRE(hit);
        CHECK(hit->t == Approx(0.5).epsilon(1e-6)); // single precision of the corners
        return hit->colour;
    };
    const osg::Vec4 square = colourAt(0.25, 5.0, 2.75);
    CHECK((square - colourAt(1.25, 5.0, 2.9)).length() < 1e-6f); // one square is of one colour
    CHECK((square - colourAt(0.75, 5.0, 2.75)).length() > 0.1f);
    const osg::Vec4 box = colourAt(-1.6, 5.8582, 0.3);
    CHECK(box.g() / box.r() == Approx(0.865 / 0.564).epsilon(0.01)); // colours have 8 bits
}

TEST_CASE("harness waves tilt flat water by three cosines")
{
    const double slope = 0.15;
    const osg::ref_ptr<WaveModel> waves = createWaves("boxes", slope);
    REQUIRE(waves);
    CHECK(waves->getAmplitude() == 0.0);
    CHECK(std::isinf(waves->getShortestLength()));
    for (const osg::Vec2d& place : PLACES)
    {
        const osg::Vec2d expected = harnessSlope(place.x(), place.y(), slope);
        const osg::Vec3d normal = waves->getNormal(place, 0.0);
        // Roundings of phases of some thousand radians.
        CHECK(-normal.x() / normal.z() == Approx(expected.x()).margin(1e-11));
        CHECK(-normal.y() / normal.z() == Approx(expected.y()).margin(1e-11));
        CHECK(normal.length() == Approx(1.0));
        CHECK(waves->getHeight(place, 0.0) == 0.0);
        CHECK(waves->getNormal(place, 7.0) == normal);
    }
    CHECK_FALSE(createWaves("boxes", 0.0));
}

TEST_CASE("harness waves hand the shader the same slope about any anchor")
{
    const double slope = 0.05;
    const osg::ref_ptr<WaveModel> waves = createWaves("boxes-branch", slope);
    REQUIRE(waves);
    for (const osg::Vec2d& anchor : PLACES)
    {
        const osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
        waves->createState(0.0)->apply(*stateSet, anchor);
        int count = 0;
        REQUIRE(stateSet->getUniform("bench_waveCount"));
        REQUIRE(stateSet->getUniform("bench_waves"));
        stateSet->getUniform("bench_waveCount")->get(count);
        CHECK(count == 3);

        const osg::Vec2 p(2.3f, -1.1f);
        osg::Vec2 sum;
        for (int i = 0; i < count; ++i)
        {
            osg::Vec4 wave;
            stateSet->getUniform("bench_waves")->getElement(i, wave);
            const osg::Vec2 k(wave.x(), wave.y());
            sum += k * (wave.z() * std::cos(k * p + wave.w()));
        }
        const osg::Vec2d expected =
            harnessSlope(anchor.x() + double(p.x()), anchor.y() + double(p.y()), slope);
        CHECK(sum.x() == Approx(expected.x()).margin(1e-6)); // single precision
        CHECK(sum.y() == Approx(expected.y()).margin(1e-6));
    }
}

TEST_CASE("harness waves refuse what they cannot be")
{
    Refusals refusals;
    const osg::ref_ptr<HarnessWaves> waves = new HarnessWaves;
    const HarnessWave wave{{1.0, 0.0}, 2.0, 0.0, 1.0};
    REQUIRE(waves->setWaves({wave}, 0.1));
    HarnessWave broken = wave;
    broken.waveNumber = 0.0;
    CHECK_FALSE(waves->setWaves({broken}, 0.1));
    CHECK(isRefusalOf("HarnessWaves::setWaves waveNumber", refusals.take()));
    CHECK_FALSE(waves->setWaves(std::vector<HarnessWave>(9, wave), 0.1));
    CHECK(isRefusalOf("HarnessWaves::setWaves", refusals.take()));
    CHECK_FALSE(waves->setWaves({wave}, std::nan("")));
    CHECK(isRefusalOf("HarnessWaves::setWaves slope", refusals.take()));
    CHECK(waves->getRmsSlope() == Approx(0.1 * std::sqrt(0.5)));
}

TEST_CASE("waves have the slope that is asked for, whatever the scene")
{
    std::vector<std::string> names = sceneNames();
    names.push_back("scaling");
    for (const std::string& name : names)
        for (double slope : {0.05, 0.15})
        {
            CAPTURE(name, slope);
            const osg::ref_ptr<WaveModel> waves = createWaves(name, slope);
            REQUIRE(waves);
            // A breeze's sines are sharper at their crests, and samples are finite in number.
            CHECK(sampledRmsSlope(*waves) == Approx(slope * HARNESS_RMS_SLOPE).epsilon(0.02));
            CHECK(waves->getAmplitude() < 0.1);
        }
    CHECK(createWaves("street", 0.15)->getAmplitude() < 0.014); // the street's rim of the puddle
}

TEST_CASE("a complex scene has as many triangles as asked for, in few drawables")
{
    for (std::size_t asked : {1000, 1234, 3903, 3904, 50000, 654321, 10000000})
    {
        CountTriangles counted;
        const osg::ref_ptr<osg::Group> scene = createComplexScene(asked);
        REQUIRE(scene);
        scene->accept(counted);
        CHECK(counted.triangles == Approx(double(asked)).epsilon(0.005));
        CHECK(counted.drawables <= 64);
    }
    Refusals refusals;
    for (std::size_t refused : {999, 10000001})
    {
        CHECK_FALSE(createComplexScene(refused));
        CHECK(isRefusalOf("createComplexScene", refusals.take()));
    }
}

TEST_CASE("a complex scene looks the same with any number of triangles")
{
    const BenchScene coarse = createScalingScene(1000), fine = createScalingScene(70000);
    REQUIRE(coarse.scene);
    REQUIRE(fine.scene);
    CHECK(coarse.name == "scaling");
    const SceneTracer coarseTracer(*coarse.scene), fineTracer(*fine.scene);
    int hits = 0, different = 0;
    for (double x = -0.6; x <= 0.6; x += 0.013) // tangents
        for (double z = -0.05; z <= 0.2; z += 0.011)
        {
            const osg::Vec3d dir(x, 1.0, z);
            const std::optional<SceneHit> a = coarseTracer.trace(coarse.eye, dir);
            const std::optional<SceneHit> b = fineTracer.trace(fine.eye, dir);
            CHECK(a.has_value() == b.has_value());
            if (!a || !b) continue;
            ++hits;
            different += std::abs(a->t - b->t) > 1e-3; // [m] single precision of the corners
            different += (a->colour - b->colour).length() > 3.0 / 255.0; // of 8 bits each
        }
    CHECK(hits > 500);
    CHECK(different <= 2); // at the edge of a square or a tower
}

TEST_CASE("waters that divide the rectangle cover all of it")
{
    const BenchScene bench = createScalingScene(1000);
    REQUIRE(bench.water);
    CHECK(areaOf(*bench.water) == Approx(SCALING_AREA).epsilon(1e-6)); // single precision
    for (int count : {1, 2, 7, 16, 64})
    {
        const auto waters = createWaters(count);
        CHECK(waters.size() == static_cast<std::size_t>(count));
        double area = 0.0;
        for (const osg::ref_ptr<WaterSurface>& water : waters)
        {
            CHECK(water->getSky());
            CHECK(areaOf(*water) == Approx(SCALING_AREA / count).epsilon(1e-5));
            area += areaOf(*water);
        }
        CHECK(area == Approx(SCALING_AREA).epsilon(1e-6));
    }
    Refusals refusals;
    for (int refused : {0, 65})
    {
        CHECK(createWaters(refused).empty());
        CHECK(isRefusalOf("createWaters", refusals.take()));
    }
}

TEST_CASE("water of many corners covers as much")
{
    for (int corners : {4, 5, 64, 1024})
    {
        const osg::ref_ptr<WaterSurface> water = createShapedWater(corners);
        REQUIRE(water);
        CHECK(areaOf(*water) == Approx(SCALING_AREA).epsilon(1e-6));
        std::size_t found = 0;
        for (unsigned int i = 0; i < water->getNumDrawables(); ++i)
            for (const auto& sheet : StillWater::createSheets(*water->getDrawable(i)))
                found += sheet->corners().size();
        CHECK(found == static_cast<std::size_t>(corners));
    }
    Refusals refusals;
    CHECK_FALSE(createShapedWater(3));
    CHECK(isRefusalOf("createShapedWater", refusals.take()));
}

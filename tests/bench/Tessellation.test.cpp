// What is lost between waves and what was drawn of them.

#include "WallCase.h"
#include "support/Catch.h"

#include <osgwaterbench/measures/SightLine.h>
#include <osgwaterbench/measures/TessellationError.h>

#include <osgWaterReflect/TrochoidalWaves>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

using namespace osgwaterbench;
using osgWaterReflect::TrochoidalWaves;

namespace
{

// The drawn water moved onto waves along the lines of sight, with their normals.
DrawnWater onWaves(DrawnWater drawn, const ExactWaves& waves)
{
    const glm::dmat4 surfaceFromEye = glm::inverse(waves.eyeFromSurface);
    for (std::size_t pixel : waterPixels(drawn))
    {
        glm::dvec3& pointEye = drawn.pointEye[pixel];
        pointEye = *meetWaves(drawn, waves, pointEye);
        const glm::dvec3 place(surfaceFromEye * glm::dvec4(pointEye, 1.0));
        const osg::Vec3d normal = waves.model.getNormal(osg::Vec2d(place.x, place.y), waves.time);
        drawn.normalEye[pixel] =
            glm::dvec3(waves.eyeFromSurface * glm::dvec4(normal.x(), normal.y(), normal.z(), 0.0));
    }
    return drawn;
}

osg::ref_ptr<TrochoidalWaves> oneWave()
{
    osg::ref_ptr<TrochoidalWaves> waves = new TrochoidalWaves;
    REQUIRE(waves->setWaves({{0.06, 1.3, 70.0, 0.4}}));
    return waves;
}

} // namespace

TEST_CASE("tessellation: what is drawn exactly has no error")
{
    const WallCase wall;
    const osg::ref_ptr<TrochoidalWaves> model = oneWave();
    const ExactWaves waves{*model, 1.7, wall.drawn.eyeFromWorld};
    const TessellationError error =
        measureTessellation(onWaves(wall.drawn, waves), waves, wall.scene);
    CHECK(error.height->count == wall.truth.size());
    CHECK(error.height->p99 < 1e-8); // found to 1e-9 m
    CHECK(error.normalDegrees->p99 < 1e-6);
    REQUIRE(error.movedPixels);
    CHECK(error.movedPixels->count > 500);
    CHECK(error.movedPixels->p90 < 1e-6);
}

// Falls when normals are compared in the wrong space, and when degrees are radians.
TEST_CASE("tessellation: water drawn too high, with normals that lean")
{
    const WallCase wall;
    const osg::ref_ptr<TrochoidalWaves> model = oneWave();
    const ExactWaves waves{*model, 1.7, wall.drawn.eyeFromWorld};
    DrawnWater drawn = onWaves(wall.drawn, waves);
    const glm::dvec3 up = drawn.stillNormalEye;
    for (std::size_t pixel : waterPixels(drawn))
    {
        drawn.pointEye[pixel] += 0.003 * up;
        const glm::dvec3 normal = drawn.normalEye[pixel];
        const glm::dvec3 beside = glm::normalize(glm::cross(normal, glm::dvec3(0.3, 0.5, 0.2)));
        const double lean = glm::radians(0.25);
        drawn.normalEye[pixel] = std::cos(lean) * normal + std::sin(lean) * beside;
    }
    const TessellationError error = measureTessellation(drawn, waves, wall.scene);
    CHECK(error.height->median == Approx(0.003).epsilon(1e-5)); // of 1e-8 m
    CHECK(error.height->p99 == Approx(0.003).epsilon(1e-5));
    CHECK(error.normalDegrees->median == Approx(0.25).epsilon(1e-4));
    CHECK(error.normalDegrees->p99 == Approx(0.25).epsilon(1e-4));
    CHECK(error.movedPixels->median > 0.1);
}

// Calm water drawn 1 cm too high: its line of sight comes down to the water later, and both are
// mirrors: on an upright wall the reflection lies 2 cm lower. Falls when the exact place is not
// looked for along the line of sight.
TEST_CASE("tessellation: how far calm water that is drawn too high moves its reflection")
{
    const WallCase wall;
    const double offset = 0.01; // [m]
    const DrawnWater drawn = drawStillWater(
        wall.view, [&](const glm::dvec3& place) { return place.y < 0.95 * wall.distance; }, offset);
    const osg::ref_ptr<TrochoidalWaves> calm = new TrochoidalWaves;
    const ExactWaves waves{*calm, 0.0, drawn.eyeFromWorld};
    const TessellationError error = measureTessellation(drawn, waves, wall.scene);
    CHECK(error.height->median == Approx(offset));
    CHECK(error.normalDegrees->p99 < 1e-6);

    std::vector<double> moved;
    for (std::size_t pixel : waterPixels(drawn))
    {
        const glm::dvec3 mirroredEye(wall.view.eye.x, wall.view.eye.y,
                                     2.0 * offset - wall.view.eye.z);
        const glm::dvec3 way = waterPoint(drawn, pixel) - mirroredEye;
        const glm::dvec3 place = mirroredEye + way * (wall.distance / way.y);
        const glm::dvec3 exact = place - glm::dvec3(0.0, 0.0, 2.0 * offset);
        if (!wall.onWall(place) || !wall.onWall(exact) || exact.z < 0.0) continue;
        moved.push_back(ViewPixels(drawn).distance(place, exact));
    }
    REQUIRE(moved.size() > 1000);
    const Percentiles expected = *percentilesOf(moved);
    CHECK(error.movedPixels->count == moved.size());
    CHECK(error.movedPixels->median == Approx(expected.median));
    CHECK(error.movedPixels->p90 == Approx(expected.p90));
    // 2 cm of the 14 cm of a pixel at 20 m.
    CHECK(expected.median ==
          Approx(0.02 / (2.0 * 20.0 * std::tan(glm::radians(23.0)) / 120.0)).epsilon(0.05));
}

// Falls when regula falsi takes one step, when the search steps over crests (STEP is 0.5), and when
// only one direction is looked along.
TEST_CASE("tessellation: lines of sight meet steep waves where they first come through")
{
    const bool manyWaves = GENERATE(false, true);
    INFO(manyWaves);
    osg::ref_ptr<TrochoidalWaves> model = TrochoidalWaves::createBreeze(2.0, 0.7);
    if (!manyWaves) REQUIRE(model->setWaves({{0.22, 2.0, 60.0, 0.0}})); // as steep
    ViewAhead view;
    view.pitchDegrees = 5.0;
    const DrawnWater still =
        drawStillWater(view, [](const glm::dvec3& place) { return place.y < 40.0; });
    // A surface that is moved, turned and half as large.
    const glm::dmat4 worldFromSurface =
        glm::scale(glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(3.0, -2.0, 0.0)), 0.6,
                               glm::dvec3(0.0, 0.0, 1.0)),
                   glm::dvec3(0.5));
    const ExactWaves waves{*model, 2.5, still.eyeFromWorld * worldFromSurface};
    const glm::dmat4 surfaceFromEye = glm::inverse(waves.eyeFromSurface);
    double farthestOff = 0.0;    // [m]
    double farthestBeside = 0.0; // [world units]
    for (std::size_t pixel : waterPixels(still, 2))
    {
        const glm::dvec3& from = still.pointEye[pixel];
        const auto met = meetWaves(still, waves, from);
        REQUIRE(met);
        const auto off = [&](const glm::dvec3& pointEye)
        {
            const glm::dvec3 p(surfaceFromEye * glm::dvec4(pointEye, 1.0));
            return p.z - model->getHeight(osg::Vec2d(p.x, p.y), waves.time);
        };
        farthestOff = std::max(farthestOff, std::abs(off(*met)));
        const glm::dvec3 sight = sightDirEye(still, from);
        farthestBeside = std::max(farthestBeside, glm::length(glm::cross(*met - from, sight)));
        // Between them the line of sight stays on one side of the waves.
        const bool over = off(from) > 0.0;
        for (int i = 1; i < 20; ++i)
            CHECK((off(glm::mix(from, *met, i / 20.0)) > 0.0) == over);
    }
    CHECK(farthestOff < 1e-8);
    CHECK(farthestBeside < 1e-12);
}

TEST_CASE("tessellation: a line of sight that rises meets no waves")
{
    const WallCase wall;
    const osg::ref_ptr<TrochoidalWaves> calm = new TrochoidalWaves;
    const ExactWaves waves{*calm, 0.0, wall.drawn.eyeFromWorld};
    CHECK_FALSE(meetWaves(wall.drawn, waves, glm::dvec3(0.0, 8.0, -20.0)));
}

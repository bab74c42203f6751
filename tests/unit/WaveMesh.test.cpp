// WaveMesh divides the sheets of StillWater for a view.

#include "support/Catch.h"
#include "support/DividedWater.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/WaterSurface>
#include <osgWaterReflect/surface/WaveMesh.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

using namespace osgWaterReflect;
using namespace dividedWater;

namespace
{

using Outline = WaterSurface::Outline;

osg::ref_ptr<StillWater> sheetOf(WaterSurface* made)
{
    osg::ref_ptr<WaterSurface> water = made;
    REQUIRE(water);
    REQUIRE(water->getNumDrawables() == 1);
    const auto sheets = StillWater::createSheets(*water->getDrawable(0));
    REQUIRE(sheets.size() == 1);
    return sheets[0];
}

osg::ref_ptr<StillWater> lake(double size)
{
    return sheetOf(
        WaterSurface::createRectangle(osg::Vec3(), osg::Vec3(size, 0, 0), osg::Vec3(0, size, 0)));
}

// A star with an island: concave, and with a hole.
osg::ref_ptr<StillWater> star(double radius)
{
    Outline outline;
    for (int i = 0; i < 14; ++i)
    {
        const double r = radius * (i % 2 ? 0.4 : 1.0);
        outline.push_back(
            osg::Vec3(r * std::cos(i * osg::PI / 7), r * std::sin(i * osg::PI / 7), 0));
    }
    const float h = 0.1f * radius;
    return sheetOf(WaterSurface::createPolygon(
        outline, {{osg::Vec3(-h, -h, 0), osg::Vec3(h, -h, 0), osg::Vec3(0, h, 0)}}));
}

SheetView orthographicView(double halfHeight)
{
    SheetView view = viewFrom(glm::dvec3(0, -50, 30), glm::dvec3(0, 0, 0));
    const double halfWidth = halfHeight * 640.0 / 480.0;
    view.clipFromEye = glm::ortho(-halfWidth, halfWidth, -halfHeight, halfHeight, -1000.0, 1000.0);
    return view;
}

// What an edge has over what it may have, above 1 where it has to be halved: the least of its
// length over maxEdgePixels and over the shortest edge, and of the waves' error over
// maxErrorPixels, face on. The length is seen at the nearest point of the edge, the error at the
// nearest of any triangle that the edge can be the longest side of.
//   coarsening  what edges may be longer by
double excess(const glm::dvec2& start, const glm::dvec2& end, const SheetView& view,
              const SurfaceDetail& detail, double coarsening = 1.0)
{
    const glm::dvec3 eye(glm::inverse(view.eyeFromSurface)[3]);
    const glm::dvec2 foot(eye);
    const double length = glm::distance(start, end);
    const double s = glm::clamp(glm::dot(foot - start, end - start) / (length * length), 0.0, 1.0);
    const double beside = glm::distance(foot, glm::mix(start, end, s));
    double depth = std::hypot(beside, eye.z);
    double nearest = std::hypot(std::max(0.0, beside - std::sqrt(0.75) * length), eye.z);
    if (view.clipFromEye[2][3] == 0.0) depth = nearest = 1.0;

    // Of a length of 1 at a depth of 1, or at any in an orthographic view.
    const double pixels = std::max(0.5 * view.viewportWidth * view.clipFromEye[0][0],
                                   0.5 * view.viewportHeight * view.clipFromEye[1][1]);
    const double shorter = length / coarsening;
    const double error = std::sqrt(view.waves.chordErrors.squaredAt(shorter * shorter));
    return std::min({shorter / view.waves.shortestEdge,
                     shorter * pixels / depth / detail.maxEdgePixels,
                     error * pixels / nearest / detail.maxErrorPixels});
}

// The largest excess of any edge.
double largestExcess(const Mesh& mesh, const SheetView& view, const SurfaceDetail& detail,
                     double coarsening = 1.0)
{
    double largest = 0.0;
    for (const auto& edge : edgesOf(mesh.triangles))
        largest =
            std::max(largest, excess(mesh.places[edge.first.first], mesh.places[edge.first.second],
                                     view, detail, coarsening));
    return largest;
}

// Of all triangles that are not the still water's own, the least excess of what was halved to make
// them: of the largest edge that they can have been halved at.
double leastReason(const Mesh& mesh, const StillWater& water, const SheetView& view,
                   const SurfaceDetail& detail, double coarsening = 1.0)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
    {
        double reason = 0.0;
        bool still = true;
        for (int i = 0; i < 3; ++i)
        {
            still = still && mesh.triangles[t + i] < water.corners().size();
            const glm::dvec2& a = mesh.places[mesh.triangles[t + i]];
            const glm::dvec2& b = mesh.places[mesh.triangles[t + (i + 1) % 3]];
            const glm::dvec2& c = mesh.places[mesh.triangles[t + (i + 2) % 3]];
            // An edge that is half of one, or that lies across from one between two halves.
            reason = std::max({reason, excess(a, 2.0 * b - a, view, detail, coarsening),
                               excess(2.0 * a - b, b, view, detail, coarsening),
                               excess(c + a - b, c + b - a, view, detail, coarsening)});
        }
        if (!still) least = std::min(least, reason);
    }
    return least;
}

// A view with these waves.
SheetView onWaves(SheetView view, const WaveModel& waves)
{
    view.waves.amplitude = waves.getAmplitude();
    view.waves.shortestEdge = waves.getShortestLength() / 8.0;
    view.waves.chordErrors = ChordErrors(waves, view.waves.shortestEdge);
    return view;
}

std::vector<SheetView> manyViews()
{
    std::vector<SheetView> views = {
        viewFrom({0, 0, 1.7}, {10, 3, 1.0}),   // from a bank
        viewFrom({3, -80, 20}, {0, 0, 0}),     // from a hill
        viewFrom({1, 2, 60}, {1, 2, 0}),       // straight down
        viewFrom({0, 0, -3}, {5, 5, 0}),       // from below
        viewFrom({-30, 0, 0}, {10, 1, 0}),     // level with it
        viewFrom({0, 0, 0.02}, {0, 10, 0.01}), // within the waves
        viewFrom({12, 9, 2}, {20, 25, 30}),    // up and away
        orthographicView(20.0),
    };
    SheetView mirrored = viewFrom({3, -80, 20}, {0, 0, 0});
    mirrored.clipFromEye[0][0] *= -1.0;
    views.push_back(mirrored);
    return views;
}

} // namespace

// Falls when middle() makes a new corner for each side of an edge, or tooLong takes its edges as
// the triangles run (a, b) with a bound that rounds differently.
TEST_CASE("divided water is watertight, and its shores stay where they were")
{
    for (const osg::ref_ptr<StillWater>& water : {lake(100.0), star(60.0)})
    {
        int number = 0;
        for (const SheetView& view : manyViews())
        {
            INFO("view " << number++);
            const Mesh mesh = divide(*water, view);
            checkWatertight(*water, mesh, &view);
        }
    }
}

// Falls when divide() drops one of its triangles.
TEST_CASE("where all of the water is in view, none of it is lost")
{
    for (const osg::ref_ptr<StillWater>& water : {lake(10.0), star(6.0)})
        for (const SheetView& view :
             {viewFrom({0, -20, 12}, {0, 0, 0}), viewFrom({0, 0, 25}, {0, 0, 0}),
              viewFrom({3, -20, -12}, {0, 0, 0})})
        {
            const Mesh mesh = divide(*water, view);
            CHECK(mesh.triangles.size() > 20 * water->triangles().size());
            checkWatertight(*water, mesh);
            // Corners are rounded to single precision, each triangle's area with them.
            CHECK(areaOf(mesh.places, mesh.triangles) ==
                  Approx(areaOf(water->corners(), water->triangles())).epsilon(1e-6));
            double smallest = 1.0;
            for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
                smallest = std::min(smallest, signedArea(mesh.places[mesh.triangles[i]],
                                                         mesh.places[mesh.triangles[i + 1]],
                                                         mesh.places[mesh.triangles[i + 2]]));
            CHECK(smallest > 0.0); // none is turned over
        }
}

// Falls when outside has bits of corners that a wave may bring back (reach = 0), or `&` of the
// corners becomes `|`.
TEST_CASE("every point of the water that is in view is in the mesh")
{
    osg::ref_ptr<StillWater> water = star(60.0);
    std::mt19937 random(31);
    std::uniform_real_distribution<double> anywhere(-60.0, 60.0);
    int seen = 0;
    for (SheetView view : manyViews())
    {
        view.waves.amplitude = 3.0; // brings much into view that the still water would not
        const Mesh mesh = divide(*water, view);
        const auto covered = [](const std::vector<glm::dvec2>& places,
                                const std::vector<unsigned int>& triangles, const glm::dvec2& p)
        {
            for (std::size_t i = 0; i < triangles.size(); i += 3)
            {
                const glm::dvec2& a = places[triangles[i]];
                const glm::dvec2& b = places[triangles[i + 1]];
                const glm::dvec2& c = places[triangles[i + 2]];
                // A little inside counts: corners are rounded.
                const double slack = -1e-5;
                if (signedArea(a, b, p) > slack && signedArea(b, c, p) > slack &&
                    signedArea(c, a, p) > slack)
                    return true;
            }
            return false;
        };
        for (int i = 0; i < 400; ++i)
        {
            const glm::dvec2 p(anywhere(random), anywhere(random));
            if (!covered(water->corners(), water->triangles(), p)) continue;
            bool inView = false;
            for (double height : {-view.waves.amplitude, 0.0, view.waves.amplitude})
            {
                const glm::dvec4 clip =
                    view.clipFromEye * view.eyeFromSurface * glm::dvec4(p, height, 1.0);
                inView = inView ||
                         (clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w);
            }
            if (!inView) continue;
            ++seen;
            CHECK(covered(mesh.places, mesh.triangles, p));
        }
    }
    CHECK(seen > 200);
}

// Falls when tooLong measures from the edge's first end only.
TEST_CASE("no edge is longer on screen than asked, unless a wave needs no shorter one")
{
    for (const osg::ref_ptr<StillWater>& water : {lake(100.0), star(60.0)})
        for (double maxEdgePixels : {8.0, 16.0, 100.0})
        {
            SurfaceDetail detail;
            detail.maxEdgePixels = maxEdgePixels;
            detail.maxVertices = 10000000;
            int number = 0;
            for (const SheetView& view : manyViews())
            {
                INFO("view " << number++ << ", " << maxEdgePixels << " pixels");
                const Mesh mesh = divide(*water, view, detail);
                // Corners are rounded.
                CHECK(largestExcess(mesh, view, detail) < 1.01);
            }
        }
}

// Falls when tooLong leaves out a condition, the error is that of a length twice or half as large,
// or it is taken in eye space units.
TEST_CASE("no edge is strayed from too far on screen, and none was halved without need")
{
    for (double steepness : {0.05, 0.3})
        for (double maxErrorPixels : {0.1, 0.5, 4.0})
        {
            const osg::ref_ptr<TrochoidalWaves> waves =
                TrochoidalWaves::createBreeze(4.0, steepness);
            SurfaceDetail detail;
            detail.maxErrorPixels = maxErrorPixels;
            detail.maxVertices = 10000000;
            for (const osg::ref_ptr<StillWater>& water : {lake(200.0), star(60.0)})
            {
                int number = 0;
                for (const SheetView& still : manyViews())
                {
                    INFO("view " << number++ << ", " << maxErrorPixels << " pixels, steepness "
                                 << steepness);
                    const SheetView view = onWaves(still, *waves);
                    const Mesh mesh = divide(*water, view, detail);
                    checkWatertight(*water, mesh, &view);
                    // Corners are rounded.
                    CHECK(largestExcess(mesh, view, detail) < 1.01);
                    CHECK(leastReason(mesh, *water, view, detail) > 0.99);
                }
            }
        }
}

// Falls when the coarsening lengthens edges by its square, or leaves out the error.
TEST_CASE("where the ceiling on vertices is met, all edges may be longer by one factor")
{
    const osg::ref_ptr<StillWater> water = lake(1000.0);
    const osg::ref_ptr<TrochoidalWaves> waves = TrochoidalWaves::createBreeze(4.0, 0.3);
    SurfaceDetail detail;
    detail.maxErrorPixels = 0.02;
    const SheetView view = onWaves(viewFrom({0, 0, 1.7}, {10, 0, 1.0}), *waves);
    detail.maxVertices = 1500;
    osg::ref_ptr<WaveMesh> mesh = new WaveMesh;
    mesh->update(*water, view, detail);
    const Mesh coarse = read(*mesh);
    const double coarsening = mesh->coarsening();
    CHECK(coarsening > 1.5);
    CHECK(coarse.places.size() <= 1500);
    CHECK(coarse.places.size() > 1500 / 2);
    CHECK(largestExcess(coarse, view, detail, coarsening) < 1.01);
    CHECK(leastReason(coarse, *water, view, detail, coarsening) > 0.99);
}

// Falls when maxErrorPixels is not asked for: 7377, 21,759 and 21,841.
TEST_CASE("low waves far away need few vertices")
{
    const osg::ref_ptr<StillWater> water = lake(1000.0);
    const auto count = [&](const SheetView& view, double steepness)
    {
        const osg::ref_ptr<TrochoidalWaves> waves = TrochoidalWaves::createBreeze(2.0, steepness);
        return divide(*water, onWaves(view, *waves)).places.size();
    };
    // From 100 m a pixel is 17 cm and more; these waves stray 3 mm from any edge.
    CHECK(count(viewFrom({0, -400, 100}, {0, 0, 0}), 0.05) == 4);
    // From a bank a pixel is 8 mm and more.
    CHECK(count(viewFrom({0, -400, 1.7}, {0, 0, 0}), 0.05) < 200);
    CHECK(count(viewFrom({0, -400, 1.7}, {0, 0, 0}), 0.3) < 2000);
}

// Edges of a large sheet are far from an eye over its middle. Falls when tooLong takes the error
// where the edge is nearest, and not the triangle.
TEST_CASE("waves near the eye are followed however far the shores are")
{
    for (double size : {100.0, 1000.0, 10000.0})
    {
        const osg::ref_ptr<TrochoidalWaves> waves = TrochoidalWaves::createBreeze(2.0, 0.3);
        const SheetView view =
            onWaves(viewFrom({0.11 * size, -0.4 * size, 1.7}, {0.11 * size, 0, 0}), *waves);
        const Mesh mesh = divide(*lake(size), view);
        INFO(size << " m");
        std::size_t near = 0;
        for (const glm::dvec2& place : mesh.places)
            near += glm::distance(place, glm::dvec2(0.11 * size, 6.0 - 0.4 * size)) < 2.0;
        CHECK(near > 20);
    }
}

// Falls when SurfaceDetail's default is 32 pixels.
TEST_CASE("a lake of a kilometre keeps waves of half a metre near the eye")
{
    osg::ref_ptr<StillWater> water = lake(1000.0);
    const SheetView view = viewFrom({0, 0, 1.5}, {2, 1, 0.0}, 0.5);
    const Mesh mesh = divide(*water, view);
    CHECK(mesh.places.size() < 60000);
    double longest = 0.0;
    for (const auto& edge : edgesOf(mesh.triangles))
    {
        const glm::dvec2& a = mesh.places[edge.first.first];
        const glm::dvec2& b = mesh.places[edge.first.second];
        // 16 pixels at 640 x 480 and 46 degrees are an eighth of half a metre 2.2 m away.
        const glm::dvec3 eye(0, 0, 1.5);
        if (glm::distance(eye, glm::dvec3(a, 0)) < 2.2 ||
            glm::distance(eye, glm::dvec3(b, 0)) < 2.2)
            longest = std::max(longest, glm::distance(a, b));
    }
    CHECK(longest > 0.01);
    CHECK(longest <= 0.5 / 8.0 * 1.0001);
}

// Falls when update() does not coarsen (`division.run(10000000)`), or never goes back.
TEST_CASE("the ceiling on vertices is kept, and the mesh is fine again when there is room")
{
    osg::ref_ptr<StillWater> water = lake(1000.0);
    SurfaceDetail detail;
    detail.maxEdgePixels = 4.0;
    detail.maxVertices = 5000;
    osg::ref_ptr<WaveMesh> mesh = new WaveMesh;
    const SheetView demanding = viewFrom({0, 0, 1.7}, {10, 0, 1.0});
    mesh->update(*water, demanding, detail);
    CHECK(read(*mesh).places.size() <= 5000);
    CHECK(mesh->coarsening() > 1.5);
    // No more than it takes: a step finer would not do.
    CHECK(read(*mesh).places.size() > 5000 / 2);
    checkWatertight(*water, read(*mesh), &demanding);
    CHECK(largestExcess(read(*mesh), demanding, detail, mesh->coarsening()) < 1.01);

    // Looking at the sky, nothing is asked for.
    mesh->update(*water, viewFrom({0, 0, 1.7}, {0.1, 0, 100.0}), detail);
    CHECK(mesh->coarsening() == 1.0);
    mesh->update(*water, demanding, detail);
    CHECK(read(*mesh).places.size() <= 5000);
    // And with room again, in the same view.
    detail.maxVertices = 10000000;
    mesh->update(*water, demanding, detail);
    CHECK(mesh->coarsening() == 1.0);
    CHECK(largestExcess(read(*mesh), demanding, detail) < 1.01);
}

// Falls when the coarsening does not lengthen _shortestEdge too: it then never ends.
TEST_CASE("an eye in the water's plane, at a corner or on a shore ends the division")
{
    osg::ref_ptr<StillWater> water = lake(100.0);
    SurfaceDetail detail;
    detail.maxVertices = 1000;
    for (double waveLength : {0.5, 1e-9, 0.0})
        for (const glm::dvec3& eye : {glm::dvec3(-50, -50, 0), glm::dvec3(-50, 10, 0),
                                      glm::dvec3(7, 3, 0), glm::dvec3(0, 0, 0)})
            for (const glm::dvec3& centre :
                 {glm::dvec3(60, 60, 0), glm::dvec3(0.001, 0, -20), glm::dvec3(-70, -60, 3)})
            {
                const Mesh mesh = divide(*water, viewFrom(eye, centre, waveLength), detail);
                CHECK(mesh.places.size() <= 1000);
            }
    // Waves without a length, or without a shortest one, need no division.
    const double inf = std::numeric_limits<double>::infinity();
    CHECK(divide(*water, viewFrom({0, 0, 2}, {5, 5, 0}, inf)).places.size() == 4);

    // An outline with more corners than the ceiling is drawn as it is, and comes to an end too.
    Outline round;
    for (int i = 0; i < 1500; ++i)
        round.push_back(
            osg::Vec3(50 * std::cos(i * osg::PI / 750), 50 * std::sin(i * osg::PI / 750), 0));
    osg::ref_ptr<StillWater> pond = sheetOf(WaterSurface::createPolygon(round));
    osg::ref_ptr<WaveMesh> mesh = new WaveMesh;
    mesh->update(*pond, viewFrom({50, 0, 0}, {0, 0, 0}), detail);
    CHECK(read(*mesh).places.size() == pond->corners().size());
    // No edge is longer than 100 m, 1600 times what these waves need.
    CHECK(mesh->coarsening() < 1600.0 * 1.25);
    // The same mesh is fine again once it may be.
    detail.maxVertices = 10000000;
    mesh->update(*pond, viewFrom({50, 0, 5}, {0, 0, 0}), detail);
    CHECK(mesh->coarsening() == 1.0);
}

// Falls when update() returns early whatever changed, or SheetView::operator== leaves a member out.
TEST_CASE("the mesh is divided anew when the view, the detail or the sheet changes, only then")
{
    osg::ref_ptr<StillWater> water = lake(100.0);
    osg::ref_ptr<WaveMesh> mesh = new WaveMesh;
    SheetView view = viewFrom({0, -20, 5}, {0, 0, 0});
    SurfaceDetail detail;
    mesh->update(*water, view, detail);
    const auto revision = [&] { return mesh->geometry()->getVertexArray()->getModifiedCount(); };
    unsigned int last = revision();
    mesh->update(*water, view, detail);
    CHECK(revision() == last);
    const auto changes = [&](const char* what)
    {
        INFO(what);
        mesh->update(*water, view, detail);
        CHECK(revision() != last);
        last = revision();
    };
    view.viewportWidth = 320.0;
    changes("viewportWidth");
    view.viewportHeight = 200.0;
    changes("viewportHeight");
    view.waves.amplitude = 0.3;
    changes("amplitude");
    view.waves.shortestEdge = 0.3;
    changes("shortestEdge");
    for (int column = 0; column < 4; ++column)
        for (int row : {0, 1, 3})
        {
            view.clipFromEye[column][row] += 0.1;
            changes("clipFromEye");
        }
    view.eyeFromSurface[3][0] += 1.0;
    changes("eyeFromSurface");
    detail.maxEdgePixels = 9.0;
    changes("maxEdgePixels");
    detail.maxErrorPixels = 0.7;
    changes("maxErrorPixels");
    const osg::ref_ptr<TrochoidalWaves> waves = TrochoidalWaves::createBreeze(4.0, 0.3);
    view.waves.chordErrors = ChordErrors(*waves, view.waves.shortestEdge);
    changes("chordErrors");
    // OpenSceneGraph fits the near and far planes anew in every frame.
    for (int column = 0; column < 4; ++column)
        view.clipFromEye[column][2] += 0.1;
    mesh->update(*water, view, detail);
    CHECK(revision() == last);
    water = lake(99.0);
    changes("the sheet");
}

TEST_CASE("print how long the division takes", "[.time]")
{
    osg::ref_ptr<StillWater> water = lake(1000.0);
    SurfaceDetail detail;
    detail.maxEdgePixels = 9.1;
    detail.maxVertices = 10000000;
    osg::ref_ptr<WaveMesh> mesh = new WaveMesh;
    double best = 1e9;
    for (int i = 0; i < 50; ++i)
    {
        const auto start = std::chrono::steady_clock::now();
        mesh->update(*water, viewFrom({0.1 * i, 0, 1.7}, {0.1 * i, 10, 0.5}), detail);
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        best = std::min(best, time.count());
    }
    std::printf("%u vertices, %.2f ms\n", mesh->geometry()->getVertexArray()->getNumElements(),
                1e3 * best);
}

// StillWater takes the sheets from drawables; WaveMesh divides them for a view.

#include "support/Catch.h"
#include "support/Refusals.h"
#include "support/SurfaceShape.h"

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
#include <map>
#include <random>

using namespace osgWaterReflect;

namespace
{

using Outline = WaterSurface::Outline;

osg::ref_ptr<StillWater> sheetOf(WaterSurface* made)
{
    osg::ref_ptr<WaterSurface> water = made;
    REQUIRE(water);
    REQUIRE(water->getNumDrawables() == 1);
    return StillWater::create(*water->getDrawable(0));
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

// A view of the sheet: the surface frame of these flat lakes is the local one.
SheetView viewFrom(const glm::dvec3& eye, const glm::dvec3& centre, double waveLength = 0.5,
                   double amplitude = 0.02)
{
    SheetView view;
    view.viewportWidth = 640.0;
    view.viewportHeight = 480.0;
    view.clipFromEye = glm::perspective(glm::radians(46.0), 640.0 / 480.0, 0.1, 2000.0);
    const glm::dvec3 along = glm::normalize(centre - eye);
    const glm::dvec3 up = std::abs(along.z) > 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    view.eyeFromSurface = glm::lookAt(eye, centre, up);
    view.amplitude = amplitude;
    view.shortestEdge = waveLength / 8.0;
    return view;
}

SheetView orthographicView(double halfHeight)
{
    SheetView view = viewFrom(glm::dvec3(0, -50, 30), glm::dvec3(0, 0, 0));
    const double halfWidth = halfHeight * 640.0 / 480.0;
    view.clipFromEye = glm::ortho(-halfWidth, halfWidth, -halfHeight, halfHeight, -1000.0, 1000.0);
    return view;
}

struct Mesh
{
    std::vector<glm::dvec2> places; // surface space
    std::vector<unsigned int> triangles;
};

Mesh read(const WaveMesh& waveMesh)
{
    Mesh mesh;
    const auto& vertices = static_cast<osg::Vec3Array&>(*waveMesh.geometry()->getVertexArray());
    const auto& indices =
        static_cast<osg::DrawElementsUInt&>(*waveMesh.geometry()->getPrimitiveSet(0));
    bool sound = true;
    for (const osg::Vec3& vertex : vertices)
    {
        sound =
            sound && std::isfinite(vertex.x()) && std::isfinite(vertex.y()) && vertex.z() == 0.0f;
        mesh.places.push_back(glm::dvec2(vertex.x(), vertex.y()) + waveMesh.anchor());
    }
    mesh.triangles.assign(indices.begin(), indices.end());
    REQUIRE(mesh.triangles.size() % 3 == 0);
    for (unsigned int index : mesh.triangles)
        sound = sound && index < mesh.places.size();
    REQUIRE(sound);
    return mesh;
}

Mesh divide(const StillWater& water, const SheetView& view, const SurfaceDetail& detail = {})
{
    osg::ref_ptr<WaveMesh> mesh = new WaveMesh;
    mesh->update(water, view, detail);
    return read(*mesh);
}

double signedArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

double areaOf(const std::vector<glm::dvec2>& places, const std::vector<unsigned int>& triangles)
{
    double area = 0.0;
    for (std::size_t i = 0; i < triangles.size(); i += 3)
        area +=
            signedArea(places[triangles[i]], places[triangles[i + 1]], places[triangles[i + 2]]);
    return area;
}

double distanceToSegment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b)
{
    const double s = glm::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::distance(p, a + s * (b - a));
}

// Edges with their number of triangles in either direction.
std::map<std::pair<unsigned int, unsigned int>, int> edgesOf(const std::vector<unsigned int>& t)
{
    std::map<std::pair<unsigned int, unsigned int>, int> edges;
    for (std::size_t i = 0; i < t.size(); i += 3)
        for (int j = 0; j < 3; ++j)
            ++edges[{t[i + j], t[i + (j + 1) % 3]}];
    return edges;
}

// Checks that edges belong to two triangles that run along it in opposite directions, and those of
// one triangle lie on the still outline. With parts outside the view left out, edges of one
// triangle may also lie wholly beside the view.
void checkWatertight(const StillWater& water, const Mesh& mesh, const SheetView* view = nullptr)
{
    // The outline: edges of the still sheet with one triangle.
    std::vector<std::pair<glm::dvec2, glm::dvec2>> outline;
    const auto still = edgesOf(water.triangles());
    for (const auto& edge : still)
        if (!still.count({edge.first.second, edge.first.first}))
            outline.push_back(
                {water.corners()[edge.first.first], water.corners()[edge.first.second]});

    const auto edges = edgesOf(mesh.triangles);
    int offOutline = 0;
    int doubled = 0;
    for (const auto& edge : edges)
    {
        doubled += edge.second != 1;
        if (edges.count({edge.first.second, edge.first.first})) continue;
        const glm::dvec2& a = mesh.places[edge.first.first];
        const glm::dvec2& b = mesh.places[edge.first.second];
        // Vertices are single precision about the anchor.
        const double tolerance = 1e-6 * (1.0 + glm::length(a) + glm::length(b));
        bool explained = false;
        for (const auto& side : outline)
            explained = explained || (distanceToSegment(a, side.first, side.second) < tolerance &&
                                      distanceToSegment(b, side.first, side.second) < tolerance);
        if (!explained && view)
        {
            // Beyond the same side of the view, raised or lowered.
            for (int axis = 0; axis < 3 && !explained; ++axis)
                for (double sign : {-1.0, 1.0})
                {
                    bool beyond = true;
                    for (const glm::dvec2& place : {a, b})
                        for (double height : {-view->amplitude, view->amplitude})
                        {
                            const glm::dvec4 clip = view->clipFromEye * view->eyeFromSurface *
                                                    glm::dvec4(place, height, 1.0);
                            const double other = axis < 2 ? sign * clip[axis] : 0.0;
                            beyond = beyond && clip.w + other < 1e-6;
                        }
                    explained = explained || beyond;
                }
        }
        offOutline += !explained;
    }
    CHECK(doubled == 0);
    CHECK(offOutline == 0);
}

// The longest edge over what it may be: maxEdgePixels face on at the nearest point of the edge,
// but never below the shortest edge.
double longestOverBound(const Mesh& mesh, const SheetView& view, double maxEdgePixels)
{
    // Pixels of a length of 1 seen face on at a depth of 1; in orthographic views at any.
    const bool orthographic = view.clipFromEye[2][3] == 0.0;
    const double pixels = std::max(0.5 * view.viewportWidth * view.clipFromEye[0][0],
                                   0.5 * view.viewportHeight * view.clipFromEye[1][1]);
    double worst = 0.0;
    for (const auto& edge : edgesOf(mesh.triangles))
    {
        const glm::dvec3 a =
            view.eyeFromSurface * glm::dvec4(mesh.places[edge.first.first], 0.0, 1.0);
        const glm::dvec3 b =
            view.eyeFromSurface * glm::dvec4(mesh.places[edge.first.second], 0.0, 1.0);
        // Sampled, to share nothing with the division.
        double nearest = std::min(glm::length(a), glm::length(b));
        for (int i = 1; i < 8; ++i)
            nearest = std::min(nearest, glm::length(glm::mix(a, b, i / 8.0)));
        const double bound =
            std::max(view.shortestEdge, maxEdgePixels / pixels * (orthographic ? 1.0 : nearest));
        worst = std::max(worst, glm::distance(a, b) / bound);
    }
    return worst;
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
        view.amplitude = 3.0; // brings much into view that the still water would not
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
            for (double height : {-view.amplitude, 0.0, view.amplitude})
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
                // The nearest point is sampled: up to 1 % further. Corners are rounded.
                CHECK(longestOverBound(mesh, view, maxEdgePixels) < 1.01);
            }
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
    CHECK(longestOverBound(read(*mesh), demanding, 4.0 * mesh->coarsening()) <
          1.01 * mesh->coarsening());

    // Looking at the sky, nothing is asked for.
    mesh->update(*water, viewFrom({0, 0, 1.7}, {0.1, 0, 100.0}), detail);
    CHECK(mesh->coarsening() == 1.0);
    mesh->update(*water, demanding, detail);
    CHECK(read(*mesh).places.size() <= 5000);
    // And with room again, in the same view.
    detail.maxVertices = 10000000;
    mesh->update(*water, demanding, detail);
    CHECK(mesh->coarsening() == 1.0);
    CHECK(longestOverBound(read(*mesh), demanding, 4.0) < 1.01);
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
    view.amplitude = 0.3;
    changes("amplitude");
    view.shortestEdge = 0.3;
    changes("shortestEdge");
    view.clipFromEye[0][0] *= 1.1;
    changes("clipFromEye");
    view.eyeFromSurface[3][0] += 1.0;
    changes("eyeFromSurface");
    detail.maxEdgePixels = 9.0;
    changes("maxEdgePixels");
    water = lake(99.0);
    changes("the sheet");
}

// Falls when create() keeps triangles with a corner twice.
TEST_CASE("triangles without an area and corners given twice make no difference")
{
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    for (const osg::Vec3& v : {osg::Vec3(0, 0, 1), osg::Vec3(4, 0, 1), osg::Vec3(4, 4, 1),
                               osg::Vec3(0, 4, 1), osg::Vec3(4, 4, 1), osg::Vec3(0, 0, 1)})
        vertices->push_back(v);
    geometry->setVertexArray(vertices);
    osg::ref_ptr<osg::DrawElementsUInt> indices = new osg::DrawElementsUInt(GL_TRIANGLES);
    for (unsigned int i : {0, 1, 2, 5, 4, 3, 0, 5, 1, 2, 2, 2, 4, 1, 2})
        indices->push_back(i);
    geometry->addPrimitiveSet(indices);
    osg::ref_ptr<StillWater> water = StillWater::create(*geometry);
    REQUIRE(water);
    CHECK(water->corners().size() == 4);
    CHECK(water->triangles().size() == 6);
    const SheetView view = viewFrom({2, -6, 9}, {2, 2, 0});
    const Mesh mesh = divide(*water, view);
    checkWatertight(*water, mesh, &view);
    CHECK(areaOf(mesh.places, mesh.triangles) == Approx(16.0).epsilon(1e-6));

    // Nothing but such triangles, nothing finite, nothing at all: no sheet.
    indices->clear();
    CHECK_FALSE(StillWater::create(*geometry));
    for (unsigned int i : {0, 1, 1, 2, 4, 2})
        indices->push_back(i);
    CHECK_FALSE(StillWater::create(*geometry));
    vertices->assign(3, osg::Vec3(1, 2, 3));
    vertices->back().x() = std::numeric_limits<float>::quiet_NaN();
    indices->clear();
    for (unsigned int i : {0, 1, 2})
        indices->push_back(i);
    CHECK_FALSE(StillWater::create(*geometry));
    CHECK_FALSE(StillWater::create(*new osg::Geometry));
}

// Falls when offPlane is never compared, or `area` is the first triangle's alone.
TEST_CASE("a drawable that is not plane is laid in its mean plane, with a message")
{
    Refusals refusals;
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    for (const osg::Vec3& v :
         {osg::Vec3(0, 0, 1), osg::Vec3(4, 0, 0), osg::Vec3(4, 4, 1), osg::Vec3(0, 4, 0)})
        vertices->push_back(v);
    geometry->setVertexArray(vertices);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_FAN, 0, 4));
    osg::ref_ptr<StillWater> water = StillWater::create(*geometry);
    REQUIRE(water);
    CHECK(isRefusalOf("WaterSurface", refusals.take()));
    // Raised and lowered corners cancel: the mean plane is level.
    CHECK(water->localFromSurface()[2][2] == Approx(1.0));
    CHECK(std::abs(water->localFromSurface()[3][2] - 0.5) < 0.2);
}

// Falls when computeBound leaves out the waves, or localBound the amplitude.
TEST_CASE("the water's bound holds its waves, tilted water's too")
{
    osg::ref_ptr<TrochoidalWaves> waves = TrochoidalWaves::createBreeze(20.0, 0.9);
    const double amplitude = waves->getAmplitude();
    REQUIRE(amplitude > 0.3);
    for (const osg::Vec3& width : {osg::Vec3(0, 10, 0), osg::Vec3(0, 6, 8)})
    {
        osg::ref_ptr<WaterSurface> water =
            WaterSurface::createRectangle(osg::Vec3(1, 2, 3), osg::Vec3(10, 0, 0), width);
        const double calmRadius = water->getBound().radius();
        water->setWaves(waves);
        osg::Vec3 normal = osg::Vec3(10, 0, 0) ^ width;
        normal.normalize();
        const osg::BoundingSphere bound = water->getBound();
        const osg::BoundingBox box = water->getBoundingBox();
        for (double s : {-0.5, 0.5})
            for (double t : {-0.5, 0.5})
                for (double height : {-amplitude, amplitude})
                {
                    const osg::Vec3 p =
                        osg::Vec3(1, 2, 3) + osg::Vec3(10, 0, 0) * s + width * t + normal * height;
                    CHECK((p - bound.center()).length() <= bound.radius() * 1.00001);
                    osg::BoundingBox larger = box;
                    larger.expandBy(p);
                    CHECK(larger.radius() <= box.radius() * 1.00001);
                }
        water->setWaves(nullptr);
        CHECK(water->getBound().radius() == Approx(calmRadius));
    }
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

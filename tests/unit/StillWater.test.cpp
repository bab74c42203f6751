// StillWater takes the sheets from drawables; their bounds hold the waves.

#include "support/Catch.h"
#include "support/DividedWater.h"
#include "support/Refusals.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/WaterSurface>
#include <osgWaterReflect/surface/ConvexHull.h>
#include <osgWaterReflect/surface/StillWater.h>

#include <osgUtil/Optimizer>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace osgWaterReflect;
using namespace dividedWater;

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
    const auto sheets = StillWater::createSheets(*geometry);
    REQUIRE(sheets.size() == 1);
    const osg::ref_ptr<StillWater> water = sheets[0];
    CHECK(water->corners().size() == 4);
    CHECK(water->triangles().size() == 6);
    const SheetView view = viewFrom({2, -6, 9}, {2, 2, 0});
    const Mesh mesh = divide(*water, view);
    checkWatertight(*water, mesh, &view);
    CHECK(areaOf(mesh.places, mesh.triangles) == Approx(16.0).epsilon(1e-6));

    // Nothing but such triangles, nothing finite, nothing at all: no sheet.
    indices->clear();
    CHECK(StillWater::createSheets(*geometry).empty());
    for (unsigned int i : {0, 1, 1, 2, 4, 2})
        indices->push_back(i);
    CHECK(StillWater::createSheets(*geometry).empty());
    vertices->assign(3, osg::Vec3(1, 2, 3));
    vertices->back().x() = std::numeric_limits<float>::quiet_NaN();
    indices->clear();
    for (unsigned int i : {0, 1, 2})
        indices->push_back(i);
    CHECK(StillWater::createSheets(*geometry).empty());
    const osg::ref_ptr<osg::Geometry> nothing = new osg::Geometry;
    CHECK(StillWater::createSheets(*nothing).empty());
}

// Falls when createSheets() goes on with more than MAX_PLANES, or `area` is the first triangle's
// alone.
TEST_CASE("a curved drawable is laid in its mean plane, with a message")
{
    // Strips of a shallow valley along y, z = (x / 20)^2: as much rises to one side as to the
    // other.
    Refusals refusals;
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    for (int x = -20; x <= 20; ++x)
        for (int y : {10, -10})
            vertices->push_back(osg::Vec3(x, y, x * x / 400.0f));
    geometry->setVertexArray(vertices);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, vertices->size()));
    const auto sheets = StillWater::createSheets(*geometry);
    REQUIRE(sheets.size() == 1);
    CHECK(isRefusalOf("WaterSurface", refusals.take()));
    CHECK(sheets[0]->localFromSurface()[2][2] == Approx(1.0));
    // The mean of x^2 / 400 over the strips' corners, of which the outer ones count half.
    CHECK(std::abs(sheets[0]->localFromSurface()[3][2] - 1.0 / 3.0) < 0.01);
}

// Falls when appendChain() keeps corners on a line (< for <=), or the second chain is left out.
TEST_CASE("a sheet's hull is the smallest convex polygon around its corners")
{
    const auto turn = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
    { return signedArea(a, b, c); };
    std::mt19937 random(1);
    std::uniform_int_distribution<int> coordinate(-6, 6); // many coincide or lie on lines
    for (int count = 3; count < 200; ++count)
    {
        std::vector<glm::dvec2> points;
        for (int i = 0; i < count; ++i)
            points.push_back(glm::dvec2(coordinate(random), coordinate(random)));
        const std::vector<glm::dvec2> hull = convexHull(points);
        for (std::size_t i = 0; i < hull.size() && hull.size() > 2; ++i)
        {
            const glm::dvec2& a = hull[i];
            const glm::dvec2& b = hull[(i + 1) % hull.size()];
            REQUIRE(turn(a, b, hull[(i + 2) % hull.size()]) > 0.0);
            REQUIRE(std::count(points.begin(), points.end(), a) > 0);
            for (const glm::dvec2& point : points)
                REQUIRE(turn(a, b, point) >= 0.0);
        }
    }
    CHECK(convexHull({}).empty());
    CHECK(convexHull({{1, 2}, {1, 2}}).size() == 1);
    CHECK(convexHull({{0, 0}, {2, 2}, {1, 1}}) == std::vector<glm::dvec2>{{0, 0}, {2, 2}});

    // An L of two rectangles: its inner corner is left out.
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    for (const osg::Vec3& v :
         {osg::Vec3(0, 0, 3), osg::Vec3(4, 0, 3), osg::Vec3(4, 1, 3), osg::Vec3(0, 1, 3),
          osg::Vec3(1, 1, 3), osg::Vec3(1, 5, 3), osg::Vec3(0, 5, 3)})
        vertices->push_back(v);
    geometry->setVertexArray(vertices);
    osg::ref_ptr<osg::DrawElementsUInt> indices = new osg::DrawElementsUInt(GL_TRIANGLES);
    for (unsigned int i : {0, 1, 2, 0, 2, 3, 3, 4, 5, 3, 5, 6})
        indices->push_back(i);
    geometry->addPrimitiveSet(indices);
    const auto sheets = StillWater::createSheets(*geometry);
    REQUIRE(sheets.size() == 1);
    CHECK(sheets[0]->hull() == std::vector<glm::dvec2>{{0, 0}, {4, 0}, {4, 1}, {1, 5}, {0, 5}});
}

// Falls when splitByPlane() takes the first triangle's plane for all, or the smallest first.
TEST_CASE("each plane of a drawable is a sheet, so that an optimizer may merge a node's lakes")
{
    const osg::ref_ptr<WaterSurface> water =
        WaterSurface::createRectangle(osg::Vec3(0, 0, 1), osg::Vec3(9, 0, 0), osg::Vec3(0, 9, 0));
    const osg::ref_ptr<WaterSurface> higher = WaterSurface::createRectangle(
        osg::Vec3(20, 0, 1.01f), osg::Vec3(9, 0, 0), osg::Vec3(0, 9, 0));
    const osg::ref_ptr<WaterSurface> tilted =
        WaterSurface::createRectangle(osg::Vec3(40, 0, 1), osg::Vec3(9, 0, 0), osg::Vec3(0, 9, 2));
    water->addDrawable(higher->getDrawable(0));
    water->addDrawable(tilted->getDrawable(0));
    const osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(water);
    osgUtil::Optimizer().optimize(root);
    REQUIRE(water->getNumDrawables() == 1); // else this tests nothing

    const auto sheets = StillWater::createSheets(*water->getDrawable(0));
    REQUIRE(sheets.size() == 3);
    std::vector<double> levels;
    for (const osg::ref_ptr<StillWater>& sheet : sheets)
    {
        const glm::dmat4& frame = sheet->localFromSurface();
        CHECK(sheet->triangles().size() == 6);
        if (frame[2][2] > 0.9999) levels.push_back(frame[3][2]);
    }
    std::sort(levels.begin(), levels.end());
    REQUIRE(levels.size() == 2);
    CHECK(levels[0] == Approx(1.0));
    CHECK(levels[1] == Approx(1.01));
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

// StillWater takes the sheets from drawables; their bounds hold the waves.

#include "support/Catch.h"
#include "support/DividedWater.h"
#include "support/Refusals.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/WaterSurface>
#include <osgWaterReflect/surface/StillWater.h>

#include <cmath>
#include <limits>

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

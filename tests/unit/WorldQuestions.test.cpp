// Where the moving water is, asked in world space.

#include "support/Catch.h"
#include "support/Refusals.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/WaterSurface>

#include <osg/Geometry>
#include <osg/MatrixTransform>

#include <random>

using namespace osgWaterReflect;

namespace
{

osg::ref_ptr<WaterSurface> createWater(double level)
{
    return WaterSurface::createRectangle(osg::Vec3(5, 0, level), osg::Vec3(20, 0, 0),
                                         osg::Vec3(0, 10, 0));
}

osg::ref_ptr<osg::MatrixTransform> put(osg::Node* node, const osg::Matrixd& worldFromLocal)
{
    const osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(worldFromLocal);
    transform->addChild(node);
    return transform;
}

osg::Vec3d unit(osg::Vec3d v)
{
    v.normalize();
    return v;
}

} // namespace

// Breaks where getHeight takes the local height for the world's, getNormal turns normals as points,
// or getSurfacePoint leaves out the height.
TEST_CASE("points, heights and normals of moving water are the model's, wherever the node is put")
{
    const struct
    {
        const char* name;
        osg::Matrixd worldFromLocal;
        double stretch; // of heights
    } cases[] = {
        {"as it is", osg::Matrixd(), 1.0},
        {"far away, turned",
         osg::Matrixd::rotate(0.7, 0.3, 1, 0.2) * osg::Matrixd::translate(3e5, -2e5, 900), 1.0},
        {"twice as large", osg::Matrixd::scale(2, 2, 2) * osg::Matrixd::rotate(0.4, 1, 0, 0), 2.0},
        {"stretched upward", osg::Matrixd::scale(1, 1, 3), 3.0},
        {"stretched aslant", osg::Matrixd::rotate(0.5, 0, 1, 0) * osg::Matrixd::scale(1, 1, 3),
         0.0},
        {"mirrored", osg::Matrixd::scale(-1, 1, 1), 1.0}};
    const osg::ref_ptr<TrochoidalWaves> waves = TrochoidalWaves::createBreeze(2.0, 0.4);
    for (const auto& each : cases)
    {
        INFO(each.name);
        const osg::ref_ptr<WaterSurface> water = createWater(1.5);
        const osg::ref_ptr<WaterSurface> calm = createWater(1.5);
        water->setWaves(waves);
        const osg::ref_ptr<osg::MatrixTransform> world = put(water, each.worldFromLocal);
        const osg::ref_ptr<osg::MatrixTransform> calmWorld = put(calm, each.worldFromLocal);
        const double size = each.worldFromLocal.getTrans().length();
        // Of places in double precision, as far away as that.
        const double rounding = 1e-9 + 1e-14 * size;

        std::mt19937 random(6);
        std::uniform_real_distribution<double> anywhere(-4.0, 4.0);
        for (int i = 0; i < 200; ++i)
        {
            const osg::Vec3d local(anywhere(random), anywhere(random), anywhere(random));
            const osg::Vec3d point = local * each.worldFromLocal;
            const double time = 10.0 * i;
            const osg::Vec3d surface = water->getSurfacePoint(point, time);
            // Surface space is the node's own where the still water is level there.
            const osg::Vec2d place(local.x(), local.y());
            const osg::Vec3d expected =
                osg::Vec3d(local.x(), local.y(), 1.5 + waves->getHeight(place, time)) *
                each.worldFromLocal;
            REQUIRE((surface - expected).length() < rounding);
            const osg::Vec3d inSurface = surface * water->getSurfaceFromWorld(point);
            REQUIRE(inSurface.z() == Approx(waves->getHeight(place, time)).margin(rounding));

            const osg::Vec3d still = calm->getSurfacePoint(point, time);
            const osg::Vec3d up = calm->getNormal(point, time);
            const double height = water->getHeight(point, time);
            REQUIRE(height == Approx((surface - still) * up).margin(rounding));
            if (each.stretch > 0.0)
                REQUIRE(height ==
                        Approx(each.stretch * waves->getHeight(place, time)).margin(rounding));
            REQUIRE(calm->getHeight(point, time) == 0.0);

            // The normal stands on what the points span.
            const double step = 1e-4;
            const osg::Vec3d right = osg::Vec3d(local.x() + step, local.y(), 0);
            const osg::Vec3d ahead = osg::Vec3d(local.x(), local.y() + step, 0);
            const osg::Vec3d normal = water->getNormal(point, time);
            REQUIRE(normal.length() == Approx(1.0));
            for (const osg::Vec3d& beside : {right, ahead})
            {
                const osg::Vec3d there = water->getSurfacePoint(beside * each.worldFromLocal, time);
                // The step, times the curvature: k times the steepness, over (1 - steepness)^3.
                REQUIRE(std::abs(unit(there - surface) * normal) < 0.01);
            }
            REQUIRE(normal * up > 0.0);
        }
    }
}

// Breaks where placeUnder takes the first sheet, or squaredDistance that to the plane.
TEST_CASE(
    "a point belongs to the nearest of a water's sheets, and the sheet goes on beyond its edge")
{
    // Two pools at different levels, and a weir between them.
    const osg::ref_ptr<WaterSurface> water = new WaterSurface;
    const auto addSheet = [&](const osg::Vec3& corner, const osg::Vec3& x, const osg::Vec3& y)
    { water->addDrawable(osg::createTexturedQuadGeometry(corner, x, y)); };
    addSheet(osg::Vec3(-20, 0, 5), osg::Vec3(20, 0, 0), osg::Vec3(0, 10, 0));
    addSheet(osg::Vec3(4, 0, 1), osg::Vec3(20, 0, 0), osg::Vec3(0, 10, 0));
    addSheet(osg::Vec3(0, 0, 5), osg::Vec3(4, 0, -4), osg::Vec3(0, 10, 0));
    const osg::ref_ptr<osg::MatrixTransform> world = put(water, osg::Matrixd::translate(100, 0, 0));
    const auto surfaceAt = [&](double x, double y, double z)
    { return water->getSurfacePoint(osg::Vec3d(100 + x, y, z), 0.0); };

    CHECK(surfaceAt(-10, 5, 6).z() == Approx(5.0));
    CHECK(surfaceAt(-10, 5, -6).z() == Approx(5.0)); // however deep it is under it
    CHECK(surfaceAt(10, 5, 1.2).z() == Approx(1.0));
    CHECK(surfaceAt(60, 5, 3).z() == Approx(1.0));
    CHECK(surfaceAt(-60, 50, 3).z() == Approx(5.0));
    CHECK((surfaceAt(2, 5, 3) - osg::Vec3d(102, 5, 3)).length() < 1e-5);
    CHECK((water->getNormal(osg::Vec3d(102, 5, 3), 0.0) - unit(osg::Vec3d(1, 0, 1))).length() <
          1e-6);
}

// Breaks where placeUnder says nothing, or says it each time.
TEST_CASE("water without a sheet is refused an answer once, and taken to lie at its origin")
{
    Refusals refusals;
    const osg::ref_ptr<WaterSurface> water = new WaterSurface;
    water->setWaves(TrochoidalWaves::createBreeze(2.0, 0.1));
    CHECK(water->getSurfaceFromWorld(osg::Vec3d(1, 2, 3)) == osg::Matrixd());
    CHECK(isRefusalOf("WaterSurface::getSurfaceFromWorld", refusals.take()));
    CHECK(water->getSurfaceFromWorld(osg::Vec3d(1, 2, 3)) == osg::Matrixd());
    CHECK(refusals.take().empty());
}

// WaterSurface::createRectangle and createPolygon.

#include "support/Catch.h"
#include "support/Refusals.h"
#include "support/SurfaceShape.h"

#include <osgWaterReflect/WaterSurface>
#include <osgWaterReflect/surface/StillWater.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace osgWaterReflect;
using Outline = WaterSurface::Outline;

namespace
{

// Areas are of single-precision corners.
const double ROUNDING = 1e-5;

std::vector<osg::Vec3d> trianglesOf(const WaterSurface& water)
{
    REQUIRE(water.getNumDrawables() == 1);
    return ::trianglesOf(*water.getDrawable(0));
}

void checkShape(WaterSurface* made, const osg::Vec3d& normal, double area)
{
    osg::ref_ptr<WaterSurface> water = made;
    REQUIRE(water);
    const std::vector<osg::Vec3d> triangles = trianglesOf(*water);
    const osg::Vec3d vector = areaVectorOf(triangles);
    CHECK(vector.length() == Approx(area).epsilon(ROUNDING));
    CHECK(areaOf(triangles) == Approx(area).epsilon(ROUNDING)); // none overlaps or faces back
    CHECK((vector / vector.length() - normal).length() < 1e-5);

    // The sheet's frame: rigid, its z along the normal, its x the local x laid into the plane.
    REQUIRE(water->getNumDrawables() == 1);
    const auto sheets = StillWater::createSheets(*water->getDrawable(0));
    REQUIRE(sheets.size() == 1);
    const glm::dmat4& frame = sheets[0]->localFromSurface();
    const osg::Vec3d x(frame[0][0], frame[0][1], frame[0][2]);
    const osg::Vec3d y(frame[1][0], frame[1][1], frame[1][2]);
    const osg::Vec3d z(frame[2][0], frame[2][1], frame[2][2]);
    const osg::Vec3d origin(frame[3][0], frame[3][1], frame[3][2]);
    CHECK((z - normal).length() < 1e-5);
    CHECK(((x ^ y) - z).length() < 1e-12);
    CHECK(x.length() == Approx(1.0).epsilon(1e-12));
    CHECK(std::abs(x * y) < 1e-12);
    const osg::Vec3d along = std::abs(normal.x()) < 0.9 ? osg::Vec3d(1, 0, 0) : osg::Vec3d(0, 1, 0);
    CHECK(along * y == Approx(0.0).margin(1e-6));
    CHECK(along * x > 0.0);
    // The origin is the foot of the local origin: straight above it along the normal.
    CHECK((origin ^ z).length() < 1e-9 * (1.0 + origin.length()));
}

Outline reversed(Outline outline)
{
    std::reverse(outline.begin(), outline.end());
    return outline;
}

Outline moved(Outline outline, const osg::Matrixd& matrix)
{
    for (osg::Vec3& corner : outline)
        corner = corner * matrix;
    return outline;
}

// A C, open to the right: 3 by 3 less 2 by 1.
const Outline CONCAVE = {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0},
                         {1, 2, 0}, {3, 2, 0}, {3, 3, 0}, {0, 3, 0}};
const Outline SQUARE = {{-5, -5, 2}, {5, -5, 2}, {5, 5, 2}, {-5, 5, 2}};
const Outline ISLAND = {{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}};
const Outline ISLET = {{2, 2, 2}, {4, 2, 2}, {3, 4, 2}};

} // namespace

// Falls when createRectangle swaps two of its corners, or centres by the whole of a side.
TEST_CASE("a rectangle lies about its centre, its top on the side of length ^ width")
{
    checkShape(
        WaterSurface::createRectangle(osg::Vec3(1, 2, 3), osg::Vec3(4, 0, 0), osg::Vec3(0, 6, 0)),
        osg::Vec3d(0, 0, 1), 24.0);
    checkShape(
        WaterSurface::createRectangle(osg::Vec3(1, 2, 3), osg::Vec3(0, 6, 0), osg::Vec3(4, 0, 0)),
        osg::Vec3d(0, 0, -1), 24.0);
    // Tilted and vertical, with x close to the normal.
    checkShape(
        WaterSurface::createRectangle(osg::Vec3(-9, 2, 7), osg::Vec3(3, 0, 4), osg::Vec3(0, 2, 0)),
        osg::Vec3d(-0.8, 0, 0.6), 10.0);
    checkShape(
        WaterSurface::createRectangle(osg::Vec3(5, 0, 0), osg::Vec3(0, 2, 0), osg::Vec3(0, 0, 3)),
        osg::Vec3d(1, 0, 0), 6.0);
    osg::ref_ptr<WaterSurface> water =
        WaterSurface::createRectangle(osg::Vec3(1, 2, 3), osg::Vec3(4, 0, 0), osg::Vec3(0, 6, 0));
    CHECK((water->getBound().center() - osg::Vec3(1, 2, 3)).length() < 1e-6);
}

// Falls when createPolygon keeps `normal` of a clockwise outline.
TEST_CASE("a polygon's top is upward, whichever way its outline runs")
{
    for (const Outline& outline : {CONCAVE, reversed(CONCAVE)})
    {
        checkShape(WaterSurface::createPolygon(outline), osg::Vec3d(0, 0, 1), 7.0);
        const osg::Matrixd tilt =
            osg::Matrixd::rotate(1.0, osg::Vec3d(1, 0, 0)) * osg::Matrixd::translate(3, 4, 5);
        checkShape(WaterSurface::createPolygon(moved(outline, tilt)),
                   osg::Vec3d(0, -std::sin(1.0), std::cos(1.0)), 7.0);
        // Turned past the vertical: the other side is up.
        const osg::Matrixd over = osg::Matrixd::rotate(2.0, osg::Vec3d(1, 0, 0));
        checkShape(WaterSurface::createPolygon(moved(outline, over)),
                   osg::Vec3d(0, std::sin(2.0), -std::cos(2.0)), 7.0);
    }
}

TEST_CASE("a vertical polygon's top is where its outline runs counter clockwise")
{
    const osg::Matrixd upright = osg::Matrixd::rotate(osg::PI_2, osg::Vec3d(1, 0, 0));
    checkShape(WaterSurface::createPolygon(moved(CONCAVE, upright)), osg::Vec3d(0, -1, 0), 7.0);
    checkShape(WaterSurface::createPolygon(moved(reversed(CONCAVE), upright)), osg::Vec3d(0, 1, 0),
               7.0);
}

// Falls when the winding rule is TESS_WINDING_NONZERO and a hole runs as the outline does.
TEST_CASE("islands are left out of a lake, whichever way they run")
{
    for (const Outline& outline : {SQUARE, reversed(SQUARE)})
        for (const Outline& island : {ISLAND, reversed(ISLAND)})
        {
            checkShape(WaterSurface::createPolygon(outline, {island, ISLET}), osg::Vec3d(0, 0, 1),
                       100.0 - 4.0 - 2.0);
            // No water at the island's middle.
            osg::ref_ptr<WaterSurface> lake = WaterSurface::createPolygon(outline, {island});
            const std::vector<osg::Vec3d> triangles = trianglesOf(*lake);
            const osg::Vec3d middle(0.1, 0.2, 2.0);
            for (std::size_t i = 0; i < triangles.size(); i += 3)
            {
                bool inside = true;
                for (int j = 0; j < 3; ++j)
                    inside = inside && ((triangles[i + (j + 1) % 3] - triangles[i + j]) ^
                                        (middle - triangles[i + j]))
                                               .z() > 0.0;
                CHECK_FALSE(inside);
            }
        }
}

// Falls when NO_AREA is 0: rounded corners in line then count as an area.
TEST_CASE("what spans no water is refused, by name, and null is returned")
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    Refusals refusals;
    const auto refusedRectangle =
        [&](const osg::Vec3& centre, const osg::Vec3& length, const osg::Vec3& width)
    {
        CHECK_FALSE(WaterSurface::createRectangle(centre, length, width));
        const std::string message = refusals.take();
        INFO(message);
        CHECK(isRefusalOf("WaterSurface::createRectangle", message));
    };
    const osg::Vec3 x(1, 0, 0);
    const osg::Vec3 y(0, 1, 0);
    for (float bad : {nan, inf, -inf})
    {
        refusedRectangle(osg::Vec3(0, bad, 0), x, y);
        refusedRectangle(osg::Vec3(), osg::Vec3(bad, 0, 0), y);
        refusedRectangle(osg::Vec3(), x, osg::Vec3(0, 0, bad));
    }
    refusedRectangle(osg::Vec3(), osg::Vec3(), y);
    refusedRectangle(osg::Vec3(), x, osg::Vec3());
    refusedRectangle(osg::Vec3(), x, x * -3.0f);
    refusedRectangle(osg::Vec3(), osg::Vec3(0.1f, 0.3f, 0.7f), osg::Vec3(0.3f, 0.9f, 2.1f));

    const auto refusedPolygon = [&](const Outline& outline, const std::vector<Outline>& holes)
    {
        CHECK_FALSE(WaterSurface::createPolygon(outline, holes));
        const std::string message = refusals.take();
        INFO(message);
        CHECK(isRefusalOf("WaterSurface::createPolygon", message));
    };
    const std::vector<Outline> bad = {
        {},
        {x, y},
        {x, y, osg::Vec3(0, nan, 0)},
        {x, y, osg::Vec3(inf, 0, 0)},
        {x, x, x},
        {osg::Vec3(0.1f, 0.3f, 0), osg::Vec3(0.3f, 0.9f, 0), osg::Vec3(0.7f, 2.1f, 0)},
    };
    for (const Outline& outline : bad)
    {
        refusedPolygon(outline, {});
        refusedPolygon(SQUARE, {outline});
        refusedPolygon(SQUARE, {ISLAND, outline});
    }
    // Small and far from the origin is no reason to refuse.
    checkShape(
        WaterSurface::createRectangle(osg::Vec3(), osg::Vec3(1e-3f, 0, 0), osg::Vec3(0, 1e-3f, 0)),
        osg::Vec3d(0, 0, 1), 1e-6);
    CHECK(refusals.take().empty());
}

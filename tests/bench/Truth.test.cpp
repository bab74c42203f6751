// The true places that the benchmark measures against, where they are known in closed form.

#include "WallCase.h"
#include "support/Catch.h"
#include "support/Scenes.h"

#include <osgwaterbench/measures/Fresnel.h>
#include <osgwaterbench/measures/SightLine.h>

#include <osg/Geometry>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

using namespace osgwaterbench;
using osgWaterReflect::reference::SceneTracer;

namespace
{

bool everywhere(const glm::dvec3&)
{
    return true;
}

std::size_t pixelNumber(const DrawnWater& drawn, int x, int y)
{
    return static_cast<std::size_t>(y) * drawn.width() + x;
}

// What a water pixel reflects of a small square about a place, with a normal that sends the ray
// there.
ReflectedPlace reflectionOf(const DrawnWater& drawn, std::size_t pixel, const glm::dvec3& place)
{
    const glm::dvec3 water = waterPoint(drawn, pixel);
    const glm::dvec3 way = glm::normalize(place - water);
    const glm::dvec3 across = 0.5 * glm::normalize(glm::cross(way, glm::dvec3(0.3, 0.2, 0.9)));
    const glm::dvec3 upward = glm::cross(across, way);
    const glm::dvec3 corner = place - 0.5 * (across + upward);
    const osg::ref_ptr<osg::Node> square = scenes::createQuad(
        osg::Vec3(corner.x, corner.y, corner.z), osg::Vec3(across.x, across.y, across.z),
        osg::Vec3(upward.x, upward.y, upward.z), osg::Vec4(1, 1, 1, 1));
    const SceneTracer scene(*square);

    const glm::dvec3 wayEye(drawn.eyeFromWorld * glm::dvec4(way, 0.0));
    const glm::dvec3& pointEye = drawn.pointEye[pixel];
    return ReflectionTracer(drawn, scene)
        .trace(pointEye, glm::normalize(wayEye - sightDirEye(drawn, pointEye)));
}

// A ball in triangles, none of which is farther from it than radius * (pi / rings)^2.
osg::ref_ptr<osg::Geometry> createBall(const osg::Vec3d& centre, double radius, int rings)
{
    osg::ref_ptr<osg::Vec3dArray> corners = new osg::Vec3dArray;
    osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    for (int ring = 0; ring <= rings; ++ring)
        for (int i = 0; i <= 2 * rings; ++i)
        {
            const double polar = osg::PI * ring / rings;
            const double azimuth = osg::PI * i / rings;
            corners->push_back(centre + osg::Vec3d(std::sin(polar) * std::cos(azimuth),
                                                   std::sin(polar) * std::sin(azimuth),
                                                   std::cos(polar)) *
                                            radius);
            if (ring == rings || i == 2 * rings) continue;
            const unsigned int a = ring * (2 * rings + 1) + i;
            const unsigned int b = a + 2 * rings + 1;
            for (unsigned int corner : {a, b, b + 1, a, b + 1, a + 1})
                triangles->push_back(corner);
        }
    osg::ref_ptr<osg::Geometry> ball = new osg::Geometry;
    ball->setVertexArray(corners);
    ball->addPrimitiveSet(triangles);
    return ball;
}

} // namespace

// Falls when the ray starts a metre late (NEAREST), when the normal is not the drawn one.
TEST_CASE("truth: calm water shows a wall where the eye's mirror image sees it")
{
    const WallCase wall;
    REQUIRE(wall.truth.size() == waterPixels(wall.drawn).size());
    int visible = 0;
    double farthest = 0.0;       // [m]
    double farthestWindow = 0.0; // [pixels]
    double farthestColour = 0.0;
    for (const TruePixel& own : wall.truth)
    {
        const glm::dvec3 place = wall.mirrored(own.pixel);
        const bool onWall = wall.onWall(place);
        CHECK(own.reflected.trueClass == (onWall ? TrueClass::VISIBLE : TrueClass::SKY));
        const glm::dvec3 colour = onWall ? wall.colour : wall.skyColour;
        farthestColour = std::max(farthestColour, glm::distance(own.reflectedColour, colour));
        if (!onWall) continue;
        ++visible;
        farthest = std::max(farthest, glm::distance(own.reflected.placeWorld, place));
        const glm::dvec3 seen =
            placeAtWindow(wall.drawn, own.reflected.window, 1.0) - wall.view.eye;
        farthestWindow = std::max(farthestWindow,
                                  glm::distance(wall.beside(place, glm::dvec2(0.0)),
                                                wall.view.eye + seen * (wall.distance / seen.y)));
    }
    CHECK(visible > 1000);
    CHECK(farthest < 1e-9); // roundings of double precision over 20 m, magnified at grazing sight
    CHECK(farthestWindow < 1e-9);
    CHECK(farthestColour < 1e-7); // vertex colours are in single precision
}

TEST_CASE("truth: every n-th pixel is the whole truth's")
{
    const WallCase wall;
    const Truth some = findTruth(wall.drawn, wall.world, 3);
    CHECK(some.size() > wall.truth.size() / 10);
    std::size_t i = 0;
    for (const TruePixel& own : wall.truth)
    {
        const std::size_t width = wall.drawn.width();
        if (own.pixel % width % 3 != 0 || own.pixel / width % 3 != 0) continue;
        REQUIRE(i < some.size());
        CHECK(some[i].pixel == own.pixel);
        CHECK(some[i].reflected.placeWorld == own.reflected.placeWorld);
        ++i;
    }
    CHECK(i == some.size());
}

// Falls when the water's own colour and what it reflects are exchanged in mix().
TEST_CASE("truth: the water's colour is mixed by Fresnel's formulas")
{
    const WallCase wall;
    double farthest = 0.0;
    for (const TruePixel& own : wall.truth)
    {
        // By the angles [Born99 1.5.2].
        const glm::dvec3 way = waterPoint(wall.drawn, own.pixel) - wall.view.eye;
        const double incident = std::acos(-way.z / glm::length(way));
        const double refracted = std::asin(std::sin(incident) / 1.333);
        const double perpendicular =
            std::sin(incident - refracted) / std::sin(incident + refracted);
        const double parallel = std::tan(incident - refracted) / std::tan(incident + refracted);
        const double share = 0.5 * (perpendicular * perpendicular + parallel * parallel);
        const glm::dvec3 reflected =
            wall.onWall(wall.mirrored(own.pixel)) ? wall.colour : wall.skyColour;
        const glm::dvec3 expected =
            (1.0 - share) * glm::dvec3(0.02, 0.08, 0.09) + share * reflected;
        farthest = std::max(farthest, glm::distance(own.shadedColour, expected));
    }
    CHECK(farthest < 1e-7); // colours are given in single precision
}

TEST_CASE("truth: reflectance at angles where it is known")
{
    const double n = 1.333;
    CHECK(reflectance(1.0, n) == Approx((n - 1) / (n + 1) * (n - 1) / (n + 1)));
    CHECK(reflectance(0.0, n) == Approx(1.0));
    // At Brewster's angle, whose tangent is n, only perpendicular light is reflected.
    const double perpendicular = (n * n - 1) / (n * n + 1);
    CHECK(reflectance(1.0 / std::sqrt(1 + n * n), n) ==
          Approx(0.5 * perpendicular * perpendicular));
    CHECK(reflectance(0.4, 1.0) == Approx(0.0).margin(1e-15));
}

// Falls when hidden places are called visible, and when the clearance is a tenth of the distance.
TEST_CASE("truth: calm water shows a ball's underside, which the eye does not see")
{
    const ViewAhead view{{0.0, 0.0, 4.0}, 22.0, 40.0, 320, 240};
    const DrawnWater drawn = drawStillWater(view, everywhere);
    const glm::dvec3 centre(0.0, 10.0, 1.6);
    const double radius = 1.0;
    const int rings = 400;
    const osg::ref_ptr<osg::Node> ball =
        createBall(osg::Vec3d(centre.x, centre.y, centre.z), radius, rings);
    const SceneTracer scene(*ball);
    const SkyLookup sky(glm::dvec3(0.0));
    const double sagitta = radius * std::pow(osg::PI / rings, 2.0); // [m] of the triangles

    int counts[TRUE_CLASS_COUNT] = {};
    int atOutline = 0;
    double worst = 0.0;
    for (const TruePixel& own : findTruth(drawn, {scene, sky, {}}))
    {
        const glm::dvec3 water = waterPoint(drawn, own.pixel);
        glm::dvec3 dir = glm::normalize(water - view.eye);
        dir.z = -dir.z;
        const double toMiddle = glm::dot(centre - water, dir);
        const double beside = glm::distance(water + toMiddle * dir, centre);
        // A ray that grazes the ball is told by its triangles.
        if (std::abs(beside - radius) < 0.02)
        {
            ++atOutline;
            continue;
        }
        if (beside > radius)
        {
            CHECK(own.reflected.trueClass == TrueClass::SKY);
            ++counts[static_cast<int>(TrueClass::SKY)];
            continue;
        }
        const glm::dvec3 met =
            water + (toMiddle - std::sqrt(radius * radius - beside * beside)) * dir;
        const double cosIncident = glm::dot(centre - met, dir) / radius;
        worst = std::max(worst, glm::distance(met, own.reflected.placeWorld) * cosIncident);
        const double cosToEye = glm::dot(met - centre, glm::normalize(view.eye - met)) / radius;
        // A line of sight that ends so flat lies in the ball for less than the clearance.
        if (std::abs(cosToEye) < 0.02)
        {
            ++atOutline;
            continue;
        }
        const TrueClass expected = cosToEye > 0.0 ? TrueClass::VISIBLE : TrueClass::HIDDEN;
        CHECK(own.reflected.trueClass == expected);
        ++counts[static_cast<int>(expected)];
    }
    CHECK(worst < 2.0 * sagitta);
    for (TrueClass some : {TrueClass::SKY, TrueClass::VISIBLE, TrueClass::HIDDEN})
        CHECK(counts[static_cast<int>(some)] > 100);
    CHECK(atOutline < 500);
}

TEST_CASE("truth: over an empty scene there is only sky")
{
    const DrawnWater drawn = drawStillWater(ViewAhead(), everywhere);
    const osg::ref_ptr<osg::Node> nothing = new osg::Group;
    const SceneTracer scene(*nothing);
    const SkyLookup sky(glm::dvec3(0.1, 0.2, 0.3));
    const Truth truth = findTruth(drawn, {scene, sky, {}});
    CHECK(truth.size() > 1000);
    for (const TruePixel& own : truth)
    {
        CHECK(own.reflected.trueClass == TrueClass::SKY);
        CHECK(glm::distance(own.reflectedColour, glm::dvec3(0.1, 0.2, 0.3)) < 1e-7);
    }
}

// Falls when the upper edge is asked for first, whatever the ray's image passes.
TEST_CASE("truth: beyond the image the edge counts that the ray's image passes first")
{
    const ViewAhead view; // 160 x 120 pixels; border pixels' centres at 0.5, 159.5 and 119.5
    const DrawnWater drawn = drawStillWater(view, everywhere);
    const struct
    {
        int x, y;       // of the water pixel
        glm::dvec2 end; // [pixels] window of the place
        TrueClass expected;
    } cases[] = {
        {80, 30, {100, 110}, TrueClass::VISIBLE},
        {80, 30, {100, 119.4}, TrueClass::VISIBLE},
        {80, 30, {100, 119.6}, TrueClass::OUTSIDE_TOP},
        {80, 30, {100, 150}, TrueClass::OUTSIDE_TOP},
        {80, 30, {159.6, 80}, TrueClass::OUTSIDE_SIDES},
        {80, 30, {0.4, 80}, TrueClass::OUTSIDE_SIDES},
        {80, 30, {0.6, 80}, TrueClass::VISIBLE},
        // To the right edge 79 of 139.5 px are gone, 0.57; to the upper one 89 of 99.5, 0.89.
        {80, 30, {220, 130}, TrueClass::OUTSIDE_SIDES},
        // 79 of 84.5 are 0.93, 89 of 269.5 are 0.33.
        {80, 30, {165, 300}, TrueClass::OUTSIDE_TOP},
        {80, 30, {-60, 130}, TrueClass::OUTSIDE_SIDES},
        {80, 30, {-5, 300}, TrueClass::OUTSIDE_TOP},
        // From the outermost columns, inward and outward.
        {159, 30, {150, 150}, TrueClass::OUTSIDE_TOP},
        {159, 30, {170, 150}, TrueClass::OUTSIDE_SIDES},
        {0, 30, {10, 150}, TrueClass::OUTSIDE_TOP},
        {0, 30, {-10, 150}, TrueClass::OUTSIDE_SIDES},
    };
    for (const auto& item : cases)
    {
        INFO("from " << item.x << ", " << item.y << " to " << item.end.x << ", " << item.end.y);
        const ReflectedPlace found = reflectionOf(drawn, pixelNumber(drawn, item.x, item.y),
                                                  placeAtWindow(drawn, item.end, 15.0));
        CHECK(found.trueClass == item.expected);
        CHECK(found.window.x == Approx(item.end.x));
        CHECK(found.window.y == Approx(item.end.y));
    }
}

TEST_CASE("truth: what is behind the eye or before the near plane is beyond a side")
{
    const DrawnWater drawn = drawStillWater(ViewAhead(), everywhere);
    const std::size_t pixel = pixelNumber(drawn, 80, 30);
    CHECK(reflectionOf(drawn, pixel, glm::dvec3(0.5, -5.0, 4.0)).trueClass ==
          TrueClass::OUTSIDE_SIDES);
    CHECK(reflectionOf(drawn, pixel, placeAtWindow(drawn, {80.0, 60.0}, 0.05)).trueClass ==
          TrueClass::OUTSIDE_SIDES);
    CHECK(reflectionOf(drawn, pixel, placeAtWindow(drawn, {80.0, 60.0}, 2.0)).trueClass ==
          TrueClass::VISIBLE);
}

// Falls when the second reflection is left out.
TEST_CASE("truth: a ray that a wave sends below the still plane is reflected once more by it")
{
    const DrawnWater drawn = drawStillWater(ViewAhead(), everywhere);
    const glm::dvec3& pointEye = drawn.pointEye[pixelNumber(drawn, 80, 30)];
    const glm::dmat4 worldFromEye = glm::inverse(drawn.eyeFromWorld);
    const glm::dvec3 sight(worldFromEye * glm::dvec4(sightDirEye(drawn, pointEye), 0.0));
    for (double lean : {-0.6, -0.3, 0.0, 0.3}) // of the normal toward +y [rad]
    {
        const glm::dvec3 normal(0.0, std::sin(lean), std::cos(lean));
        const glm::dvec3 normalEye(drawn.eyeFromWorld * glm::dvec4(normal, 0.0));
        const glm::dvec3 reflected(worldFromEye *
                                   glm::dvec4(reflectedDirEye(drawn, pointEye, normalEye), 0.0));
        // In the plane x = 0 a reflection turns the angle over the horizon.
        const double down = std::atan2(sight.z, sight.y);
        const double up = -2.0 * lean - down;
        const glm::dvec3 expected(0.0, std::cos(up), std::abs(std::sin(up)));
        INFO("lean " << lean << ", sin " << std::sin(up));
        CHECK(std::abs(sight.x) < 0.01);
        CHECK(glm::distance(reflected, expected) < 0.01); // the pixel is half a pixel off x = 0
    }
}

// The exhaustive search of a ray in an image, on images whose answer is known in closed form.

#include "support/Catch.h"

#include <osgWaterReflect/reference/ImageTracer.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace osgWaterReflect::reference;

namespace
{

const double NOTHING = std::numeric_limits<double>::infinity();
const double EYE_HEIGHT = 2.0; // [m] over the water
const double NEAR_PLANE = 0.3;
const double FAR_PLANE = 500.0;

ImageGeometry geometryOf(int width, int height)
{
    return {glm::perspective(0.8, double(width) / height, NEAR_PLANE, FAR_PLANE),
            glm::dvec2(width, height)};
}

// Unit direction from the eye through a place of the image.
glm::dvec3 sightThrough(const ImageGeometry& image, const glm::dvec2& window)
{
    return glm::normalize(image.eyeFromWindow(glm::dvec3(window, 0.5)));
}

glm::dvec2 centreOf(int x, int y)
{
    return glm::dvec2(x + 0.5, y + 0.5);
}

// An image of something whose distance along a unit direction from the eye is given.
CapturedImage imageOf(const ImageGeometry& geometry,
                      const std::function<double(const glm::dvec3& sight)>& distance)
{
    CapturedImage image = {geometry, {}};
    for (int y = 0; y < geometry.size.y; ++y)
        for (int x = 0; x < geometry.size.x; ++x)
        {
            const glm::dvec3 sight = sightThrough(geometry, centreOf(x, y));
            const double d = distance(sight);
            const double windowZ = d < NOTHING ? geometry.windowFromEye(d * sight).z : 1.0;
            image.windowZ.push_back(static_cast<float>(std::min(windowZ, 1.0)));
        }
    return image;
}

struct Ray
{
    glm::dvec3 sight; // unit direction from the eye to the origin
    glm::dvec3 origin;
    glm::dvec3 dir;

    glm::dvec3 at(double t) const { return origin + t * dir; }
};

// Calls a function with the ray that calm water reflects at each pixel that it covers. With the
// camera level its image is a part of the pixel's column; rolled, it leans by the angle.
void forEachReflectedRay(const ImageGeometry& image, double rollDegrees,
                         const std::function<void(const Ray&)>& function)
{
    const double roll = glm::radians(rollDegrees);
    const glm::dvec3 up(std::sin(roll), std::cos(roll), 0.0);
    for (int y = 0; y < image.size.y; ++y)
        for (int x = 0; x < image.size.x; ++x)
        {
            const glm::dvec3 sight = sightThrough(image, centreOf(x, y));
            const double fall = -glm::dot(sight, up);
            if (fall * FAR_PLANE <= EYE_HEIGHT) continue; // sky, or water beyond the far plane
            function({sight, sight * (EYE_HEIGHT / fall), sight + 2.0 * fall * up});
        }
}

// Whether an image shows a place, and all pixels that what is seen there is interpolated from.
bool shows(const ImageGeometry& image, const glm::dvec3& placeEye)
{
    const glm::dvec2 window(image.windowFromEye(placeEye));
    return window.x > 1.5 && window.y > 1.5 && window.x < image.size.x - 1.5 &&
           window.y < image.size.y - 1.5;
}

// What rounding windowZ to single precision does to the depth of a place, to first order: windowZ
// in [0.5, 1) is off by 2^-25 at most, and depth d changes by d^2 (far - near) / (far near) of it.
double depthRounding(double depth)
{
    return std::ldexp(1.0, -25) * depth * depth * (FAR_PLANE - NEAR_PLANE) /
           (FAR_PLANE * NEAR_PLANE);
}

// How far along a ray the crossing with a surface moves, where that is moved in depth.
double movedAlong(const Ray& ray, double t, const glm::dvec3& normal, double depthError)
{
    const glm::dvec3 sight = glm::normalize(ray.at(t));
    return depthError * std::abs(glm::dot(normal, sight)) /
           (std::abs(sight.z) * std::abs(glm::dot(normal, ray.dir)));
}

// The larger error; one that is no number is the worst.
double worse(double worst, double error)
{
    if (std::isnan(error)) return std::numeric_limits<double>::infinity();
    return std::max(worst, error);
}

} // namespace

// Walls are planes, and windowZ is linear on planes: what is left is windowZ's rounding. The
// thickness of a millimetre joins no two pixels of the slanted walls: their slope has to.
// Falls when the slope is left out of belongTogether, when the place is taken at `last` instead of
// the crossing (Walk::pass), and when `between` takes pair.first alone.
TEST_CASE("a ray meets a wall where geometry says, by columns and by rows")
{
    const ImageGeometry geometry = geometryOf(160, 120);
    const glm::dvec3 foot(0.0, 0.0, -20.0);
    for (const glm::dvec3& leaning :
         {glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.6, -0.3, 1.0), glm::dvec3(-0.8, 0.4, 1.0)})
        for (double rollDegrees : {0.0, 30.0, 60.0, 90.0, 200.0})
        {
            const glm::dvec3 normal = glm::normalize(leaning);
            const ImageTracer tracer(
                imageOf(geometry, [&](const glm::dvec3& sight)
                        { return glm::dot(normal, foot) / glm::dot(normal, sight); }),
                0.001);
            int met = 0;
            int wrongReason = 0;
            double worst = 0.0;
            forEachReflectedRay(geometry, rollDegrees,
                                [&](const Ray& ray)
                                {
                                    const double t = glm::dot(normal, foot - ray.origin) /
                                                     glm::dot(normal, ray.dir);
                                    if (glm::dot(normal, ray.origin - foot) <= 0.0)
                                        return; // hidden by the wall
                                    if (!(t > 0.0) || !shows(geometry, ray.at(t))) return;
                                    const ImageHit hit = tracer.trace(ray.origin, ray.dir);
                                    ++met;
                                    wrongReason += !hit.found() || hit.atEdge;
                                    const double bound =
                                        movedAlong(ray, t, normal, depthRounding(-ray.at(t).z));
                                    worst = worse(worst, std::abs(hit.t - t) / bound);
                                });
            INFO("wall " << leaning.x << ", rolled by " << rollDegrees << " degrees: " << met
                         << " rays, error over bound " << worst);
            CHECK(met > 1000);
            CHECK(wrongReason == 0);
            CHECK(worst < 1.05); // the bound is of first order, and at the hit's own depth
        }
}

// Falls when a hit's t is linear in s (Segment::tAt without the division by w).
TEST_CASE("a hit's pixels, windowZ and length along the ray are one place")
{
    const ImageGeometry geometry = geometryOf(160, 120);
    const ImageTracer tracer(
        imageOf(geometry, [](const glm::dvec3& sight) { return 20.0 / -sight.z; }), 0.5);
    double worst = 0.0;
    forEachReflectedRay(geometry, 30.0,
                        [&](const Ray& ray)
                        {
                            const ImageHit hit = tracer.trace(ray.origin, ray.dir);
                            const glm::dvec3 place = geometry.windowFromEye(ray.at(hit.t));
                            worst = worse(worst,
                                          glm::length(place - glm::dvec3(hit.window, hit.windowZ)));
                        });
    CHECK(worst < 1e-9); // [pixels] double precision, with room for its loss near the far plane
}

// Where a ball faces both eye and ray, the chords between pixel centres lie behind it by no more
// than their height: of one pixel's length along a column, and of 2^(1/2) between two.
// Falls when a piece's end is taken half way though the surface goes on (`belongTogether` false
// in trace).
TEST_CASE("a ray meets a ball, and one beside it the sky")
{
    const ImageGeometry geometry = geometryOf(320, 240);
    const double radius = 2.0;
    const double pixelSide = 2.0 * std::tan(0.4) / 240.0; // at unit depth
    for (double rollDegrees : {0.0, 40.0, 90.0})
    {
        const double roll = glm::radians(rollDegrees);
        const glm::dvec3 up(std::sin(roll), std::cos(roll), 0.0);
        const glm::dvec3 centre = 1.0 * up + glm::dvec3(0.0, 0.0, -12.0);
        const auto distance = [&](const glm::dvec3& origin, const glm::dvec3& dir)
        {
            const double middle = glm::dot(centre - origin, dir);
            const glm::dvec3 aside = centre - origin - middle * dir;
            const double square = radius * radius - glm::dot(aside, aside);
            return square > 0.0 && middle > 0.0 ? middle - std::sqrt(square) : NOTHING;
        };
        const ImageTracer tracer(imageOf(geometry, [&](const glm::dvec3& sight)
                                         { return distance(glm::dvec3(0.0), sight); }),
                                 0.5);
        int met = 0;
        int missed = 0;
        int wrongReason = 0;
        double worst = 0.0;
        forEachReflectedRay(
            geometry, rollDegrees,
            [&](const Ray& ray)
            {
                if (distance(glm::dvec3(0.0), ray.sight) < glm::length(ray.origin)) return;
                const ImageHit hit = tracer.trace(ray.origin, ray.dir);

                // The plane of the ray and the eye passes the ball by two pixels: so does its
                // image.
                const glm::dvec3 beside = glm::normalize(glm::cross(ray.sight, ray.dir));
                if (std::abs(glm::dot(beside, centre)) > radius + 2.0 * 14.0 * pixelSide)
                {
                    ++missed;
                    wrongReason +=
                        shows(geometry, ray.dir) ? hit.reason != ImageReason::SKY : hit.found();
                    return;
                }

                const double t = distance(ray.origin, ray.dir);
                if (t == NOTHING || !shows(geometry, ray.at(t))) return;
                const glm::dvec3 normal = (ray.at(t) - centre) / radius;
                const double cosSight = -glm::dot(normal, glm::normalize(ray.at(t)));
                if (cosSight < 0.5 || -glm::dot(normal, ray.dir) < 0.3) return;
                ++met;
                wrongReason += !hit.found() || hit.atEdge;
                const double side = -ray.at(t).z * pixelSide;
                // The slope at the far end of the chords.
                const double steepest =
                    cosSight - 1.5 * side / radius * std::sqrt(1.0 / (cosSight * cosSight) - 1.0);
                const double chords = 3.0 / 8.0 * side * side / (radius * std::pow(steepest, 3.0));
                const double bound =
                    movedAlong(ray, t, normal, chords + depthRounding(-ray.at(t).z));
                worst = worse(worst, std::abs(hit.t - t) / bound);
            });
        INFO("rolled by " << rollDegrees << " degrees: " << met << " met, " << missed
                          << " missed, error over bound " << worst);
        CHECK(met > 500);
        CHECK(missed > 5000);
        CHECK(wrongReason == 0);
        CHECK(worst < 1.0);
    }
}

// Level, the image ends of reflected rays lie as far above the horizon as the water below it.
// Falls when the far plane is left out of segmentOf.
TEST_CASE("in an empty image a level eye's reflected rays all end in the sky, at the far plane")
{
    const ImageGeometry geometry = geometryOf(160, 120);
    const ImageTracer tracer(imageOf(geometry, [](const glm::dvec3&) { return NOTHING; }), 0.5);
    int rays = 0;
    int other = 0;
    double worst = 0.0;
    forEachReflectedRay(geometry, 0.0,
                        [&](const Ray& ray)
                        {
                            // Border rows and columns lead along the border.
                            if (!shows(geometry, ray.dir)) return;
                            ++rays;
                            const ImageHit end = tracer.trace(ray.origin, ray.dir);
                            other += end.reason != ImageReason::SKY;
                            worst = worse(worst, std::abs(-ray.at(end.t).z - FAR_PLANE));
                        });
    CHECK(rays > 8000);
    CHECK(other == 0);
    CHECK(worst < 1e-9 * FAR_PLANE); // double precision, with room for far / near
}

// The bar hangs across the image, nearer than any water; rays come from below. Its image ends half
// way between its last row and the wall's first. Falls when _inFront stays true behind the edge
// (Walk::pass: no `_inFront = false`), when the thickness is not looked at (`_atEdge = true`),
// and when a surface that ends does so at its last centre (`middle = surfaceBefore.s`).
TEST_CASE("a bar ahead is passed behind, and hides what ends behind it")
{
    const ImageGeometry geometry = geometryOf(160, 120);
    const double barDepth = 3.0;
    const double wallDepth = 20.0;
    const auto isBar = [&](const glm::dvec3& sight)
    {
        const double height = barDepth * sight.y / -sight.z;
        return height > 0.3 && height < 0.6;
    };
    const CapturedImage image =
        imageOf(geometry, [&](const glm::dvec3& sight)
                { return (isBar(sight) ? barDepth : wallDepth) / -sight.z; });
    double lowest = 0.0; // the bar's image [pixels]
    double highest = 0.0;
    for (int y = 0; y < 120; ++y)
        if (isBar(sightThrough(geometry, centreOf(80, y))))
        {
            if (lowest == 0.0) lowest = y;
            highest = y + 1;
        }
    const glm::dvec3 lowestSight = sightThrough(geometry, glm::dvec2(80.5, lowest));
    const double lowestSlope = lowestSight.y / -lowestSight.z;

    // Within the second thickness, behind the bar, come the nearer of the rays.
    for (double thickness : {0.5, 10.0})
    {
        const ImageTracer tracer(image, thickness);
        int below = 0;
        int above = 0;
        int hidden = 0;
        int atEdge = 0;
        int wrong = 0;
        forEachReflectedRay(geometry, 0.0,
                            [&](const Ray& ray)
                            {
                                if (-ray.origin.z >= wallDepth) return;
                                const ImageHit hit = tracer.trace(ray.origin, ray.dir);
                                const double tWall = (-wallDepth - ray.origin.z) / ray.dir.z;
                                const double tEdge = (-lowestSlope * ray.origin.z - ray.origin.y) /
                                                     (ray.dir.y + lowestSlope * ray.dir.z);
                                const double yWall = geometry.windowFromEye(ray.at(tWall)).y;
                                // A millimetre: the wall's windowZ is rounded by 0.04 mm, and no
                                // ray meets it or passes below the edge at less than three degrees.
                                const auto is = [&](ImageReason reason, bool edge, double t) {
                                    return hit.reason == reason && hit.atEdge == edge &&
                                           std::abs(hit.t - t) < 1e-3;
                                };
                                if (yWall < lowest)
                                {
                                    ++below;
                                    wrong += !is(ImageReason::HIT, false, tWall);
                                }
                                else if (-ray.at(tEdge).z - barDepth <= thickness)
                                {
                                    ++atEdge;
                                    wrong += !is(ImageReason::HIT, true, tEdge);
                                }
                                else if (yWall < highest)
                                {
                                    ++hidden;
                                    wrong += !is(ImageReason::BEHIND, false, tEdge);
                                }
                                else
                                {
                                    ++above;
                                    wrong += !is(ImageReason::HIT, false, tWall);
                                }
                            });
        INFO("thickness " << thickness << ": " << below << " below, " << above << " above, "
                          << hidden << " hidden, " << atEdge << " at the edge");
        CHECK(below > 100);
        CHECK(hidden > 100);
        CHECK((thickness < 1.0 ? above : atEdge) > 100);
        CHECK((thickness < 1.0 ? atEdge == 0 : true));
        CHECK(wrong == 0);
    }
}

// Reflected at normal incidence the ray comes back; beside that it leaves through the side that its
// pixel lies toward, except right under the eye. Falls when the near plane is left out of
// segmentOf, and when LEFT and RIGHT change places there.
TEST_CASE("looking straight down, rays leave by the side that they lean to, or toward the eye")
{
    const int size = 61;
    const double height = 10.0;
    const ImageGeometry geometry = geometryOf(size, size);
    const ImageTracer tracer(imageOf(geometry, [](const glm::dvec3&) { return NOTHING; }), 0.5);
    // Where the larger coordinate reaches the border, 1 - 1 / size, just at the near plane.
    const double depthAtNear = NEAR_PLANE / height;
    const double centreZone = (1.0 - 1.0 / size) * depthAtNear / (2.0 - depthAtNear);
    int towardEye = 0;
    int wrong = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
        {
            const glm::dvec2 ndc = centreOf(x, y) * 2.0 / double(size) - 1.0;
            const double larger = std::max(std::abs(ndc.x), std::abs(ndc.y));
            const bool isCentre = larger < 1e-9;
            const bool diagonal = std::abs(std::abs(ndc.x) - std::abs(ndc.y)) < 1e-9;
            if (diagonal && !isCentre) continue; // two reasons hold at once
            const glm::dvec3 sight = sightThrough(geometry, centreOf(x, y));
            const ImageHit end =
                tracer.trace(sight * (height / -sight.z), glm::dvec3(sight.x, sight.y, -sight.z));
            const ImageReason expected =
                larger < centreZone ? ImageReason::TOWARD_EYE
                : std::abs(ndc.x) > std::abs(ndc.y)
                    ? (ndc.x < 0.0 ? ImageReason::LEFT : ImageReason::RIGHT)
                    : (ndc.y < 0.0 ? ImageReason::BOTTOM : ImageReason::TOP);
            towardEye += end.reason == ImageReason::TOWARD_EYE;
            wrong += end.reason != expected;
        }
    CHECK(towardEye == 1);
    CHECK(wrong == 0);
}

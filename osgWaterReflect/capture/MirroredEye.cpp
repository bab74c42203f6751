#include "MirroredEye.h"

#include "../Transforms.h"

#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

using namespace osgWaterReflect;

namespace
{

// [rad], and share of the eye's height over the plane. A plane that is off by either is seen in
// the mirrored image off by twice that: a twentieth of a pixel's 1.8e-3 rad.
const double SAME_PLANE = 4.5e-5;

// Share of the eye's height over the still water by which the floor is never lowered below it: what
// depths cost in precision grows as the floor comes near the mirrored eye, here up to twice.
const double LOWEST_FLOOR = 0.5;

// How far above the mirrored eye the floor stays at least [amplitudes, and world units], for an eye
// at or under the still water's level between waves.
const double LEAST_CLEARANCE = 0.1;
const double LEAST_HEIGHT = 1e-6;

const glm::dmat4 LEFT_FOR_RIGHT = glm::scale(glm::dmat4(1.0), glm::dvec3(-1.0, 1.0, 1.0));

// Reflection in a plane (unit normal and distance).
glm::dmat4 mirrorIn(const glm::dvec4& plane)
{
    const glm::dvec3 normal(plane);
    glm::dmat4 mirror(glm::dmat3(1.0) - 2.0 * glm::outerProduct(normal, normal));
    mirror[3] = glm::dvec4(-2.0 * plane.w * normal, 1.0);
    return mirror;
}

// A plane where a matrix carries its points.
glm::dvec4 carried(const glm::dmat4& matrix, const glm::dvec4& plane)
{
    return glm::transpose(glm::inverse(matrix)) * plane;
}

} // namespace

CaptureEye osgWaterReflect::viewEye(const glm::dmat4& clipFromEye)
{
    return {glm::dmat4(1.0), clipFromEye, std::nullopt};
}

CaptureEye osgWaterReflect::mirroredEye(const glm::dmat4& eyeFromSurface,
                                        const glm::dmat4& clipFromEye, bool above)
{
    const glm::dvec4 heights =
        carried(eyeFromSurface, glm::dvec4(0.0, 0.0, above ? 1.0 : -1.0, 0.0));

    const double unitHeight = 1.0 / glm::length(glm::dvec3(heights));
    CaptureEye eye;
    eye.eyeFromViewEye = LEFT_FOR_RIGHT * mirrorIn(unitHeight * heights);
    eye.clipFromEye = LEFT_FOR_RIGHT * clipFromEye * LEFT_FOR_RIGHT;
    eye.floor = WaterPlane{carried(eye.eyeFromViewEye, unitHeight * heights), unitHeight};
    return eye;
}

bool osgWaterReflect::serveTogether(const CaptureEye& a, const CaptureEye& b)
{
    if (!a.floor || !b.floor) return !a.floor && !b.floor;
    const glm::dvec4 apart = a.floor->plane - b.floor->plane;
    return glm::length(glm::dvec3(apart)) <= SAME_PLANE &&
           std::abs(apart.w) <= SAME_PLANE * std::abs(a.floor->plane.w);
}

ObliqueProjection osgWaterReflect::obliqueProjection(const glm::dmat4& clipFromEye,
                                                     const WaterPlane& floor, double amplitude)
{
    glm::dvec4 plane = floor.plane;
    const double deepest = floor.unitHeight * amplitude;
    const bool orthographic = eyePointOf(clipFromEye).w == 0.0;
    const double clearance =
        std::max({-LOWEST_FLOOR * plane.w, LEAST_CLEARANCE * deepest, LEAST_HEIGHT});
    plane.w = orthographic ? plane.w + deepest : std::min(plane.w + deepest, -clearance);

    // Divided by clip w, the height over the floor is linear in normalised device coordinates. It
    // is what is left of windowZ, over the most that it comes to in the image.
    const glm::dvec4 height = carried(clipFromEye, plane);
    const glm::dvec3 reach = glm::abs(glm::dvec3(height));
    const double highest = reach.x + reach.y + reach.z + height.w;
    const double scale = highest > 0.0 ? highest : 1.0; // all of the view is under the floor

    glm::dmat4 obliqueFromClip(1.0);
    for (int i = 0; i < 4; ++i)
        obliqueFromClip[i].z = 2.0 * height[i] / scale - (i == 3 ? 1.0 : 0.0);
    return {obliqueFromClip * clipFromEye,
            glm::dvec4(-height.x, -height.y, 0.5 * scale,
                       0.5 * (height.x + height.y + height.z - height.w)) /
                height.z};
}

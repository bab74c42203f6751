#ifndef OSGWATERREFLECT_CAPTURE_MIRROREDEYE_H
#define OSGWATERREFLECT_CAPTURE_MIRROREDEYE_H

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <optional>

namespace osgWaterReflect
{

/// Still water as an eye sees it.
struct WaterPlane
{
    glm::dvec4 plane{0.0};   ///< in eye space: unit normal and distance, above 0 on the side seen
    double unitHeight = 1.0; ///< [world units] of a wave that is 1 local unit high
};

/// The eye that a capture is taken from.
struct CaptureEye
{
    glm::dmat4 eyeFromViewEye{1.0}; ///< rigid
    glm::dmat4 clipFromEye{1.0};    ///< near and far are still to be fitted to the scene

    /// In this eye's space. What lies under it is not drawn; the eye itself is there.
    std::optional<WaterPlane> floor;
};

/// The view's own eye.
CaptureEye viewEye(const glm::dmat4& clipFromEye);

/// The view's eye mirrored in a sheet of still water, and turned left for right: so it is a proper
/// rotation of the view's, in which nothing winds the other way, and so is its image.
///   eyeFromSurface  of the sheet
///   above           the eye is over the water as it moves
CaptureEye mirroredEye(const glm::dmat4& eyeFromSurface, const glm::dmat4& clipFromEye, bool above);

/// Whether one capture serves both eyes: to within a twentieth of a pixel of 480 rows over
/// 46 degrees.
bool serveTogether(const CaptureEye& a, const CaptureEye& b);

/// A projection whose near plane is the floor of what rays may meet [Lengyel05], and the way back
/// to the windowZ of the projection that it was made of.
struct ObliqueProjection
{
    glm::dmat4 clipFromEye{1.0};

    /// That windowZ is its dot product with (u, v, oblique windowZ, 1), u and v in [0, 1] over the
    /// image: where depths are divided by clip w, all of them are planes.
    glm::dvec4 straightened{0.0};
};

///   clipFromEye  fitted to the scene; its far plane stays, or moves away
///   amplitude    [local units] of the waves: how far under the still water rays may start
ObliqueProjection obliqueProjection(const glm::dmat4& clipFromEye, const WaterPlane& floor,
                                    double amplitude);

} // namespace osgWaterReflect

#endif

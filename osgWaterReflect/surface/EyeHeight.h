#ifndef OSGWATERREFLECT_SURFACE_EYEHEIGHT_H
#define OSGWATERREFLECT_SURFACE_EYEHEIGHT_H

#include <osgWaterReflect/WaveModel>

#include <glm/mat4x4.hpp>

namespace osgWaterReflect
{

/// Height of the eye over the water as it moves [surface units]; in an orthographic view only its
/// sign means anything.
///   waves  null for calm water
///   time   [s]
double heightOfEye(const glm::dmat4& eyeFromSurface, const glm::dmat4& clipFromEye,
                   const WaveModel* waves, double time);

} // namespace osgWaterReflect

#endif

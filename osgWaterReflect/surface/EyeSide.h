#ifndef OSGWATERREFLECT_SURFACE_EYESIDE_H
#define OSGWATERREFLECT_SURFACE_EYESIDE_H

#include <osgWaterReflect/WaveModel>

#include <glm/mat4x4.hpp>

namespace osgWaterReflect
{

/// +1 where the eye is above the water's surface, -1 where it is below.
///   waves  null for calm water
///   time   [s]
double sideOfEye(const glm::dmat4& eyeFromSurface, const glm::dmat4& clipFromEye,
                 const WaveModel* waves, double time);

} // namespace osgWaterReflect

#endif

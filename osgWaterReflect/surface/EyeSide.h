#ifndef OSGWATERREFLECT_SURFACE_EYESIDE_H
#define OSGWATERREFLECT_SURFACE_EYESIDE_H

#include <osgWaterReflect/WaveState>

#include <glm/mat4x4.hpp>

namespace osgWaterReflect
{

/// Whether the eye is over the water as it moves, or just in it; else it is below.
///   waves      null for calm water
///   amplitude  [surface units] a bound on the waves' height: only within it are they asked
bool isEyeAbove(const glm::dmat4& eyeFromSurface, const glm::dmat4& clipFromEye,
                const WaveState* waves, double amplitude);

} // namespace osgWaterReflect

#endif

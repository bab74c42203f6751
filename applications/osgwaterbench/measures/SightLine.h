#ifndef OSGWATERBENCH_SIGHTLINE_H
#define OSGWATERBENCH_SIGHTLINE_H

#include "Drawn.h"

namespace osgwaterbench
{

/// Unit direction from the eye to a place; in an orthographic view, along it.
glm::dvec3 sightDirEye(const DrawnWater& drawn, const glm::dvec3& pointEye);

/// Unit direction in which the line of sight to a water point is reflected there.
///
/// A ray that a wave sends below the still plane meets water at once. It is followed as reflected
/// once more, by still water: a convention of the model that is measured, not an error of it.
///   normalEye  of unit length, facing the eye
glm::dvec3 reflectedDirEye(const DrawnWater& drawn, const glm::dvec3& pointEye,
                           const glm::dvec3& normalEye);

} // namespace osgwaterbench

#endif

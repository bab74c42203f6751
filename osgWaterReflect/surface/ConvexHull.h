#ifndef OSGWATERREFLECT_SURFACE_CONVEXHULL_H
#define OSGWATERREFLECT_SURFACE_CONVEXHULL_H

#include <glm/vec2.hpp>

#include <vector>

namespace osgWaterReflect
{

/// Corners of the smallest convex polygon around points, counter-clockwise, none of them on a line
/// between its neighbours: two where all points lie on a line, one where they coincide.
std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points);

} // namespace osgWaterReflect

#endif

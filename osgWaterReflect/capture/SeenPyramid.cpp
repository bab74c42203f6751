#include "SeenPyramid.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

using namespace osgWaterReflect;

SeenPyramid::SeenPyramid(const NdcExtent& extent, const glm::dmat4& clipFromEye)
{
    const glm::dmat4 rows = glm::transpose(clipFromEye);
    addSide(rows[0] - extent.left * rows[3], extent.left);
    addSide(extent.right * rows[3] - rows[0], extent.right);
    addSide(rows[1] - extent.bottom * rows[3], extent.bottom);
    addSide(extent.top * rows[3] - rows[1], extent.top);
    addSide(rows[3], 0.0); // before the eye
}

// A side at infinity is none.
void SeenPyramid::addSide(const glm::dvec4& plane, double place)
{
    if (!std::isfinite(place)) return;
    const double length = glm::length(glm::dvec3(plane));
    if (length > 0.0) _sides[_numSides++] = plane / length;
}

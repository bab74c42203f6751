#include "NdcExtent.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

using namespace osgWaterReflect;

NdcExtent NdcExtent::none()
{
    const double inf = std::numeric_limits<double>::infinity();
    return {inf, -inf, inf, -inf};
}

NdcExtent osgWaterReflect::unite(const NdcExtent& a, const NdcExtent& b)
{
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.left, b.left), std::max(a.right, b.right), std::min(a.bottom, b.bottom),
            std::max(a.top, b.top)};
}

NdcExtent osgWaterReflect::intersect(const NdcExtent& a, const NdcExtent& b)
{
    const NdcExtent common = {std::max(a.left, b.left), std::min(a.right, b.right),
                              std::max(a.bottom, b.bottom), std::min(a.top, b.top)};
    return common.empty() ? NdcExtent::none() : common;
}

bool osgWaterReflect::contains(const NdcExtent& outer, const NdcExtent& inner)
{
    return outer.left <= inner.left && outer.right >= inner.right && outer.bottom <= inner.bottom &&
           outer.top >= inner.top;
}

NdcExtent osgWaterReflect::seenExtent(const osg::BoundingBox& boxLocal,
                                      const glm::dmat4& clipFromLocal)
{
    ImageHull hull;
    for (unsigned int i = 0; boxLocal.valid() && i < 8; ++i)
    {
        const osg::Vec3 corner = boxLocal.corner(i);
        const glm::dvec4 clip = clipFromLocal * glm::dvec4(corner.x(), corner.y(), corner.z(), 1.0);
        hull.add({clip.x, clip.y, clip.w});
    }
    return hull.extent();
}

void ImageHull::add(const glm::dvec3& point)
{
    // The comparisons of min and max leave out 0 / 0.
    const glm::dvec2 image = glm::dvec2(point) / std::abs(point.z);
    glm::dvec2& lowest = point.z > 0.0 ? _frontMin : _backMin;
    glm::dvec2& highest = point.z > 0.0 ? _frontMax : _backMax;
    lowest = glm::min(lowest, image);
    highest = glm::max(highest, image);
}

// The line from a point before the eye to one that is not passes the eye's plane on the side that
// the sum of their x / |w| tells, and its image runs to infinity there.
NdcExtent ImageHull::extent() const
{
    // A line that passes the eye itself, but for rounding, has no image to either side.
    const double beside = 1e-9;
    const glm::dvec2 low = _frontMin + _backMin;
    const glm::dvec2 high = _frontMax + _backMax;
    return {low.x < -beside ? -INF : _frontMin.x, high.x > beside ? INF : _frontMax.x,
            low.y < -beside ? -INF : _frontMin.y, high.y > beside ? INF : _frontMax.y};
}

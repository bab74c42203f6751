#ifndef OSGWATERREFLECT_BAND_NDCEXTENT_H
#define OSGWATERREFLECT_BAND_NDCEXTENT_H

#include <osg/BoundingBox>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <limits>

namespace osgWaterReflect
{

/// A rectangle in a view's normalised device coordinates, by default the view itself. Its sides may
/// lie at infinity.
struct NdcExtent
{
    double left = -1.0;
    double right = 1.0;
    double bottom = -1.0;
    double top = 1.0;

    /// A rectangle without a point: it adds nothing to another.
    static NdcExtent none();
    bool empty() const { return !(left <= right && bottom <= top); }
};

/// The smallest rectangle around both.
NdcExtent unite(const NdcExtent& a, const NdcExtent& b);

/// What both have in common; none() where that is nothing.
NdcExtent intersect(const NdcExtent& a, const NdcExtent& b);

/// Whether all of one lies in another.
bool contains(const NdcExtent& outer, const NdcExtent& inner);

/// Where a box may be seen; infinite to the sides on which it passes beside the eye, none() where
/// it lies behind it or is invalid.
NdcExtent seenExtent(const osg::BoundingBox& boxLocal, const glm::dmat4& clipFromLocal);

/// The image of a convex body, spanned by points and directions, as far as it lies before the eye.
class ImageHull
{
public:
    /// A point or, with clip w = 0 or in an endless perspective, a direction: its clip x, y and w.
    void add(const glm::dvec3& point);

    /// none() where nothing lies before the eye.
    NdcExtent extent() const;

private:
    static constexpr double INF = std::numeric_limits<double>::infinity();

    // x / |w| and y / |w| of what lies before the eye (w > 0) and of the rest.
    glm::dvec2 _frontMin{INF};
    glm::dvec2 _frontMax{-INF};
    glm::dvec2 _backMin{INF};
    glm::dvec2 _backMax{-INF};
};

} // namespace osgWaterReflect

#endif

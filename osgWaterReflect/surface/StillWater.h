#ifndef OSGWATERREFLECT_SURFACE_STILLWATER_H
#define OSGWATERREFLECT_SURFACE_STILLWATER_H

#include <osg/BoundingBox>
#include <osg/Drawable>
#include <osg/Geometry>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <vector>

namespace osgWaterReflect
{

/// One sheet of still water, taken from a drawable: a plane, and its outline in triangles.
///
/// Surface space has its z along the still normal (the side from which the triangles run counter
/// clockwise), its x along the local x axis laid into the plane (the local y axis where x is close
/// to the normal), its unit the local unit, and its origin at the foot of the local origin.
/// Immutable; shared by all views.
class StillWater : public osg::Referenced
{
public:
    /// The drawable's sheets, one for each plane that its triangles lie in (osgUtil::Optimizer
    /// merges a node's lakes into one drawable); none where no triangle has an area. More than
    /// MAX_PLANES are a curved surface: it is laid in its mean plane, with a message on OSG_WARN.
    static std::vector<osg::ref_ptr<StillWater>> createSheets(osg::Drawable& drawable);

    static constexpr std::size_t MAX_PLANES = 16;

    const glm::dmat4& localFromSurface() const { return _localFromSurface; }

    /// Corners in surface space, z left out, each place once; three indices a triangle.
    const std::vector<glm::dvec2>& corners() const { return _corners; }
    const std::vector<unsigned int>& triangles() const { return _triangles; }

    /// The corners' convex hull, counter-clockwise.
    const std::vector<glm::dvec2>& hull() const { return _hull; }

    /// Squared distance [local units] of a local point from the still water.
    double squaredDistance(const glm::dvec3& localPoint) const;

    /// Local bounds of the water when waves of an amplitude [local units] move it.
    osg::BoundingBox localBound(double amplitude) const;

    /// The triangles as they are, about an anchor in surface space: the mesh of calm water.
    const glm::dvec2& calmAnchor() const { return _calmAnchor; }
    osg::Geometry* calmMesh() const { return _calmMesh.get(); }

private:
    StillWater() = default;

    /// Of three local points a triangle; null where they have no area.
    static osg::ref_ptr<StillWater> create(const std::vector<glm::dvec3>& points);

    void addTriangles(const std::vector<glm::dvec3>& points);
    void createCalmMesh();

    glm::dmat4 _localFromSurface{1.0};
    osg::BoundingBox _stillBound; // local
    std::vector<glm::dvec2> _corners;
    std::vector<unsigned int> _triangles;
    std::vector<glm::dvec2> _hull;
    glm::dvec2 _calmAnchor{0.0};
    osg::ref_ptr<osg::Geometry> _calmMesh;
};

/// A Geometry of triangles in surface space about an anchor, drawn from vertex buffers.
osg::ref_ptr<osg::Geometry> createSurfaceGeometry();

} // namespace osgWaterReflect

#endif

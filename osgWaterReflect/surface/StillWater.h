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

/// One sheet of still water, taken from a drawable: its plane, and its outline in triangles.
///
/// Surface space has its z along the still normal (the side from which the triangles run counter
/// clockwise), its x along the local x axis laid into the plane (the local y axis where x is close
/// to the normal), its unit the local unit, and its origin at the foot of the local origin.
/// Immutable; shared by all views.
class StillWater : public osg::Referenced
{
public:
    /// Null where the drawable has no triangle with an area. Says on OSG_WARN when it is not
    /// plane; the mean plane is taken then.
    static osg::ref_ptr<StillWater> create(osg::Drawable& drawable);

    const glm::dmat4& localFromSurface() const { return _localFromSurface; }

    /// Corners in surface space, z left out, each place once; three indices a triangle.
    const std::vector<glm::dvec2>& corners() const { return _corners; }
    const std::vector<unsigned int>& triangles() const { return _triangles; }

    /// Local bounds of the water when waves of an amplitude [local units] move it.
    osg::BoundingBox localBound(double amplitude) const;

    /// The triangles as they are, about an anchor in surface space: the mesh of calm water.
    const glm::dvec2& calmAnchor() const { return _calmAnchor; }
    osg::Geometry* calmMesh() const { return _calmMesh.get(); }

private:
    StillWater() = default;

    /// Three local points a triangle. Returns how far they leave the plane [local units].
    double addTriangles(const std::vector<glm::dvec3>& points);
    void createCalmMesh();

    glm::dmat4 _localFromSurface{1.0};
    osg::BoundingBox _stillBound; // local
    std::vector<glm::dvec2> _corners;
    std::vector<unsigned int> _triangles;
    glm::dvec2 _calmAnchor{0.0};
    osg::ref_ptr<osg::Geometry> _calmMesh;
};

/// A Geometry of triangles in surface space about an anchor, drawn from vertex buffers.
osg::ref_ptr<osg::Geometry> createSurfaceGeometry();

} // namespace osgWaterReflect

#endif

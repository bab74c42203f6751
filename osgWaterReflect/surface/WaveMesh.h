#ifndef OSGWATERREFLECT_SURFACE_WAVEMESH_H
#define OSGWATERREFLECT_SURFACE_WAVEMESH_H

#include "StillWater.h"
#include "WaveBounds.h"

#include <osgWaterReflect/SurfaceDetail>

#include <osg/Geometry>
#include <osg/observer_ptr>

#include <glm/mat4x4.hpp>

namespace osgWaterReflect
{

/// From where a sheet of water is seen: what decides how finely it is divided.
struct SheetView
{
    glm::dmat4 eyeFromSurface{1.0};
    glm::dmat4 clipFromEye{1.0};
    double viewportWidth = 0.0;  ///< [pixels]
    double viewportHeight = 0.0; ///< [pixels]
    WaveBounds waves;            ///< on the sheet

    /// Whether a sheet is divided alike: the near and far planes, which are fitted anew in every
    /// frame, do not matter.
    bool operator==(const SheetView& rhs) const;
};

/// A sheet of water divided for one view: halves every edge that is too long on screen, and that
/// waves stray from too far, until none is left, without cracks, since an edge alone decides
/// whether it is halved. Outlines, concave ones and holes too, stay where they are. What lies
/// outside the view is left out.
class WaveMesh : public osg::Referenced
{
public:
    WaveMesh();

    /// Divides the sheet anew where the view, the detail or the sheet is another than last time.
    void update(const StillWater& water, const SheetView& view, const SurfaceDetail& detail);

    /// Vertices in surface space about the anchor, z = 0.
    osg::Geometry* geometry() const { return _geometry.get(); }

    /// Foot of the eye on the still plane when the mesh was last divided [surface units].
    const glm::dvec2& anchor() const { return _anchor; }

    /// What the length of edges was multiplied with to keep to maxVertices, >= 1.
    double coarsening() const { return _coarsening; }

private:
    osg::ref_ptr<osg::Geometry> _geometry;
    osg::observer_ptr<const StillWater> _water; // not held: what is drawn dies with its sheet
    SheetView _view;
    SurfaceDetail _detail;
    glm::dvec2 _anchor{0.0};
    double _coarsening = 1.0;
};

} // namespace osgWaterReflect

#endif

#ifndef OSGWATERREFLECT_TRACE_SHEETPASS_H
#define OSGWATERREFLECT_TRACE_SHEETPASS_H

#include "../capture/Capture.h"
#include "../pyramid/Pyramid.h"
#include "../surface/WaveMesh.h"
#include "TracePass.h"
#include "WaterProgram.h"

#include <osgWaterReflect/WaterSurface>

#include <osg/StateSet>

#include <string>
#include <vector>

namespace osgWaterReflect
{

/// What a sheet's rays are looked for in, this frame's.
struct Searched
{
    const Capture& capture;
    const Pyramid* pyramid; ///< of that capture; null where the water's search needs none
};

/// One sheet of water in one view: the state and the mesh that trace and shade its pixels.
///
/// It is culled and drawn by one CullVisitor only, so that a frame still being drawn is never
/// written to.
class SheetPass : public osg::Referenced
{
public:
    SheetPass();

    /// Adds the sheet to the view, drawn after what is opaque and before what is transparent.
    /// The view is at the water node in its traversal.
    ///   searched  in this order; one or two
    ///   trace     where its rays are traced first, with a traceScale below 1
    ///   settings  nothing in them is AUTOMATIC
    void draw(osgUtil::CullVisitor& view, const std::vector<Searched>& searched, TracePass& trace,
              const WaterSurface& water, const StillWater& sheet,
              const ReflectionSettings& settings);

    void releaseGLObjects(osg::State* state) const;
    void resizeGLObjectBuffers(unsigned int maxSize);

private:
    struct Mesh
    {
        osg::Geometry* geometry;
        glm::dvec2 anchor; ///< in surface space
    };

    /// The sheet's triangles as they are when calm, else divided for the view; sets the waves'
    /// uniforms for the mesh's anchor.
    Mesh prepareMesh(const WaterSurface& water, const StillWater& sheet, const SheetView& view,
                     double time);

    /// Hands a capture to the shader.
    ///   name  of its uniforms
    ///   unit  of the first of its textures
    void setSearched(const Searched& searched, const std::string& name, unsigned int unit);
    void setWater(const WaterSurface& water, const ReflectionSettings& settings, Images images);
    void setView(const SheetView& view, const glm::dmat4& eyeFromWorld, const glm::dvec2& anchor,
                 const WaveModel* waves, double time);

    /// Hands what is traced first to the shader, or takes it away.
    void setTraced(const TracePass* trace);

    osg::ref_ptr<osg::StateSet> _stateSet;
    osg::ref_ptr<osg::StateSet> _traceStateSet; // null until a traceScale below 1 asks for it
    osg::ref_ptr<WaveMesh> _waveMesh;           // null until waves ask for it
};

} // namespace osgWaterReflect

#endif

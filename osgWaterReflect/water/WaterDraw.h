#ifndef OSGWATERREFLECT_WATER_WATERDRAW_H
#define OSGWATERREFLECT_WATER_WATERDRAW_H

#include "../effects/EffectState.h"
#include "../images/CaptureBinding.h"
#include "../surface/WaveMesh.h"
#include "KeptProgram.h"
#include "LowResTrace.h"
#include "VisibleSheet.h"
#include "WaterSettings.h"

#include <string>

namespace osgWaterReflect
{

/// What a sheet's rays are looked for in, this frame's.
struct SearchedCapture
{
    const Capture* capture = nullptr;  ///< null: none
    const DepthCells* cells = nullptr; ///< of that capture; null where the search reads none
    const SkyImage* sky = nullptr;     ///< of that capture; null where it is not looked at
};

/// One sheet of water in one view: the state and the mesh that trace and shade its pixels, drawn
/// after what is opaque and before what is transparent.
///
/// It is culled and drawn by one CullVisitor only, so that a frame still being drawn is never
/// written to.
class WaterDraw : public GLObjects
{
public:
    WaterDraw();

    /// Adds the sheet to a view that is at the water node in its traversal. State and mesh are
    /// empty until they are prepared, when the view's cull is over.
    void enrol(osgUtil::CullVisitor& view, const VisibleSheet& visible);

    /// Fills them.
    ///   settings  nothing in them is AUTOMATIC
    ///   effects   that the sheet calls for
    ///   first, second  in this order; the second may be none
    ///   scene     what the eye sees without water, for the effects; null: none looks at it
    ///   trace     where its rays are traced first, with a traceScale below 1
    void prepare(const CulledView& view, const VisibleSheet& visible, const WaterSettings& settings,
                 const std::vector<const Effect*>& effects, const SearchedCapture& first,
                 const SearchedCapture& second, const Capture* scene, LowResTrace& trace);

    /// Of the program that it is drawn with; empty before it is prepared.
    const std::string& programName() const;

    void releaseGLObjects(osg::State* state) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;

private:
    /// The sheet's triangles as they are when calm, else divided for the view. Returns the anchor
    /// of the mesh, in surface space, and sets the waves' uniforms for it.
    glm::dvec2 prepareMesh(const CulledView& view, const VisibleSheet& visible);
    void setWater(const WaterSurface& water, const WaterSettings& settings);
    void setView(const CulledView& view, const VisibleSheet& visible,
                 const glm::dmat4& eyeFromAnchor);

    /// Draws the sheet into the image of traces, too, and hands that to the shader; or takes it
    /// away.
    void setTraced(LowResTrace& trace, const VisibleSheet& visible, const WaterSettings& settings,
                   Images images);

    osg::ref_ptr<osg::StateSet> _stateSet;
    osg::ref_ptr<osg::StateSet> _traceStateSet; // null until a traceScale below 1 asks for it
    osg::ref_ptr<WaveMesh> _waveMesh;           // null until waves ask for it
    osg::ref_ptr<osg::Geometry> _mesh;          // of this frame
    osg::ref_ptr<osg::RefMatrix> _eyeFromMesh;  // of this frame
    EffectState _effects;
    KeptProgram _program;
    KeptProgram _traceProgram;
    CaptureBinding _eyeCapture;
    CaptureBinding _mirrorCapture;
};

} // namespace osgWaterReflect

#endif

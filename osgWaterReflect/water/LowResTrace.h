#ifndef OSGWATERREFLECT_WATER_LOWRESTRACE_H
#define OSGWATERREFLECT_WATER_LOWRESTRACE_H

#include "../capture/CulledView.h"
#include "../passes/GLObjects.h"

#include <osg/Camera>
#include <osg/Drawable>
#include <osg/Texture2D>
#include <osg/Uniform>
#include <osgUtil/RenderStage>
#include <osgUtil/StateGraph>

namespace osgWaterReflect
{

/// What the rays of a view's waters find when they are traced at a fraction of its resolution,
/// rendered after all captures: before the view, or in the middle of its drawing where one is
/// copied from that.
///
/// | image | format  | a texel holds                              | size                      |
/// |-------|---------|--------------------------------------------|---------------------------|
/// | found | RGBA32F | a TracedRay, coded (trace_texel.glsl) | viewport times traceScale |
///
/// Nothing but water is drawn: also that which the view will hide. Of several waters the nearest is
/// seen.
class LowResTrace : public GLObjects
{
public:
    /// Of the camera of every trace's render stage, for those who look into a frame.
    static constexpr const char* CAMERA_NAME = "osgWaterReflect trace";

    LowResTrace();

    /// Begins a frame's image, without a sheet.
    ///   scale  [1] of its sides over the view's, above 0 and below 1
    void begin(const CulledView& view, double scale);

    /// Draws a sheet of water into it.
    ///   sheetState  the sheet's own; it is told the sheet's number
    ///   traceState  on top of it, with the program
    void addSheet(osg::StateSet& sheetState, osg::StateSet& traceState, osg::Drawable& mesh,
                  osg::RefMatrix& eyeFromMesh);

    /// Renders it after what has been arranged so far.
    ///   copy  the stage of the capture that is copied from the view; null: none is
    void draw(const CulledView& view, osgUtil::RenderStage* copy);

    /// Drops what a frame's image held, where the next has none.
    void clear();

    osg::Texture2D* rays() const { return _rays.get(); }

    /// Texels of the image by place in the view's window.
    osg::Uniform* tracedFromWindow() const { return _tracedFromWindow.get(); }

    void releaseGLObjects(osg::State* state) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;

private:
    void resize(const osg::Viewport& view, double scale);

    osg::ref_ptr<osg::Texture2D> _rays;
    osg::ref_ptr<osg::Uniform> _tracedFromWindow;
    osg::ref_ptr<osg::StateSet> _stateSet;
    osg::ref_ptr<osg::Camera> _camera; // holds the attachments; it is no node of the scene
    osg::ref_ptr<osgUtil::StateGraph> _stateGraph;
    osg::ref_ptr<osgUtil::RenderStage> _stage;
    osg::ref_ptr<osg::StateAttribute> _program; // of the last sheet, for the next
    osg::ref_ptr<osg::RefMatrix> _projection;   // of this frame; null: it has no image
    unsigned int _sheets = 0;                   // in this frame so far
};

} // namespace osgWaterReflect

#endif

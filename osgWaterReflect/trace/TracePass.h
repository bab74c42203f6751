#ifndef OSGWATERREFLECT_TRACE_TRACEPASS_H
#define OSGWATERREFLECT_TRACE_TRACEPASS_H

#include <osg/Camera>
#include <osg/Drawable>
#include <osg/Texture2D>
#include <osg/Uniform>
#include <osgUtil/CullVisitor>
#include <osgUtil/RenderStage>

namespace osgWaterReflect
{

/// What the rays of one camera's waters find when they are traced at a fraction of the view's
/// resolution, rendered after all captures: before the view, or in the middle of its drawing where
/// one is copied from that.
///
/// | image | format  | a texel holds                              | size                      |
/// |-------|---------|--------------------------------------------|---------------------------|
/// | found | RGBA32F | one ray's Found, coded (shaders/found.glsl) | viewport times traceScale |
///
/// Nothing but water is drawn: also that which the view will hide. Of several waters the nearest is
/// seen.
class TracePass : public osg::Referenced
{
public:
    /// Of the camera of every trace's render stage, for those who look into a frame.
    static constexpr const char* CAMERA_NAME = "osgWaterReflect trace";

    TracePass();

    /// Begins a cull: drops what the one before has drawn.
    void begin();

    /// Draws a sheet of water into the image, that the view has come to in its traversal and has
    /// been told the near and far planes of.
    ///   scale       of the image; the largest of a frame wins
    ///   sheetState  the sheet's own
    ///   traceState  on top of it, with the program; it is told the sheet's number
    void draw(osgUtil::CullVisitor& view, double scale, osg::StateSet& sheetState,
              osg::StateSet& traceState, osg::Drawable& mesh, const osg::Matrixd& eyeFromMesh);

    osg::Texture2D* found() const { return _found.get(); }

    /// Texels of the image by place in the view's window, known when the cull is done.
    osg::Uniform* foundFromWindow() const { return _foundFromWindow.get(); }

    void releaseGLObjects(osg::State* state) const;
    void resizeGLObjectBuffers(unsigned int maxSize);

private:
    void arrange(osgUtil::CullVisitor& view);
    void resize(const osg::Viewport& view, double scale);

    osg::ref_ptr<osg::Texture2D> _found;
    osg::ref_ptr<osg::Uniform> _foundFromWindow;
    osg::ref_ptr<osg::StateSet> _stateSet;
    osg::ref_ptr<osg::Camera> _camera; // holds the attachments; it is no node of the scene
    osg::ref_ptr<osgUtil::StateGraph> _stateGraph;
    osg::ref_ptr<osgUtil::RenderStage> _stage;
    osg::ref_ptr<osg::StateAttribute> _program; // of the last sheet, for the next
    osg::ref_ptr<osg::RefMatrix> _projection;   // of this frame
    double _scale = 0.0;                        // of this frame so far
    unsigned int _sheets = 0;                   // in this frame so far
};

} // namespace osgWaterReflect

#endif

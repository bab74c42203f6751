#ifndef OSGWATERREFLECT_CAPTURE_FRAMECOPY_H
#define OSGWATERREFLECT_CAPTURE_FRAMECOPY_H

#include "../passes/GLObjects.h"
#include "../passes/ImageStage.h"
#include "CulledView.h"
#include "FrameImages.h"

#include <osg/Camera>
#include <osg/Program>
#include <osg/Viewport>

namespace osgWaterReflect
{

/// Copies what a view's stage has drawn so far into a capture, in the middle of that stage: after
/// what is opaque and before the water. The stage goes on as if nothing had happened.
class FrameCopy : public GLObjects
{
public:
    FrameCopy();

    /// Arranges the copy in a view's stage, once in each cull.
    ///   target             holds the capture's images: attachments COLOR_BUFFER0 and DEPTH_BUFFER
    ///   place              [pixels] where in them the view's image goes; what is beside it stays.
    ///                      Of another size than the view's viewport: the nearest of its pixels
    ///   captureProjection  differs from the view's in near and far, and in the frustum's sides by
    ///                      what is beside the place. Both are read when the copy is drawn
    /// Where the view has no depth buffer, all that the place is in is cleared instead.
    void arrange(const CulledView& view, osg::Camera& target, const osg::Viewport& place,
                 const osg::RefMatrix& captureProjection);

    /// What is drawn for the copy. Stages after it in its post-render list, added after arrange(),
    /// are drawn before the water, too. They must not count as dynamic: OSG does not count them.
    osgUtil::RenderStage& stage() { return *_stage; }

    /// The stage of the copy that is arranged in a view's stage, for those who look into a frame;
    /// null: none.
    static osgUtil::RenderStage* stageIn(osgUtil::RenderStage& viewStage);

    /// What it runs.
    static osg::ref_ptr<osg::Program> program();

    void releaseGLObjects(osg::State* state) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;

private:
    class DrawCallback;
    class Stage;
    void draw(osg::RenderInfo& renderInfo, const osgUtil::RenderLeaf* last);

    osg::ref_ptr<FrameImages> _frame;
    osg::ref_ptr<ImageStage> _stage;
    GLint _colourFormat = GL_RGBA8;
    GLint _framebuffer = 0;                      // the view's, while it is drawn
    osg::ref_ptr<const osg::Viewport> _viewport; // the view's
    osg::ref_ptr<const osg::RefMatrix> _frameProjection;
    osg::ref_ptr<const osg::RefMatrix> _captureProjection;
};

} // namespace osgWaterReflect

#endif

#ifndef OSGWATERREFLECT_CAPTURE_COPIEDCAPTURE_H
#define OSGWATERREFLECT_CAPTURE_COPIEDCAPTURE_H

#include "CapturedScene.h"
#include "FrameCopy.h"

namespace osgWaterReflect
{

/// What a view's eye sees, copied in the middle of that view's drawing, before the water; only what
/// lies beyond its borders is drawn, before the view.
class CopiedCapture : public Capture
{
public:
    CopiedCapture();

    /// The scene, to be culled before the capture is taken, where that has a band.
    CapturedScene& scene() { return _scene; }

    /// Takes it.
    void take(const CulledView& view, const CaptureSize& size);

    osgUtil::RenderStage& stage() const override { return _copy->stage(); }

    void releaseGLObjects(osg::State* state) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;

private:
    void drawBand(const CulledView& view, const CaptureSize& size);
    void drawNothing(const CulledView& view);

    CapturedScene _scene;
    const osg::ref_ptr<FrameCopy> _copy;
    osg::ref_ptr<osg::RefMatrix> _projection; // that the copy's windowZ is of
};

} // namespace osgWaterReflect

#endif

#ifndef OSGWATERREFLECT_CAPTURE_DRAWNCAPTURE_H
#define OSGWATERREFLECT_CAPTURE_DRAWNCAPTURE_H

#include "CapturedScene.h"

namespace osgWaterReflect
{

/// What a view's eye sees, and what lies beyond its borders, drawn before the view.
class DrawnCapture : public Capture
{
public:
    DrawnCapture() : Capture(CAMERA_NAME), _scene(*_stage) {}

    /// The scene, to be culled before it is drawn.
    CapturedScene& scene() { return _scene; }

    /// Draws what has been culled in this frame.
    void draw(const CulledView& view, const CaptureSize& size);

private:
    CapturedScene _scene;
};

} // namespace osgWaterReflect

#endif

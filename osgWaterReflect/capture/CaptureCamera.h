#ifndef OSGWATERREFLECT_CAPTURE_CAPTURECAMERA_H
#define OSGWATERREFLECT_CAPTURE_CAPTURECAMERA_H

#include <osg/Camera>

namespace osgWaterReflect
{

/// The camera of a stage that the library culls for a view. It is no node of the scene, but
/// callbacks of the scene meet it as the current camera, and may ask it whatever they ask the
/// view's own. So while it is culled and drawn it has a view and a graphics context, too; they are
/// let go of in between, for they must not live as long as a capture.
class CaptureCamera : public osg::Camera
{
public:
    CaptureCamera();

    /// While this lives, in a cull for a view's camera, it answers as that does: with its view,
    /// graphics context, viewport, renderer and user data.
    class CullScope
    {
    public:
        CullScope(CaptureCamera& camera, osg::Camera& viewCamera);
        ~CullScope();
        CullScope(const CullScope&) = delete;
        CullScope& operator=(const CullScope&) = delete;

    private:
        CaptureCamera& _camera;
        const osg::ref_ptr<osg::Viewport> _viewport; // the camera's own
    };

protected:
    ~CaptureCamera() override = default;

private:
    class BeginDraw;
    class EndDraw;

    /// Not by osg::Camera::setGraphicsContext: the context would list it among its cameras, which
    /// threads that draw go through.
    void belongTo(osg::View* view, osg::GraphicsContext* context);
};

} // namespace osgWaterReflect

#endif

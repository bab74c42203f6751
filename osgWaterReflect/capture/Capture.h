#ifndef OSGWATERREFLECT_CAPTURE_CAPTURE_H
#define OSGWATERREFLECT_CAPTURE_CAPTURE_H

#include "CaptureVisitor.h"

#include <osg/Camera>
#include <osg/Texture2D>

#include <glm/mat4x4.hpp>

namespace osgWaterReflect
{

/// An image of the scene without its water, and the matrix it was taken with: what one camera of
/// one view sees this frame, rendered before that camera.
///
/// | image   | format                                   | size                        |
/// |---------|------------------------------------------|-----------------------------|
/// | colour  | RGBA8, or that of the camera's own buffer | viewport times captureScale |
/// | windowZ | 24-bit depth                             | the same                    |
class Capture : public osg::Referenced
{
public:
    /// Of the camera of every capture's render stage, for those who look into a frame.
    static constexpr const char* CAMERA_NAME = "osgWaterReflect capture";

    Capture();

    /// Renders the capture before the view's current stage, unless that has been arranged in this
    /// cull already. The most demanding water that it meets sets the scale.
    void require(osgUtil::CullVisitor& view);

    /// Whether water can be reflected for this camera: not while it renders depth alone (a shadow
    /// map), nor into an empty viewport.
    static bool serves(osgUtil::CullVisitor& view);

    osg::Texture2D* colour() const { return _colour.get(); }
    osg::Texture2D* windowZ() const { return _windowZ.get(); }
    const osg::Vec4& clearColour() const { return _stage->getClearColor(); }

    /// The capture's own projection, near and far as they were fitted; its eye is the view's.
    const glm::dmat4& clipFromEye() const { return _clipFromEye; }

    /// Counts the culls that it was arranged in.
    unsigned int serial() const { return _serial; }

    void releaseGLObjects(osg::State* state) const;
    void resizeGLObjectBuffers(unsigned int maxSize);

private:
    void resize(osgUtil::CullVisitor& view);

    osg::ref_ptr<osg::Texture2D> _colour;
    osg::ref_ptr<osg::Texture2D> _windowZ;
    osg::ref_ptr<osg::Camera> _camera; // holds the attachments; it is no node of the scene
    osg::ref_ptr<osgUtil::RenderStage> _stage;
    osg::ref_ptr<CaptureVisitor> _visitor;
    glm::dmat4 _clipFromEye{1.0};
    unsigned int _serial = 0;
};

} // namespace osgWaterReflect

#endif

#ifndef OSGWATERREFLECT_CAPTURE_CAPTURE_H
#define OSGWATERREFLECT_CAPTURE_CAPTURE_H

#include "../band/GuardBand.h"
#include "../passes/GLObjects.h"
#include "CaptureCamera.h"
#include "CulledView.h"

#include <osg/Camera>
#include <osg/Texture2D>
#include <osgUtil/RenderStage>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

namespace osgWaterReflect
{

/// How large a capture is made.
struct CaptureSize
{
    glm::ivec2 view{0};     ///< [pixels] of the capture, for what the view shows
    GuardBand band;         ///< what it shows beyond
    glm::ivec2 capacity{0}; ///< [pixels] of the largest that its settings may ask for

    /// [pixels] With the band.
    glm::ivec2 whole() const { return widened(view, band); }
};

/// An image of the scene without its water, and the matrix it was taken with: what a search for a
/// reflected ray needs, wherever the image comes from (DrawnCapture, MirroredCapture,
/// CopiedCapture).
///
/// | image   | format                                        | size                          |
/// |---------|-----------------------------------------------|-------------------------------|
/// | colour  | RGBA8, or that of the view's own buffer       | the view's times captureScale, |
/// |         |                                               | and the guard band            |
/// | windowZ | 24-bit depth; R32F of a MirroredCapture       | the same                      |
///
/// The textures are made for the largest band, of which a frame uses the lower left part.
class Capture : public GLObjects
{
public:
    /// Of the camera of a capture's render stage, for those who look into a frame.
    static constexpr const char* CAMERA_NAME = "osgWaterReflect capture";
    static constexpr const char* MIRROR_CAMERA_NAME = "osgWaterReflect mirror";

    osg::Texture2D* colour() const { return _colour.get(); }
    virtual osg::Texture2D* windowZ() const { return _windowZ.get(); }
    const osg::Vec4& clearColour() const { return _stage->getClearColor(); }

    /// Whether it is a mirrored eye's: then a ray's first pixel may show what it meets, where
    /// another's shows what lies under the water.
    virtual bool isMirrored() const { return false; }

    /// [pixels] Of the lower left part of the textures that is in use, and of all.
    glm::ivec2 size() const { return _size.whole(); }
    const glm::ivec2& capacity() const { return _capacity; }

    /// From the view's eye space to the capture's own clip space, near and far as they were fitted.
    /// That of a mirrored eye turns left for right.
    const glm::dmat4& clipFromEye() const { return _clipFromEye; }

    /// How windowZ changes with depth: by perspective / depth, or by orthographic * depth. The one
    /// that is not in use is 0.
    struct DepthScale
    {
        double perspective = 0.0;
        double orthographic = 0.0;
    };
    DepthScale depthScale() const;

    /// Side of a pixel [world units]: at unit depth in perspective, else itself.
    double pixelExtent() const;

    /// What has made the capture when it is drawn; what computes images of it follows in its
    /// post-render list.
    virtual osgUtil::RenderStage& stage() const { return *_stage; }

    void releaseGLObjects(osg::State* state) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;

protected:
    Capture(const char* cameraName);

    /// Makes room for this frame's image, in the format of the view's own colours.
    void allocate(const CulledView& view, const CaptureSize& size);

    /// Tells with what it is taken.
    ///   eyeFromWorld    for row vectors
    ///   eyeFromViewEye  of the capture's eye
    ///   projection      as it is drawn with
    ///   clipFromEye     whose windowZ it holds
    void setMatrices(const osg::Matrixd& eyeFromWorld, const glm::dmat4& eyeFromViewEye,
                     const osg::Matrixd& projection, const glm::dmat4& clipFromEye);

    /// Draws it before the view, after every texture of the scene's own that the view draws first.
    void drawBefore(const CulledView& view);

    const osg::ref_ptr<osg::Texture2D> _colour;
    const osg::ref_ptr<osg::Texture2D> _windowZ;
    const osg::ref_ptr<CaptureCamera> _camera; // holds the attachments
    const osg::ref_ptr<osgUtil::RenderStage> _stage;
    CaptureSize _size;

private:
    glm::ivec2 _capacity{0};
    glm::ivec2 _allocatedFor{0}; // view size
    glm::dmat4 _projection{1.0};
    glm::dmat4 _clipFromEye{1.0};
};

} // namespace osgWaterReflect

#endif

#include "Capture.h"

#include "../Transforms.h"

#include <osgWaterReflect/WaterSurface>

#include <algorithm>
#include <climits>
#include <cmath>

using namespace osgWaterReflect;

namespace
{

osg::ref_ptr<osg::Texture2D> createImage(GLint internalFormat, GLenum format, GLenum type,
                                         osg::Texture::FilterMode filter)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setInternalFormat(internalFormat);
    texture->setSourceFormat(format);
    texture->setSourceType(type);
    texture->setFilter(osg::Texture::MIN_FILTER, filter);
    texture->setFilter(osg::Texture::MAG_FILTER, filter);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

// The format that a camera renders its colour to; RGBA8 where that is the window's.
GLint colourFormat(const osg::Camera& camera)
{
    if (camera.getRenderTargetImplementation() == osg::Camera::FRAME_BUFFER) return GL_RGBA8;
    const auto& attachments = camera.getBufferAttachmentMap();
    for (auto buffer : {osg::Camera::COLOR_BUFFER, osg::Camera::COLOR_BUFFER0})
    {
        const auto found = attachments.find(buffer);
        if (found == attachments.end()) continue;
        const osg::Camera::Attachment& attachment = found->second;
        if (attachment._texture.valid() && attachment._texture->getInternalFormat())
            return attachment._texture->getInternalFormat();
        if (attachment._image.valid() && attachment._image->getInternalTextureFormat())
            return attachment._image->getInternalTextureFormat();
        if (attachment._internalFormat) return attachment._internalFormat;
    }
    return GL_RGBA8;
}

} // namespace

Capture::Capture() :
    _colour(createImage(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, osg::Texture::LINEAR)),
    _windowZ(createImage(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                         osg::Texture::NEAREST)),
    _camera(new osg::Camera), _stage(new osgUtil::RenderStage), _visitor(new CaptureVisitor)
{
    _windowZ->setShadowComparison(false);
    _camera->setName(CAMERA_NAME);
    _camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    _camera->setImplicitBufferAttachmentMask(0, 0);
    _camera->attach(osg::Camera::COLOR_BUFFER0, _colour);
    _camera->attach(osg::Camera::DEPTH_BUFFER, _windowZ);
    _stage->setCamera(_camera);
    _stage->setViewport(new osg::Viewport);
    _camera->setViewport(_stage->getViewport());
}

bool Capture::serves(osgUtil::CullVisitor& view)
{
    const osg::Camera* camera = view.getCurrentCamera();
    const osg::Viewport* viewport = view.getCurrentRenderStage()->getViewport();
    if (!camera || !viewport || viewport->width() < 1.0 || viewport->height() < 1.0) return false;

    const auto& attachments = camera->getBufferAttachmentMap();
    const bool hasColour = std::any_of(attachments.begin(), attachments.end(),
                                       [](const auto& attachment)
                                       { return attachment.first >= osg::Camera::COLOR_BUFFER; });
    return attachments.empty() || hasColour;
}

void Capture::require(osgUtil::CullVisitor& view)
{
    osgUtil::RenderStage& viewStage = *view.getCurrentRenderStage();
    const auto& arranged = viewStage.getPreRenderList();
    const bool done = std::any_of(arranged.begin(), arranged.end(),
                                  [this](const auto& stage) { return stage.second == _stage; });
    if (done) return;
    ++_serial;

    osg::ref_ptr<osg::RefMatrix> projection = new osg::RefMatrix(*view.getProjectionMatrix());
    _visitor->cull(view, *_stage, *projection);
    _clipFromEye = fromOsg(*projection);
    _camera->setViewMatrix(*viewStage.getInitialViewMatrix()); // for draw callbacks that ask it
    _camera->setProjectionMatrix(*projection);
    resize(view);

    // After every texture of the scene's own that the view renders first.
    viewStage.addPreRenderStage(_stage.get(), INT_MAX);
}

void Capture::resize(osgUtil::CullVisitor& view)
{
    double scale = 0.0;
    for (const WaterSurface* water : _visitor->waters())
        scale = std::max(scale, water->getReflection().captureScale);
    if (scale == 0.0) scale = 1.0;

    const osg::Viewport& viewport = *view.getCurrentRenderStage()->getViewport();
    _size.x = std::max(1, static_cast<int>(std::lround(scale * viewport.width())));
    _size.y = std::max(1, static_cast<int>(std::lround(scale * viewport.height())));
    _capacity = _size;
    _stage->getViewport()->setViewport(0, 0, _size.x, _size.y);

    const GLint format = colourFormat(*view.getCurrentCamera());
    if (format != _colour->getInternalFormat())
    {
        _colour->setInternalFormat(format);
        _colour->dirtyTextureObject();
        _camera->dirtyAttachmentMap();
    }
    _camera->resizeAttachments(_capacity.x, _capacity.y);
}

Capture::DepthScale Capture::depthScale() const
{
    const bool orthographic = eyePointOf(_clipFromEye).w == 0.0;
    if (orthographic) return {0.0, 0.5 * std::abs(_clipFromEye[2][2])};
    return {0.5 * std::abs(_clipFromEye[3][2]), 0.0};
}

double Capture::pixelExtent() const
{
    const double clipXPerUnit = std::hypot(_clipFromEye[0][0], _clipFromEye[1][0]);
    return 2.0 / (clipXPerUnit * _size.x);
}

void Capture::releaseGLObjects(osg::State* state) const
{
    _colour->releaseGLObjects(state);
    _windowZ->releaseGLObjects(state);
    _stage->releaseGLObjects(state);
}

void Capture::resizeGLObjectBuffers(unsigned int maxSize)
{
    _colour->resizeGLObjectBuffers(maxSize);
    _windowZ->resizeGLObjectBuffers(maxSize);
}

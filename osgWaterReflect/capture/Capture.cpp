#include "Capture.h"

#include "../Transforms.h"

#include <osg/ContextData>
#include <osg/FrameBufferObject>

#include <glm/common.hpp>

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

// OSG makes its lists of frame buffers to be deleted when the first goes, without a lock. Captures
// go in cull threads, several at once: the lists are made in the thread that draws, before any
// goes.
class PrepareDeletion : public osg::Camera::DrawCallback
{
public:
    void operator()(osg::RenderInfo& renderInfo) const override
    {
        osg::get<osg::GLFrameBufferObjectManager>(renderInfo.getContextID());
        osg::get<osg::GLRenderBufferManager>(renderInfo.getContextID());
    }
};

} // namespace

Capture::Capture(const char* cameraName) :
    _colour(createImage(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, osg::Texture::LINEAR)),
    _windowZ(createImage(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                         osg::Texture::NEAREST)),
    _camera(new CaptureCamera), _stage(new osgUtil::RenderStage)
{
    _windowZ->setShadowComparison(false);
    _camera->setName(cameraName);
    _camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    _camera->setImplicitBufferAttachmentMask(0, 0);
    _camera->attach(osg::Camera::COLOR_BUFFER0, _colour);
    _camera->attach(osg::Camera::DEPTH_BUFFER, _windowZ);
    _camera->addInitialDrawCallback(new PrepareDeletion);
    _stage->setCamera(_camera);
    _stage->setViewport(new osg::Viewport);
    _camera->setViewport(_stage->getViewport());
}

// Once some band was needed, textures are as large as any that may be.
void Capture::allocate(const CulledView& view, const CaptureSize& size)
{
    _size = size;
    const glm::ivec2 whole = size.whole();
    if (size.view != _allocatedFor) _capacity = size.view;
    _allocatedFor = size.view;
    if (whole != size.view) _capacity = glm::max(_capacity, size.capacity);

    const GLint format = colourFormat(*view.stageCamera);
    if (format != _colour->getInternalFormat())
    {
        _colour->setInternalFormat(format);
        _colour->dirtyTextureObject();
        _camera->dirtyAttachmentMap();
    }
    _camera->resizeAttachments(_capacity.x, _capacity.y);
    _stage->getViewport()->setViewport(0, 0, whole.x, whole.y);
}

void Capture::setMatrices(const osg::Matrixd& eyeFromWorld, const glm::dmat4& eyeFromViewEye,
                          const osg::Matrixd& projection, const glm::dmat4& clipFromEye)
{
    _projection = clipFromEye;
    _clipFromEye = clipFromEye * eyeFromViewEye;
    // For draw callbacks that ask it, and for those who look into a frame.
    _camera->setViewMatrix(eyeFromWorld);
    _camera->setProjectionMatrix(projection);
}

void Capture::drawBefore(const CulledView& view)
{
    view.stage->addPreRenderStage(_stage, INT_MAX);
}

Capture::DepthScale Capture::depthScale() const
{
    const bool orthographic = eyePointOf(_projection).w == 0.0;
    if (orthographic) return {0.0, 0.5 * std::abs(_projection[2][2])};
    return {0.5 * std::abs(_projection[3][2]), 0.0};
}

double Capture::pixelExtent() const
{
    const double clipXPerUnit = std::hypot(_projection[0][0], _projection[1][0]);
    return 2.0 / (clipXPerUnit * size().x);
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

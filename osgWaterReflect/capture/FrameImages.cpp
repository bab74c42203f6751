#include "FrameImages.h"

#include <osg/GLExtensions>

using namespace osgWaterReflect;

namespace
{

osg::ref_ptr<osg::Texture2D> createImage()
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

GLint askFor(GLenum what)
{
    GLint value = 0;
    glGetIntegerv(what, &value);
    return value;
}

// The format of the depth that is drawn to, as far as its copy has to share it: a resolving blit
// wants the very same, stencil included; other copies must not ask for a stencil. 0: none.
GLint depthFormat(GLint framebuffer, bool resolve)
{
    // Not among osg::GLExtensions.
    void(GL_APIENTRY * glGetFramebufferAttachmentParameteriv)(GLenum, GLenum, GLenum, GLint*);
    if (!osg::setGLExtensionFuncPtr(glGetFramebufferAttachmentParameteriv,
                                    "glGetFramebufferAttachmentParameteriv"))
        return 0;
    const auto ask = [&](GLenum what)
    {
        GLint value = 0;
        glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER_EXT,
                                              framebuffer ? GL_DEPTH_ATTACHMENT_EXT : GL_DEPTH,
                                              what, &value);
        return value;
    };
    if (ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_EXT) == GL_NONE) return 0;
    const GLint bits = ask(GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
    const bool isFloat = ask(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
    if (resolve && ask(GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE) > 0)
        return isFloat ? GL_DEPTH32F_STENCIL8 : GL_DEPTH24_STENCIL8_EXT;
    if (isFloat) return GL_DEPTH_COMPONENT32F;
    return bits <= 16 ? GL_DEPTH_COMPONENT16
                      : (bits <= 24 ? GL_DEPTH_COMPONENT24 : GL_DEPTH_COMPONENT32);
}

void setDepthFormat(osg::Texture2D& texture, GLint internalFormat)
{
    texture.setInternalFormat(internalFormat);
    texture.setSourceFormat(GL_DEPTH_STENCIL_EXT);
    if (internalFormat == GL_DEPTH24_STENCIL8_EXT)
        texture.setSourceType(GL_UNSIGNED_INT_24_8_EXT);
    else if (internalFormat == GL_DEPTH32F_STENCIL8)
        texture.setSourceType(GL_FLOAT_32_UNSIGNED_INT_24_8_REV);
    else
    {
        texture.setSourceFormat(GL_DEPTH_COMPONENT);
        texture.setSourceType(GL_FLOAT);
    }
}

} // namespace

FrameImages::FrameImages() : _colour(createImage()), _windowZ(createImage()) {}

bool FrameImages::copy(osg::State& state, const osg::Viewport& viewport, GLint colourFormat)
{
    const auto& gl = *state.get<osg::GLExtensions>();
    const GLint framebuffer = askFor(GL_DRAW_FRAMEBUFFER_BINDING_EXT);
    const GLint drawBuffer = askFor(GL_DRAW_BUFFER);
    // A window resolves its samples when it is read.
    const bool resolve = framebuffer != 0 && askFor(GL_SAMPLE_BUFFERS) > 0;
    const GLint format = depthFormat(framebuffer, resolve);
    if (!format) return false;

    const int x = static_cast<int>(viewport.x());
    const int y = static_cast<int>(viewport.y());
    const int width = static_cast<int>(viewport.width());
    const int height = static_cast<int>(viewport.height());
    allocate(width, height, colourFormat, format);

    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER_EXT, framebuffer);
    const GLint readBuffer = askFor(GL_READ_BUFFER);
    glReadBuffer(drawBuffer); // not osg::State's, which knows of one framebuffer only
    if (resolve)
    {
        _resolved->apply(state, osg::FrameBufferObject::DRAW_FRAMEBUFFER);
        gl.glBlitFramebuffer(x, y, x + width, y + height, 0, 0, width, height,
                             GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    }
    else
    {
        _colour->copyTexSubImage2D(state, 0, 0, x, y, width, height);
        _windowZ->copyTexSubImage2D(state, 0, 0, x, y, width, height);
    }
    glReadBuffer(readBuffer);
    return true;
}

void FrameImages::allocate(int width, int height, GLint colourFormat, GLint depthFormat)
{
    if (_resolved && _colour->getTextureWidth() == width && _colour->getTextureHeight() == height &&
        _colour->getInternalFormat() == colourFormat &&
        _windowZ->getInternalFormat() == depthFormat)
        return;
    _colour->setInternalFormat(colourFormat);
    _colour->setSourceFormat(GL_RGBA);
    setDepthFormat(*_windowZ, depthFormat);
    for (osg::Texture2D* texture : {_colour.get(), _windowZ.get()})
    {
        texture->setTextureSize(width, height);
        texture->dirtyTextureObject();
    }
    _resolved = new osg::FrameBufferObject;
    _resolved->setAttachment(osg::Camera::COLOR_BUFFER0, osg::FrameBufferAttachment(_colour));
    _resolved->setAttachment(osg::Camera::DEPTH_BUFFER, osg::FrameBufferAttachment(_windowZ));
}

void FrameImages::releaseGLObjects(osg::State* state) const
{
    _colour->releaseGLObjects(state);
    _windowZ->releaseGLObjects(state);
    if (_resolved) _resolved->releaseGLObjects(state);
}

void FrameImages::resizeGLObjectBuffers(unsigned int maxSize)
{
    _colour->resizeGLObjectBuffers(maxSize);
    _windowZ->resizeGLObjectBuffers(maxSize);
    if (_resolved) _resolved->resizeGLObjectBuffers(maxSize);
}

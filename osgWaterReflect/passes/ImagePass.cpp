#include "ImagePass.h"

#include "../shaders/Bindings.h"
#include "../shaders/SharedProgram.h"

#include <climits>

using namespace osgWaterReflect;

ImagePass::ImagePass(const char* fragmentShader, GLint internalFormat, GLenum format) :
    _fragmentShader(fragmentShader), _image(new osg::Texture2D), _camera(new osg::Camera),
    _stage(new ImageStage)
{
    _image->setInternalFormat(internalFormat);
    _image->setSourceFormat(format);
    _image->setSourceType(GL_FLOAT);
    _image->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    _image->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    _image->setResizeNonPowerOfTwoHint(false);

    _camera->setName(std::string("osgWaterReflect ") + fragmentShader);
    _camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    _camera->setImplicitBufferAttachmentMask(0, 0);
    _camera->attach(osg::Camera::COLOR_BUFFER0, _image);
    _camera->setViewport(_stage->getViewport());
    _stage->setCamera(_camera);
}

osg::ref_ptr<osg::Program> ImagePass::program(const std::string& fragmentShader)
{
    return sharedProgram("fullscreen.vert", fragmentShader);
}

void ImagePass::setInput(unsigned int unit, const std::string& name, osg::Texture2D* texture)
{
    _stage->stateSet().setTextureAttribute(unit, texture);
    bindings::set(_stage->stateSet(), name, static_cast<int>(unit));
}

void ImagePass::require(osgUtil::RenderStage& stage, const glm::ivec2& size,
                        const glm::ivec2& capacity)
{
    if (!_stage->stateSet().getAttribute(osg::StateAttribute::PROGRAM))
        _stage->stateSet().setAttributeAndModes(program(_fragmentShader));
    _stage->prepare(0, 0, size.x, size.y);
    _camera->resizeAttachments(capacity.x, capacity.y);
    stage.addPostRenderStage(_stage, INT_MAX);
}

void ImagePass::releaseGLObjects(osg::State* state) const
{
    _image->releaseGLObjects(state);
    _stage->releaseGLObjects(state);
}

void ImagePass::resizeGLObjectBuffers(unsigned int maxSize)
{
    _image->resizeGLObjectBuffers(maxSize);
    _stage->resizeGLObjectBuffers(maxSize);
}

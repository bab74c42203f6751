#include "ImagePass.h"

#include "../shaders/SharedProgram.h"
#include "../trace/Bindings.h"

#include <osg/Geometry>

#include <climits>

using namespace osgWaterReflect;

namespace
{

// Covers the whole target.
osg::ref_ptr<osg::Geometry> createTriangle()
{
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (const auto& corner : {osg::Vec3(-1, -1, 0), {3, -1, 0}, {-1, 3, 0}})
        corners->push_back(corner);
    osg::ref_ptr<osg::Geometry> triangle = new osg::Geometry;
    triangle->setVertexArray(corners);
    triangle->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, 3));
    triangle->setUseDisplayList(false);
    triangle->setUseVertexBufferObjects(true);
    return triangle;
}

} // namespace

ImagePass::ImagePass(const char* fragmentShader, GLint internalFormat, GLenum format) :
    _fragmentShader(fragmentShader), _image(new osg::Texture2D), _stateSet(new osg::StateSet),
    _triangle(createTriangle()), _camera(new osg::Camera), _stateGraph(new osgUtil::StateGraph),
    _stage(new osgUtil::RenderStage)
{
    _image->setInternalFormat(internalFormat);
    _image->setSourceFormat(format);
    _image->setSourceType(GL_FLOAT);
    _image->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    _image->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    _image->setResizeNonPowerOfTwoHint(false);

    for (const GLenum mode : {GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE})
        _stateSet->setMode(mode, osg::StateAttribute::OFF);

    _camera->setName(std::string("osgWaterReflect ") + fragmentShader);
    _camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    _camera->setImplicitBufferAttachmentMask(0, 0);
    _camera->attach(osg::Camera::COLOR_BUFFER0, _image);
    _stage->setCamera(_camera);
    _stage->setViewport(new osg::Viewport);
    _camera->setViewport(_stage->getViewport());
    // Without it in the state, OSG falls back to the size that its viewports are made with.
    _stateSet->setAttribute(_stage->getViewport());
    _stage->setColorMask(new osg::ColorMask);
    _stage->setClearMask(0);
    const osg::ref_ptr<osg::RefMatrix> identity = new osg::RefMatrix;
    _stage->setInitialViewMatrix(identity);
}

osg::ref_ptr<osg::Program> ImagePass::program(const std::string& fragmentShader)
{
    return sharedProgram("pyramid.vert", fragmentShader);
}

void ImagePass::setInput(unsigned int unit, const char* name, osg::Texture2D* texture)
{
    _stateSet->setTextureAttribute(unit, texture);
    bindings::set(*_stateSet, name, static_cast<int>(unit));
}

void ImagePass::require(osgUtil::RenderStage& stage, const glm::ivec2& size,
                        const glm::ivec2& capacity)
{
    _stateSet->setAttributeAndModes(program(_fragmentShader));
    _stage->getViewport()->setViewport(0, 0, size.x, size.y);
    _camera->resizeAttachments(capacity.x, capacity.y);

    // A stage drops what it draws with each frame.
    _stage->reset();
    _stateGraph->clean();
    osgUtil::StateGraph* const leaves = _stateGraph->find_or_insert(_stateSet);
    const osg::ref_ptr<osg::RefMatrix> identity = new osg::RefMatrix;
    leaves->addLeaf(new osgUtil::RenderLeaf(_triangle, identity, identity));
    _stage->addStateGraph(leaves);
    _stage->sort();
    stage.addPostRenderStage(_stage, INT_MAX);
}

void ImagePass::releaseGLObjects(osg::State* state) const
{
    _stateSet->releaseGLObjects(state);
    _image->releaseGLObjects(state);
    _triangle->releaseGLObjects(state);
    _stage->releaseGLObjects(state);
}

void ImagePass::resizeGLObjectBuffers(unsigned int maxSize)
{
    _stateSet->resizeGLObjectBuffers(maxSize);
    _image->resizeGLObjectBuffers(maxSize);
    _triangle->resizeGLObjectBuffers(maxSize);
    _stage->resizeGLObjectBuffers(maxSize);
}

#ifndef OSGWATERREFLECT_PASSES_IMAGEPASS_H
#define OSGWATERREFLECT_PASSES_IMAGEPASS_H

#include "GLObjects.h"
#include "ImageStage.h"

#include <osg/Camera>
#include <osg/Program>
#include <osg/Texture2D>

#include <glm/vec2.hpp>

#include <string>

namespace osgWaterReflect
{

/// An image computed from other images by a fragment shader.
class ImagePass : public GLObjects
{
public:
    /// fragmentShader  a file of shaders/
    ///   internalFormat, format  of the image, in floats
    ImagePass(const char* fragmentShader, GLint internalFormat, GLenum format);

    /// What computes it; the same for all of a fragment shader.
    static osg::ref_ptr<osg::Program> program(const std::string& fragmentShader);

    /// A texture that the shader reads from a unit, under a name of Bindings.h.
    void setInput(unsigned int unit, const std::string& name, osg::Texture2D* texture);

    /// For uniforms of the shader's own.
    osg::StateSet& stateSet() { return _stage->stateSet(); }

    /// Renders it after a stage and all that is to be rendered after that so far, into the lower
    /// left part of its image.
    ///   size      [pixels] > 0; of that part
    ///   capacity  [pixels] of the whole image, no smaller
    void require(osgUtil::RenderStage& stage, const glm::ivec2& size, const glm::ivec2& capacity);

    osg::Texture2D* image() const { return _image.get(); }

    void releaseGLObjects(osg::State* state) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;

private:
    std::string _fragmentShader;
    osg::ref_ptr<osg::Texture2D> _image;
    osg::ref_ptr<osg::Camera> _camera; // holds the attachment; it is no node of the scene
    osg::ref_ptr<ImageStage> _stage;
};

} // namespace osgWaterReflect

#endif

#include "ShaderProbe.h"

#include "Catch.h"

#include <osgWaterReflect/shaders/ShaderSource.h>

#include <osg/Geometry>
#include <osg/Program>
#include <osg/Texture2D>

namespace
{

std::string assemble(const std::string& functions, const osgWaterReflect::ShaderSlots& slots)
{
    const char* const name = "probe.frag";
    const osgWaterReflect::ShaderReplacement piece(name, functions);
    return osgWaterReflect::assembleShader(name, slots);
}

osg::ref_ptr<osg::Texture2D> floatTexture(int side, const std::vector<osg::Vec4>& values,
                                          std::size_t first)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(side, side, 1, GL_RGBA, GL_FLOAT);
    image->setInternalTextureFormat(GL_RGBA32F_ARB);
    auto* texels = reinterpret_cast<osg::Vec4*>(image->data());
    for (int i = 0; i < side * side; ++i)
        texels[i] = first + i < values.size() ? values[first + i] : osg::Vec4();
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    texture->setInternalFormat(GL_RGBA32F_ARB);
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

} // namespace

ShaderProbe::ShaderProbe(const std::string& functions, const osgWaterReflect::ShaderSlots& slots) :
    _view(SIDE, SIDE, OffscreenView::Format::RGBA32F), _scene(new osg::Group)
{
    osg::ref_ptr<osg::Geometry> quad = osg::createTexturedQuadGeometry(
        osg::Vec3(-1, -1, 0), osg::Vec3(2, 0, 0), osg::Vec3(0, 2, 0));
    quad->setCullingActive(false);
    _scene->addChild(quad);
    _scene->setCullingActive(false);
    _stateSet = _scene->getOrCreateStateSet();

    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::VERTEX, "#version 130\n"
                                                            "void main()\n"
                                                            "{\n"
                                                            "    gl_Position = gl_Vertex;\n"
                                                            "}\n"));
    program->addShader(new osg::Shader(
        osg::Shader::FRAGMENT, "#version 130\n" + assemble(functions, slots) +
                                   "uniform sampler2D probeFirst;\n"
                                   "uniform sampler2D probeSecond;\n"
                                   "out vec4 probeAnswer;\n"
                                   "void main()\n"
                                   "{\n"
                                   "    ivec2 texel = ivec2(gl_FragCoord.xy);\n"
                                   "    probeAnswer = probe(texelFetch(probeFirst, texel, 0),\n"
                                   "                        texelFetch(probeSecond, texel, 0));\n"
                                   "}\n"));
    _stateSet->setAttributeAndModes(program);
    _stateSet->addUniform(new osg::Uniform("probeFirst", 0));
    _stateSet->addUniform(new osg::Uniform("probeSecond", 1));
    _stateSet->setMode(GL_DEPTH_TEST, osg::StateAttribute::OFF);
    _stateSet->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    _stateSet->setMode(GL_BLEND, osg::StateAttribute::OFF);
    // A piece that does not compile draws nothing: this then stays.
    _view.camera().setClearColor(osg::Vec4(-12345.0f, 0, 0, 0));
}

std::vector<osg::Vec4> ShaderProbe::run(const std::vector<osg::Vec4>& first,
                                        const std::vector<osg::Vec4>& second)
{
    std::vector<osg::Vec4> answers;
    for (std::size_t start = 0; start < first.size(); start += SIDE * SIDE)
    {
        _stateSet->setTextureAttribute(0, floatTexture(SIDE, first, start));
        _stateSet->setTextureAttribute(1, floatTexture(SIDE, second, start));
        const osg::Image& image = _view.render(_scene);
        const auto* texels = reinterpret_cast<const osg::Vec4*>(image.data());
        const std::size_t count = std::min<std::size_t>(SIDE * SIDE, first.size() - start);
        REQUIRE(texels[0].x() != -12345.0f);
        answers.insert(answers.end(), texels, texels + count);
    }
    return answers;
}

#include "Sky.h"

#include "Arrays.h"

#include <osg/Depth>
#include <osg/Geometry>
#include <osg/Program>
#include <osg/TextureCubeMap>
#include <osgDB/FileNameUtils>
#include <osgDB/ReadFile>

#include <stdexcept>

namespace waterdata
{

namespace
{

const char* const vertexSource = R"(#version 120
varying vec3 direction;

void main()
{
    direction = gl_Vertex.xyz;
    gl_Position = gl_ProjectionMatrix * vec4(mat3(gl_ModelViewMatrix) * gl_Vertex.xyz, 1.0);
    gl_Position.z = 0.0;
}
)";

const char* const fragmentSource = R"(#version 120
uniform samplerCube sky;
varying vec3 direction;

void main()
{
    gl_FragColor = vec4(textureCube(sky, direction).rgb, 1.0);
}
)";

osg::ref_ptr<osg::TextureCubeMap> skyTexture(const std::string& dataDirectory)
{
    const char* const faces[6] = {"posx", "negx", "posy", "negy", "posz", "negz"};
    osg::ref_ptr<osg::TextureCubeMap> texture = new osg::TextureCubeMap;
    for (unsigned int face = 0; face < 6; ++face)
    {
        const std::string name = std::string("sky/") + faces[face] + ".jpg";
        const std::string file = osgDB::concatPaths(dataDirectory, name);
        osg::ref_ptr<osg::Image> image = osgDB::readRefImageFile(file);
        if (!image)
            throw std::runtime_error("cannot read the sky picture " + file);
        image->setFileName(name);
        texture->setImage(face, image);
    }
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_R, osg::Texture::CLAMP_TO_EDGE);
    return texture;
}

osg::ref_ptr<osg::Geometry> boxAroundTheEye(float reach)
{
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (int corner = 0; corner < 8; ++corner)
    {
        const osg::Vec3 unit(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        corners->push_back(unit * reach);
    }
    const GLubyte quads[24] = {1, 3, 7, 5, 0, 4, 6, 2, 2, 6, 7, 3,
                               0, 1, 5, 4, 4, 5, 7, 6, 0, 2, 3, 1};
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setName("sky");
    geometry->setVertexArray(corners);
    geometry->setColorArray(only<osg::Vec4Array>({1.0f, 1.0f, 1.0f, 1.0f}),
                            osg::Array::BIND_OVERALL);
    geometry->addPrimitiveSet(new osg::DrawElementsUByte(GL_QUADS, 24, quads));
    geometry->setCullingActive(false);
    return geometry;
}

}

osg::ref_ptr<osg::Geode> skyBox(const std::string& dataDirectory, float reach)
{
    osg::ref_ptr<osg::Geode> sky = new osg::Geode;
    sky->setName("sky");
    sky->setCullingActive(false);
    sky->addDrawable(boxAroundTheEye(reach));

    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::VERTEX, vertexSource));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, fragmentSource));

    osg::StateSet* state = sky->getOrCreateStateSet();
    state->setAttributeAndModes(program);
    state->addUniform(new osg::Uniform("sky", 0));
    state->setTextureAttributeAndModes(0, skyTexture(dataDirectory));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 1.0, 1.0, false));
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF | osg::StateAttribute::PROTECTED);
    state->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    state->setRenderBinDetails(-1, "RenderBin");
    return sky;
}

}

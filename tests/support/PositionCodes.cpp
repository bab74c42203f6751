#include "PositionCodes.h"

#include <osg/Program>

void positionCodes::paint(osg::Node& node, const osg::Plane& ground)
{
    const char* vertex = R"glsl(#version 130
        varying vec3 placeWorld;
        void main()
        {
            placeWorld = gl_Vertex.xyz;
            gl_Position = gl_ProjectionMatrix * (gl_ModelViewMatrix * gl_Vertex);
        }
    )glsl";
    const char* fragment = R"glsl(#version 130
        uniform vec4 ground;
        uniform float offset;
        varying vec3 placeWorld;
        out vec4 colour;
        void main()
        {
            if (dot(ground, vec4(placeWorld, 1.0)) < 0.0) discard;
            colour = vec4(placeWorld + offset, 1.0);
        }
    )glsl";
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::VERTEX, vertex));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, fragment));

    osg::StateSet* stateSet = node.getOrCreateStateSet();
    stateSet->setAttributeAndModes(program, osg::StateAttribute::ON);
    stateSet->addUniform(new osg::Uniform("ground", osg::Vec4f(ground.asVec4())));
    stateSet->addUniform(new osg::Uniform("offset", static_cast<float>(OFFSET)));
    stateSet->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
}

// Debug colours and black lie in [0, 1]; a place near the far corner would too, but is not used.
bool positionCodes::isPlace(const osg::Vec4& colour)
{
    return colour.r() > 1.0f && colour.g() > 1.0f && colour.b() > 1.0f;
}

osg::Vec3d positionCodes::place(const osg::Vec4& colour)
{
    return osg::Vec3d(colour.r() - OFFSET, colour.g() - OFFSET, colour.b() - OFFSET);
}

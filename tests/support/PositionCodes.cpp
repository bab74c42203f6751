#include "PositionCodes.h"

#include <osg/Program>

void paintPositions(osg::Node& node, double lowestZ)
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
        uniform float lowestZ;
        varying vec3 placeWorld;
        out vec4 colour;
        void main()
        {
            if (placeWorld.z < lowestZ) discard;
            colour = vec4(placeWorld, 1.0);
        }
    )glsl";
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::VERTEX, vertex));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, fragment));

    osg::StateSet* stateSet = node.getOrCreateStateSet();
    stateSet->setAttributeAndModes(program, osg::StateAttribute::ON);
    stateSet->addUniform(new osg::Uniform("lowestZ", static_cast<float>(lowestZ)));
    stateSet->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
}

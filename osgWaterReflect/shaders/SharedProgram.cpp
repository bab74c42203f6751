#include "SharedProgram.h"

#include "ShaderSource.h"

#include <osg/observer_ptr>

#include <mutex>

using namespace osgWaterReflect;

osg::ref_ptr<osg::Program> osgWaterReflect::sharedProgram(const std::string& vertex,
                                                          const std::string& fragment,
                                                          const std::string& waves)
{
    static std::mutex mutex;
    static std::map<std::string, osg::observer_ptr<osg::Program>> programs;

    const std::string name = fragment + (waves.empty() ? "" : " " + waves);
    const std::lock_guard<std::mutex> lock(mutex);
    osg::observer_ptr<osg::Program>& shared =
        programs[vertex + " " + name + ShaderReplacement::all()];
    osg::ref_ptr<osg::Program> program;
    if (shared.lock(program)) return program;

    program = new osg::Program;
    program->setName("osgWaterReflect " + name);
    program->addShader(new osg::Shader(osg::Shader::VERTEX, assembleShader(vertex, waves)));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, assembleShader(fragment, waves)));
    shared = program;
    return program;
}

#include "WaterProgram.h"

#include "../shaders/ShaderSource.h"
#include "Bindings.h"

#include <osg/observer_ptr>

#include <mutex>

using namespace osgWaterReflect;

osg::ref_ptr<osg::Program> osgWaterReflect::waterProgram(const WaveModel* waves)
{
    static std::mutex mutex;
    static std::map<std::string, osg::observer_ptr<osg::Program>> programs;

    const std::string wavesShader = waves ? waves->getShaderName() : "waves_calm.glsl";
    const std::lock_guard<std::mutex> lock(mutex);
    osg::observer_ptr<osg::Program>& shared = programs[wavesShader + ShaderReplacement::all()];
    osg::ref_ptr<osg::Program> program;
    if (shared.lock(program)) return program;

    program = new osg::Program;
    program->setName("osgWaterReflect " + wavesShader);
    program->addShader(
        new osg::Shader(osg::Shader::VERTEX, assembleShader("water.vert", wavesShader)));
    program->addShader(
        new osg::Shader(osg::Shader::FRAGMENT, assembleShader("water.frag", wavesShader)));
    shared = program;
    return program;
}

void osgWaterReflect::setVariant(osg::StateSet& stateSet, Search search, SkySource sky,
                                 WaterSurface::DebugView debugView)
{
    const unsigned int on = osg::StateAttribute::ON | osg::StateAttribute::PROTECTED;
    const auto set = [&](const char* name, int value)
    { stateSet.setDefine(name, std::to_string(value), on); };
    set(bindings::DEFINE_SEARCH, static_cast<int>(search));
    set(bindings::DEFINE_SKY, static_cast<int>(sky));
    set(bindings::DEFINE_OUTPUT, static_cast<int>(debugView));
}

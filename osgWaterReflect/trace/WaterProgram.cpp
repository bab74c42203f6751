#include "WaterProgram.h"

#include "../shaders/SharedProgram.h"
#include "Bindings.h"

using namespace osgWaterReflect;

namespace
{

osg::ref_ptr<osg::Program> programOf(const char* fragmentShader, const WaveModel* waves)
{
    return sharedProgram("water.vert", fragmentShader,
                         waves ? waves->getShaderName() : "waves_calm.glsl");
}

} // namespace

osg::ref_ptr<osg::Program> osgWaterReflect::waterProgram(const WaveModel* waves)
{
    return programOf("water.frag", waves);
}

osg::ref_ptr<osg::Program> osgWaterReflect::traceProgram(const WaveModel* waves)
{
    return programOf("trace.frag", waves);
}

void osgWaterReflect::setVariant(osg::StateSet& stateSet, Search search, Images images,
                                 SkySource sky, WaterSurface::DebugView debugView, Trace trace)
{
    const unsigned int on = osg::StateAttribute::ON | osg::StateAttribute::PROTECTED;
    const auto set = [&](const char* name, int value)
    { stateSet.setDefine(name, std::to_string(value), on); };
    // What samples an image of traces searches for nothing: it is one variant, not three.
    set(bindings::DEFINE_SEARCH,
        static_cast<int>(trace == Trace::SAMPLED ? Search::SEQUENTIAL : search));
    set(bindings::DEFINE_IMAGES, static_cast<int>(images));
    set(bindings::DEFINE_SKY, static_cast<int>(sky));
    set(bindings::DEFINE_OUTPUT, static_cast<int>(debugView));
    set(bindings::DEFINE_TRACE, static_cast<int>(trace));
}

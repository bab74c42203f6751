#include "WaterProgram.h"

#include "../shaders/SharedProgram.h"
#include "Bindings.h"

using namespace osgWaterReflect;

osg::ref_ptr<osg::Program> osgWaterReflect::waterProgram(const WaveModel* waves)
{
    return sharedProgram("water.vert", "water.frag",
                         waves ? waves->getShaderName() : "waves_calm.glsl");
}

void osgWaterReflect::setVariant(osg::StateSet& stateSet, Search search, Images images,
                                 SkySource sky, WaterSurface::DebugView debugView)
{
    const unsigned int on = osg::StateAttribute::ON | osg::StateAttribute::PROTECTED;
    const auto set = [&](const char* name, int value)
    { stateSet.setDefine(name, std::to_string(value), on); };
    set(bindings::DEFINE_SEARCH, static_cast<int>(search));
    set(bindings::DEFINE_IMAGES, static_cast<int>(images));
    set(bindings::DEFINE_SKY, static_cast<int>(sky));
    set(bindings::DEFINE_OUTPUT, static_cast<int>(debugView));
}

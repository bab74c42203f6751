#ifndef OSGWATERREFLECT_TRACE_WATERPROGRAM_H
#define OSGWATERREFLECT_TRACE_WATERPROGRAM_H

#include <osgWaterReflect/ReflectionSettings>
#include <osgWaterReflect/WaterSurface>

#include <osg/Program>
#include <osg/StateSet>

#include <string>

namespace osgWaterReflect
{

/// The wave piece of water that has no wave model.
constexpr const char* CALM_SHADER = "waves_calm.glsl";

/// Where a ray that meets nothing looks for the sky: the values of OSGWR_SKY.
enum class SkySource
{
    CAPTURED = 1,
    CUBE_MAP
};

/// The program of all water with the same wave piece. It exists as long as somebody holds it.
osg::ref_ptr<osg::Program> waterProgram(const std::string& wavesShader);

/// Chooses a variant of the program: one value for each axis.
void setVariant(osg::StateSet& stateSet, Search search, SkySource sky,
                WaterSurface::DebugView debugView);

} // namespace osgWaterReflect

#endif

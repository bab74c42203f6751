#ifndef OSGWATERREFLECT_TRACE_WATERPROGRAM_H
#define OSGWATERREFLECT_TRACE_WATERPROGRAM_H

#include <osgWaterReflect/ReflectionSettings>
#include <osgWaterReflect/WaterSurface>

#include <osg/Program>
#include <osg/StateSet>

#include <string>

namespace osgWaterReflect
{

/// Where a ray that meets nothing looks for the sky: the values of OSGWR_SKY.
enum class SkySource
{
    CAPTURED = 1,
    CUBE_MAP
};

/// How many captures a ray is looked for in: the values of OSGWR_IMAGES.
enum class Images
{
    ONE = 1,
    TWO ///< the eye's and, for what that hides or loses, the mirrored eye's
};

/// Where rays are searched for: the values of OSGWR_TRACE.
enum class Trace
{
    HERE = 1, ///< by each pixel
    SAMPLED   ///< by those of a smaller image first
};

/// The program of all water whose waves have the same GLSL piece; null stands for calm water. It
/// exists as long as somebody holds it.
osg::ref_ptr<osg::Program> waterProgram(const WaveModel* waves);

/// The program that traces such water for the smaller image of Trace::SAMPLED.
osg::ref_ptr<osg::Program> traceProgram(const WaveModel* waves);

/// Chooses a variant of the program: one value for each axis.
void setVariant(osg::StateSet& stateSet, Search search, Images images, SkySource sky,
                WaterSurface::DebugView debugView, Trace trace);

} // namespace osgWaterReflect

#endif

#ifndef OSGWATERREFLECT_TRACE_BINDINGS_H
#define OSGWATERREFLECT_TRACE_BINDINGS_H

#include <osg/StateSet>

/// The C++ side of shaders/interface.glsl: every name that the water's program shares with the
/// scene it lives in, and the texture units.
namespace osgWaterReflect::bindings
{

constexpr const char* DEFINE_SEARCH = "OSGWR_SEARCH";
constexpr const char* DEFINE_SKY = "OSGWR_SKY";
constexpr const char* DEFINE_OUTPUT = "OSGWR_OUTPUT";

constexpr const char* CAPTURE_COLOUR = "osgwr_captureColour";
constexpr const char* CAPTURE_WINDOW_Z = "osgwr_captureWindowZ";
constexpr const char* CAPTURE_SIZE = "osgwr_captureSize";
constexpr const char* CAPTURE_CLIP_FROM_EYE = "osgwr_captureClipFromEye";
constexpr const char* CAPTURE_DEPTH_SCALE = "osgwr_captureDepthScale";
constexpr const char* CAPTURE_PIXEL_EXTENT = "osgwr_capturePixelExtent";
constexpr const char* CLEAR_COLOUR = "osgwr_clearColour";

constexpr const char* PYRAMID = "osgwr_pyramid";
constexpr const char* PYRAMID_SOURCE = "osgwr_pyramidSource";
constexpr const char* PYRAMID_MIDDLE = "osgwr_pyramidMiddle";
constexpr const char* PYRAMID_LARGE = "osgwr_pyramidLarge";

constexpr const char* EYE_POINT_EYE = "osgwr_eyePointEye";
constexpr const char* WORLD_FROM_EYE = "osgwr_worldFromEye";

constexpr const char* NORMAL_EYE_FROM_SURFACE = "osgwr_normalEyeFromSurface";
constexpr const char* SURFACE_FROM_EYE = "osgwr_surfaceFromEye";
constexpr const char* SIDE = "osgwr_side";
constexpr const char* REFRACTIVE_INDEX = "osgwr_refractiveIndex";
constexpr const char* WATER_COLOUR = "osgwr_waterColour";
constexpr const char* THICKNESS = "osgwr_thickness";
constexpr const char* STRIDE = "osgwr_stride";
constexpr const char* SKY = "osgwr_sky";

constexpr const char* WAVES = "osgwr_waves";
constexpr const char* WAVE_COUNT = "osgwr_waveCount";
constexpr const char* WAVE_ITERATIONS = "osgwr_waveIterations";
constexpr const char* WAVE_REACH = "osgwr_waveReach";
constexpr const char* WAVE_RISE = "osgwr_waveRise";

constexpr unsigned int UNIT_CAPTURE_COLOUR = 0;
constexpr unsigned int UNIT_CAPTURE_WINDOW_Z = 1;
constexpr unsigned int UNIT_SKY = 2;
constexpr unsigned int UNIT_PYRAMID = 3;
constexpr unsigned int NUM_UNITS = 4;

/// Sets a uniform that nothing above in the scene graph may override.
template <typename Value>
void set(osg::StateSet& stateSet, const char* name, const Value& value)
{
    osg::Uniform* uniform = stateSet.getUniform(name);
    if (uniform)
        uniform->set(value);
    else
        stateSet.addUniform(new osg::Uniform(name, value),
                            osg::StateAttribute::ON | osg::StateAttribute::PROTECTED);
}

} // namespace osgWaterReflect::bindings

#endif

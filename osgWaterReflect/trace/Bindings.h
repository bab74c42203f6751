#ifndef OSGWATERREFLECT_TRACE_BINDINGS_H
#define OSGWATERREFLECT_TRACE_BINDINGS_H

#include <osg/StateSet>

#include <string>

/// The C++ side of shaders/interface.glsl: every name that the water's program shares with the
/// scene it lives in, and the texture units.
namespace osgWaterReflect::bindings
{

constexpr const char* DEFINE_SEARCH = "OSGWR_SEARCH";
constexpr const char* DEFINE_IMAGES = "OSGWR_IMAGES";
constexpr const char* DEFINE_SKY = "OSGWR_SKY";
constexpr const char* DEFINE_OUTPUT = "OSGWR_OUTPUT";
constexpr const char* DEFINE_TRACE = "OSGWR_TRACE";

constexpr const char* EYE_CAPTURE = "osgwr_eyeCapture";
constexpr const char* MIRROR_CAPTURE = "osgwr_mirrorCapture";
constexpr const char* CLEAR_COLOUR = "osgwr_clearColour";

/// Members of a capture, behind its name.
constexpr const char* COLOUR = ".colour";
constexpr const char* WINDOW_Z = ".windowZ";
constexpr const char* CELLS = ".cells";
constexpr const char* SIZE = ".size";
constexpr const char* IMAGE_FROM_EYE = ".imageFromEye";
constexpr const char* DEPTH_SCALE = ".depthScale";
constexpr const char* PIXEL_EXTENT = ".pixelExtent";
constexpr const char* FIRST_COLUMN = ".firstColumn";

constexpr const char* FRAME_COLOUR = "osgwr_frameColour";
constexpr const char* FRAME_WINDOW_Z = "osgwr_frameWindowZ";
constexpr const char* FRAME_FROM_CAPTURE = "osgwr_frameFromCapture";
constexpr const char* CAPTURE_FAR_GAP = "osgwr_captureFarGap";

constexpr const char* PYRAMID_SOURCE = "osgwr_pyramidSource";
constexpr const char* PYRAMID_SOURCE_SIZE = "osgwr_pyramidSourceSize";
constexpr const char* PYRAMID_MIDDLE = "osgwr_pyramidMiddle";
constexpr const char* PYRAMID_LARGE = "osgwr_pyramidLarge";

constexpr const char* OBLIQUE_WINDOW_Z = "osgwr_obliqueWindowZ";
constexpr const char* STRAIGHTENED = "osgwr_straightened";

constexpr const char* FOUND = "osgwr_found";
constexpr const char* FOUND_FROM_WINDOW = "osgwr_foundFromWindow";
constexpr const char* SHEET = "osgwr_sheet";

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

/// Of the first of a capture's images; colour, windowZ and cells follow one another.
constexpr unsigned int UNIT_EYE_CAPTURE = 0;
constexpr unsigned int UNIT_MIRROR_CAPTURE = 3;
constexpr unsigned int UNIT_SKY = 6;
constexpr unsigned int UNIT_FOUND = 7;
constexpr unsigned int NUM_UNITS = 8;

/// Sets a uniform that nothing above in the scene graph may override.
template <typename Value>
void set(osg::StateSet& stateSet, const std::string& name, const Value& value)
{
    osg::Uniform* uniform = stateSet.getUniform(name);
    if (uniform)
        uniform->set(value);
    else
        stateSet.addUniform(new osg::Uniform(name.c_str(), value),
                            osg::StateAttribute::ON | osg::StateAttribute::PROTECTED);
}

} // namespace osgWaterReflect::bindings

#endif

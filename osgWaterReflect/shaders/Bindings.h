#ifndef OSGWATERREFLECT_SHADERS_BINDINGS_H
#define OSGWATERREFLECT_SHADERS_BINDINGS_H

#include <osg/StateSet>

#include <string>

/// The C++ side of shared/interface.glsl, and of what the default pieces of the slots declare:
/// names that the water's program shares with the scene it lives in, and the texture units. Wave
/// models and effects have those of their own pieces to themselves.
namespace osgWaterReflect::bindings
{

constexpr const char* DEFINE_IMAGES = "OSGWR_IMAGES";
constexpr const char* DEFINE_OUTPUT = "OSGWR_OUTPUT";
constexpr const char* DEFINE_TRACE = "OSGWR_TRACE";

constexpr const char* EYE_CAPTURE = "osgwr_eyeCapture";
constexpr const char* MIRROR_CAPTURE = "osgwr_mirrorCapture";
constexpr const char* CLEAR_COLOUR = "osgwr_clearColour";

/// Members of a capture, behind its name.
constexpr const char* COLOUR = ".colour";
constexpr const char* WINDOW_Z = ".windowZ";
constexpr const char* CELLS = ".cells";
constexpr const char* SKY = ".sky";
constexpr const char* SIZE = ".size";
constexpr const char* IMAGE_FROM_EYE = ".imageFromEye";
constexpr const char* DEPTH_SCALE = ".depthScale";
constexpr const char* PIXEL_EXTENT = ".pixelExtent";
constexpr const char* MIRRORED = ".mirrored";

constexpr const char* FRAME_COLOUR = "osgwr_frameColour";
constexpr const char* FRAME_WINDOW_Z = "osgwr_frameWindowZ";
constexpr const char* FRAME_FROM_CAPTURE = "osgwr_frameFromCapture";
constexpr const char* CAPTURE_FAR_GAP = "osgwr_captureFarGap";

constexpr const char* PYRAMID_SOURCE = "osgwr_pyramidSource";
constexpr const char* PYRAMID_SOURCE_SIZE = "osgwr_pyramidSourceSize";
constexpr const char* PYRAMID_MIDDLE = "osgwr_pyramidMiddle";
constexpr const char* PYRAMID_LARGE = "osgwr_pyramidLarge";

constexpr const char* OBLIQUE_WINDOW_Z = "osgwr_obliqueWindowZ";
constexpr const char* WINDOW_Z_FROM_OBLIQUE = "osgwr_windowZFromOblique";

constexpr const char* SKY_SOURCE_COLOUR = "osgwr_skySourceColour";
constexpr const char* SKY_SOURCE_WINDOW_Z = "osgwr_skySourceWindowZ";
constexpr const char* SKY_SOURCE_SIZE = "osgwr_skySourceSize";
constexpr const char* SKY_UP = "osgwr_skyUp";

constexpr const char* TRACED_RAYS = "osgwr_tracedRays";
constexpr const char* TRACED_FROM_WINDOW = "osgwr_tracedFromWindow";
constexpr const char* SHEET_NUMBER = "osgwr_sheetNumber";

constexpr const char* EYE_POINT_EYE = "osgwr_eyePointEye";

constexpr const char* NORMAL_EYE_FROM_SURFACE = "osgwr_normalEyeFromSurface";
constexpr const char* SURFACE_FROM_EYE = "osgwr_surfaceFromEye";
constexpr const char* EYE_SIDE = "osgwr_eyeSide";
constexpr const char* WATER_REFRACTIVE_INDEX = "osgwr_waterRefractiveIndex";
constexpr const char* HIT_THICKNESS = "osgwr_hitThickness";
constexpr const char* COLUMN_STRIDE = "osgwr_columnStride";

/// Of the first of a capture's images; colour, windowZ, cells and sky follow one another.
constexpr unsigned int UNIT_EYE_CAPTURE = 0;
constexpr unsigned int UNIT_MIRROR_CAPTURE = 4;
constexpr unsigned int UNIT_TRACED_RAYS = 8;
constexpr unsigned int UNIT_EFFECTS = 9; ///< and those after it
constexpr unsigned int NUM_UNITS = 14;

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

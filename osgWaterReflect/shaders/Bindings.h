#ifndef OSGWATERREFLECT_SHADERS_BINDINGS_H
#define OSGWATERREFLECT_SHADERS_BINDINGS_H

#include <osg/StateSet>

#include <string>

/// The C++ side of shared/interface.glsl, and of what the default pieces of the slots declare:
/// names that the water's program shares with the scene it lives in, and the texture units. Wave
/// models and effects have those of their own pieces to themselves. They are strings, for OSG asks
/// for uniforms by strings, and in each frame.
namespace osgWaterReflect::bindings
{

inline const std::string DEFINE_IMAGES = "OSGWR_IMAGES";
inline const std::string DEFINE_OUTPUT = "OSGWR_OUTPUT";
inline const std::string DEFINE_TRACE = "OSGWR_TRACE";

inline const std::string EYE_CAPTURE = "osgwr_eyeCapture";
inline const std::string MIRROR_CAPTURE = "osgwr_mirrorCapture";
inline const std::string CLEAR_COLOUR = "osgwr_clearColour";

/// Members of a capture, behind its name.
inline const std::string COLOUR = ".colour";
inline const std::string WINDOW_Z = ".windowZ";
inline const std::string CELLS = ".cells";
inline const std::string SKY = ".sky";
inline const std::string SIZE = ".size";
inline const std::string IMAGE_FROM_EYE = ".imageFromEye";
inline const std::string DEPTH_SCALE = ".depthScale";
inline const std::string PIXEL_EXTENT = ".pixelExtent";
inline const std::string MIRRORED = ".mirrored";

inline const std::string FRAME_COLOUR = "osgwr_frameColour";
inline const std::string FRAME_WINDOW_Z = "osgwr_frameWindowZ";
inline const std::string FRAME_FROM_CAPTURE = "osgwr_frameFromCapture";
inline const std::string CAPTURE_FAR_GAP = "osgwr_captureFarGap";

inline const std::string PYRAMID_SOURCE = "osgwr_pyramidSource";
inline const std::string PYRAMID_SOURCE_SIZE = "osgwr_pyramidSourceSize";
inline const std::string PYRAMID_MIDDLE = "osgwr_pyramidMiddle";
inline const std::string PYRAMID_LARGE = "osgwr_pyramidLarge";

inline const std::string OBLIQUE_WINDOW_Z = "osgwr_obliqueWindowZ";
inline const std::string WINDOW_Z_FROM_OBLIQUE = "osgwr_windowZFromOblique";

inline const std::string SKY_SOURCE_COLOUR = "osgwr_skySourceColour";
inline const std::string SKY_SOURCE_WINDOW_Z = "osgwr_skySourceWindowZ";
inline const std::string SKY_SOURCE_SIZE = "osgwr_skySourceSize";
inline const std::string SKY_UP = "osgwr_skyUp";

inline const std::string TRACED_RAYS = "osgwr_tracedRays";
inline const std::string TRACED_FROM_WINDOW = "osgwr_tracedFromWindow";
inline const std::string SHEET_NUMBER = "osgwr_sheetNumber";

inline const std::string EYE_POINT_EYE = "osgwr_eyePointEye";

inline const std::string NORMAL_EYE_FROM_SURFACE = "osgwr_normalEyeFromSurface";
inline const std::string SURFACE_FROM_EYE = "osgwr_surfaceFromEye";
inline const std::string EYE_SIDE = "osgwr_eyeSide";
inline const std::string WATER_REFRACTIVE_INDEX = "osgwr_waterRefractiveIndex";
inline const std::string HIT_THICKNESS = "osgwr_hitThickness";
inline const std::string COLUMN_STRIDE = "osgwr_columnStride";

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

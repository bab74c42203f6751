#ifndef OSGWATERVIEWER_WATERLOOK_H
#define OSGWATERVIEWER_WATERLOOK_H

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/WaterSurface>

namespace osgwaterviewer
{

/// What moves the water: TrochoidalWaves::createBreeze says what the values mean.
struct Breeze
{
    double steepness = 0.1; ///< a light breeze
    double length = 2.0;    ///< [m]
    double directionDegrees = 30.0;

    osg::ref_ptr<osgWaterReflect::TrochoidalWaves> createWaves() const
    {
        return osgWaterReflect::TrochoidalWaves::createBreeze(length, steepness, directionDegrees);
    }
};

/// How all waters of the scene look.
struct WaterLook
{
    osgWaterReflect::ReflectionSettings reflection;
    osgWaterReflect::ViewSettings viewSettings;
    osgWaterReflect::WaterOptics optics;
    osgWaterReflect::SurfaceDetail detail;
    osgWaterReflect::WaterSurface::DebugView debugView =
        osgWaterReflect::WaterSurface::DebugView::NONE;
    Breeze breeze;       ///< that of the waves' key, too
    bool moving = false; ///< to begin with

    bool thicknessGiven = false;  ///< by the user, not the default
    bool waveLengthGiven = false; ///< by the user, not the default

    /// Nothing says whether a model is in metres, millimetres or feet: lengths that the user has
    /// not given are scaled to its size, as if it were REFERENCE_SIZE metres wide.
    void fitTo(double modelSize);
    static constexpr double REFERENCE_SIZE = 20.0; // a house and its garden

    /// Whether every value is within its range; the library says which one is not.
    bool check() const;
};

} // namespace osgwaterviewer

#endif

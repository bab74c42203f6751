#ifndef OSGWATERREFLECT_TESTS_SUPPORT_WATERACCESS_H
#define OSGWATERREFLECT_TESTS_SUPPORT_WATERACCESS_H

#include <osgWaterReflect/WaterSurface>

#include <type_traits>

// A water's settings by their type, for tests that do the same to all of them.

inline bool setSettings(osgWaterReflect::WaterSurface& water,
                        const osgWaterReflect::ReflectionSettings& settings)
{
    return water.setReflection(settings);
}
inline bool setSettings(osgWaterReflect::WaterSurface& water,
                        const osgWaterReflect::ViewSettings& settings)
{
    return water.setViewSettings(settings);
}
inline bool setSettings(osgWaterReflect::WaterSurface& water,
                        const osgWaterReflect::WaterOptics& settings)
{
    return water.setOptics(settings);
}
inline bool setSettings(osgWaterReflect::WaterSurface& water,
                        const osgWaterReflect::SurfaceDetail& settings)
{
    return water.setDetail(settings);
}

template <typename Settings>
const Settings& getSettings(const osgWaterReflect::WaterSurface& water)
{
    if constexpr (std::is_same_v<Settings, osgWaterReflect::ReflectionSettings>)
        return water.getReflection();
    else if constexpr (std::is_same_v<Settings, osgWaterReflect::ViewSettings>)
        return water.getViewSettings();
    else if constexpr (std::is_same_v<Settings, osgWaterReflect::WaterOptics>)
        return water.getOptics();
    else
        return water.getDetail();
}

#endif

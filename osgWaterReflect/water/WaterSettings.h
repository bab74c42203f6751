#ifndef OSGWATERREFLECT_WATER_WATERSETTINGS_H
#define OSGWATERREFLECT_WATER_WATERSETTINGS_H

#include <osgWaterReflect/WaterSurface>

namespace osgWaterReflect
{

/// All that decides how one water's reflection is captured and traced in a view: what the water has
/// to itself, and what it shares with the other waters there.
struct WaterSettings : ReflectionSettings, ViewSettings
{
    bool operator==(const WaterSettings& rhs) const
    {
        return ReflectionSettings::operator==(rhs) && ViewSettings::operator==(rhs);
    }
    bool operator!=(const WaterSettings& rhs) const { return !(*this == rhs); }
};

inline WaterSettings settingsAskedFor(const WaterSurface& water)
{
    return {water.getReflection(), water.getViewSettings()};
}

} // namespace osgWaterReflect

#endif

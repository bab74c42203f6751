#include <osgWaterReflect/WaterOptics>

#include "Check.h"

using namespace osgWaterReflect;

bool WaterOptics::check() const
{
    if (!expectRange("WaterOptics::refractiveIndex", refractiveIndex, 1.0, 4.0)) return false;
    for (int i = 0; i < 3; ++i)
        if (!expectRange("WaterOptics::waterColour", waterColour[i], 0.0f, 1.0f)) return false;
    return true;
}

bool WaterOptics::operator==(const WaterOptics& rhs) const
{
    return refractiveIndex == rhs.refractiveIndex && waterColour == rhs.waterColour;
}

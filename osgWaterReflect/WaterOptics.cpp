#include <osgWaterReflect/WaterOptics>

#include "settings/MemberChecks.h"

using namespace osgWaterReflect;

bool WaterOptics::check() const
{
    return checkMembers(*this);
}

bool WaterOptics::operator==(const WaterOptics& rhs) const
{
    return equalMembers(*this, rhs);
}

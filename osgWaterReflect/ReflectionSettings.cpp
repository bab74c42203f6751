#include <osgWaterReflect/ReflectionSettings>

#include "settings/MemberChecks.h"

using namespace osgWaterReflect;

bool ReflectionSettings::check() const
{
    return checkMembers(*this);
}

bool ReflectionSettings::operator==(const ReflectionSettings& rhs) const
{
    return equalMembers(*this, rhs);
}

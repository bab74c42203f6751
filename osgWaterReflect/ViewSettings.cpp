#include <osgWaterReflect/ViewSettings>

#include "settings/MemberChecks.h"

using namespace osgWaterReflect;

bool ViewSettings::check() const
{
    return checkMembers(*this);
}

bool ViewSettings::operator==(const ViewSettings& rhs) const
{
    return equalMembers(*this, rhs);
}

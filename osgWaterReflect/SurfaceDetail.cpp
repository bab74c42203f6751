#include <osgWaterReflect/SurfaceDetail>

#include "settings/MemberChecks.h"

using namespace osgWaterReflect;

bool SurfaceDetail::check() const
{
    return checkMembers(*this);
}

bool SurfaceDetail::operator==(const SurfaceDetail& rhs) const
{
    return equalMembers(*this, rhs);
}

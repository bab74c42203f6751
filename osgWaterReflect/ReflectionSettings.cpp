#include <osgWaterReflect/ReflectionSettings>

#include "Check.h"

using namespace osgWaterReflect;

bool ReflectionSettings::check() const
{
    if (search != Search::SEQUENTIAL && search != Search::BINARY &&
        search != Search::HIERARCHICAL && search != Search::AUTOMATIC)
        return refuse("ReflectionSettings::search", "a member of Search", static_cast<int>(search));
    if (capture != CaptureKind::VIEW && capture != CaptureKind::FRAME &&
        capture != CaptureKind::MIRROR && capture != CaptureKind::VIEW_AND_MIRROR &&
        capture != CaptureKind::AUTOMATIC)
        return refuse("ReflectionSettings::capture", "a member of CaptureKind",
                      static_cast<int>(capture));
    if (!expectPositive("ReflectionSettings::thickness", thickness)) return false;
    return expectRange("ReflectionSettings::stride", stride, 1, 64);
}

bool ReflectionSettings::operator==(const ReflectionSettings& rhs) const
{
    return search == rhs.search && capture == rhs.capture && thickness == rhs.thickness &&
           stride == rhs.stride;
}

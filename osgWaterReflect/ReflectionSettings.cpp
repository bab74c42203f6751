#include <osgWaterReflect/ReflectionSettings>

#include "Check.h"

#include <cmath>

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
    if (!expectRange("ReflectionSettings::stride", stride, 1, 64)) return false;
    if (!(captureScale > 0.0 && captureScale <= 1.0))
        return refuse("ReflectionSettings::captureScale", "a value in (0, 1]", captureScale);
    if (!(traceScale > 0.0 && traceScale <= 1.0))
        return refuse("ReflectionSettings::traceScale", "a value in (0, 1]", traceScale);
    if (guardBand != GuardBandKind::NONE && guardBand != GuardBandKind::ADAPTIVE &&
        guardBand != GuardBandKind::FIXED)
        return refuse("ReflectionSettings::guardBand", "a member of GuardBandKind",
                      static_cast<int>(guardBand));
    if (!expectRange("ReflectionSettings::maxExtraPixels", maxExtraPixels, 0.0, 3.0)) return false;
    if (!expectRange("ReflectionSettings::guardBandShare", guardBandShare, 0.0, 1.0)) return false;
    return (std::isfinite(frameTimeTarget) && frameTimeTarget >= 0.0) ||
           refuse("ReflectionSettings::frameTimeTarget", "a finite value >= 0", frameTimeTarget);
}

bool ReflectionSettings::operator==(const ReflectionSettings& rhs) const
{
    return search == rhs.search && capture == rhs.capture && thickness == rhs.thickness &&
           stride == rhs.stride && captureScale == rhs.captureScale && guardBand == rhs.guardBand &&
           maxExtraPixels == rhs.maxExtraPixels && guardBandShare == rhs.guardBandShare &&
           traceScale == rhs.traceScale && frameTimeTarget == rhs.frameTimeTarget;
}

#include <osgWaterReflect/ViewSettings>

#include "Check.h"

#include <cmath>

using namespace osgWaterReflect;

bool ViewSettings::check() const
{
    if (!(captureScale > 0.0 && captureScale <= 1.0))
        return refuse("ViewSettings::captureScale", "a value in (0, 1]", captureScale);
    if (!(traceScale > 0.0 && traceScale <= 1.0))
        return refuse("ViewSettings::traceScale", "a value in (0, 1]", traceScale);
    if (guardBand != GuardBandKind::NONE && guardBand != GuardBandKind::ADAPTIVE &&
        guardBand != GuardBandKind::FIXED)
        return refuse("ViewSettings::guardBand", "a member of GuardBandKind",
                      static_cast<int>(guardBand));
    if (!expectRange("ViewSettings::maxExtraPixels", maxExtraPixels, 0.0, 3.0)) return false;
    if (!expectRange("ViewSettings::guardBandShare", guardBandShare, 0.0, 1.0)) return false;
    return (std::isfinite(frameTimeTarget) && frameTimeTarget >= 0.0) ||
           refuse("ViewSettings::frameTimeTarget", "a finite value >= 0", frameTimeTarget);
}

bool ViewSettings::operator==(const ViewSettings& rhs) const
{
    return captureScale == rhs.captureScale && traceScale == rhs.traceScale &&
           guardBand == rhs.guardBand && maxExtraPixels == rhs.maxExtraPixels &&
           guardBandShare == rhs.guardBandShare && frameTimeTarget == rhs.frameTimeTarget;
}

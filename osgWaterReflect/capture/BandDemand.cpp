#include "BandDemand.h"

#include "../surface/EyeHeight.h"
#include "../surface/StillWater.h"
#include "ReflectedExtent.h"

#include <osgWaterReflect/WaterSurface>

#include <glm/common.hpp>

#include <algorithm>

using namespace osgWaterReflect;

namespace
{

// Slopes up to this times their root mean square are those of all but the steepest places: of a
// sum of many waves' places 98 %.
const double MOST_SLOPES = 2.0;

// [pixels] No side of a capture is longer: what GL 4.1 and later promise.
const int MAX_TEXTURE_SIZE = 16384;

// Cuts the two bands of a direction down alike.
void cutTo(int room, int& first, int& second)
{
    const int both = first + second;
    if (both <= room) return;
    const double share = std::max(room, 0) / static_cast<double>(both);
    first = static_cast<int>(share * first);
    second = static_cast<int>(share * second);
}

struct Reflected
{
    NdcExtent byAll;
    NdcExtent byMost; // but for the steepest places
};

Reflected reflectedBy(const MetWater& met, const glm::dmat4& clipFromEye, double time)
{
    const WaveModel* const waves = met.water->getWaves();
    const double maxSlope = waves ? waves->getMaxSlope() : 0.0;
    const double mostSlopes = waves ? std::min(MOST_SLOPES * waves->getRmsSlope(), maxSlope) : 0.0;
    Reflected reflected;
    for (const osg::ref_ptr<StillWater>& still : *met.sheets)
    {
        ReflectingSheet sheet;
        sheet.hull = still->hull();
        sheet.eyeFromSurface = met.eyeFromLocal * still->localFromSurface();
        sheet.amplitude = waves ? waves->getAmplitude() : 0.0;
        const double height = heightOfEye(sheet.eyeFromSurface, clipFromEye, waves, time);
        sheet.side = height < 0.0 ? -1.0 : 1.0;
        sheet.maxSlope = maxSlope;
        const NdcExtent byAll = reflectedExtent(sheet, clipFromEye);
        sheet.maxSlope = mostSlopes;
        reflected.byAll = unite(reflected.byAll, byAll);
        reflected.byMost = unite(
            reflected.byMost, mostSlopes < maxSlope ? reflectedExtent(sheet, clipFromEye) : byAll);
    }
    return reflected;
}

// The view with a band of shares of its size on each side.
NdcExtent widenedBy(double share)
{
    const double side = 1.0 + 2.0 * share;
    return {-side, side, -side, side};
}

// What of it is worth capturing.
NdcExtent needed(const NdcExtent& reflected, const NdcExtent& scene)
{
    return unite(NdcExtent(), intersect(reflected, scene));
}

} // namespace

BandDemand::BandDemand(const std::vector<MetWater>& waters, const glm::dmat4& clipFromEye,
                       double time)
{
    for (const MetWater& met : waters)
    {
        const ReflectionSettings& settings = met.settings;
        if (settings.capture == CaptureKind::MIRROR) continue; // it is not looked for in this one
        _seesDrawnSky = _seesDrawnSky || !met.water->getSky();
        if (settings.guardBand == GuardBandKind::FIXED)
            _fixedShare = std::max(_fixedShare, settings.guardBandShare);
        if (settings.guardBand != GuardBandKind::ADAPTIVE || settings.maxExtraPixels == 0.0)
            continue;
        _maxExtraPixels = std::max(_maxExtraPixels, settings.maxExtraPixels);
        const Reflected reflected = reflectedBy(met, clipFromEye, time);
        _reflected = unite(_reflected, reflected.byAll);
        _mostlyReflected = unite(_mostlyReflected, reflected.byMost);
    }
    const NdcExtent view;
    _adapts = _reflected.left < view.left || _reflected.right > view.right ||
              _reflected.bottom < view.bottom || _reflected.top > view.top;
}

// A side may have all of the extra pixels.
NdcExtent BandDemand::possible() const
{
    return unite(widenedBy(_fixedShare), intersect(_reflected, widenedBy(_maxExtraPixels)));
}

bool BandDemand::serves(const NdcExtent& scene, const glm::ivec2& viewSize) const
{
    bool cut = false;
    const GuardBand most =
        bandFor(needed(_mostlyReflected, scene), viewSize, _maxExtraPixels, &cut);
    const GuardBand given = bandFor(needed(_reflected, scene), viewSize, _maxExtraPixels);
    return !cut && most.left <= given.left && most.right <= given.right &&
           most.bottom <= given.bottom && most.top <= given.top;
}

GuardBand BandDemand::band(const NdcExtent& scene, const glm::ivec2& viewSize) const
{
    const GuardBand adapted = bandFor(needed(_reflected, scene), viewSize, _maxExtraPixels);
    const GuardBand fixed = fixedBand(viewSize);
    GuardBand band = {std::max(adapted.left, fixed.left), std::max(adapted.right, fixed.right),
                      std::max(adapted.bottom, fixed.bottom), std::max(adapted.top, fixed.top)};
    cutTo(MAX_TEXTURE_SIZE - viewSize.x, band.left, band.right);
    cutTo(MAX_TEXTURE_SIZE - viewSize.y, band.bottom, band.top);
    return band;
}

// Never cut down: with a whole side each, it has nine times the view's pixels.
GuardBand BandDemand::fixedBand(const glm::ivec2& viewSize) const
{
    return bandFor(widenedBy(_fixedShare), viewSize, 8.0);
}

// The adapted band may have all its pixels on one side, where the other has the fixed band's.
glm::ivec2 BandDemand::largestSize(const glm::ivec2& viewSize) const
{
    const GuardBand band = fixedBand(viewSize);
    const glm::ivec2 fixed(band.left, band.bottom);
    const glm::ivec2 adapted(glm::ceil(_maxExtraPixels * glm::dvec2(viewSize)));
    return glm::max(viewSize,
                    glm::min(viewSize + fixed + glm::max(fixed, adapted), MAX_TEXTURE_SIZE));
}

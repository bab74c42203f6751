#include "GuardBandRequest.h"

#include <glm/common.hpp>

#include <algorithm>

using namespace osgWaterReflect;

namespace
{

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

bool GuardBandRequest::asksForReach(const ViewSettings& settings)
{
    return settings.guardBand == GuardBandKind::ADAPTIVE && settings.maxExtraPixels > 0.0;
}

void GuardBandRequest::add(const ViewSettings& settings, const NdcExtent& reflected)
{
    if (settings.guardBand == GuardBandKind::FIXED)
        _fixedShare = std::max(_fixedShare, settings.guardBandShare);
    if (!asksForReach(settings)) return;
    _maxExtraPixels = std::max(_maxExtraPixels, settings.maxExtraPixels);
    _reflected = unite(_reflected, reflected);
}

bool GuardBandRequest::adapts() const
{
    return !contains(NdcExtent(), _reflected);
}

// A side may have all of the extra pixels.
NdcExtent GuardBandRequest::possible() const
{
    return unite(widenedBy(_fixedShare), intersect(_reflected, widenedBy(_maxExtraPixels)));
}

bool GuardBandRequest::serves(const NdcExtent& rays, const NdcExtent& scene,
                              const glm::ivec2& viewSize) const
{
    return reaches(band(scene, viewSize), needed(rays, scene), viewSize);
}

GuardBand GuardBandRequest::band(const NdcExtent& scene, const glm::ivec2& viewSize) const
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
GuardBand GuardBandRequest::fixedBand(const glm::ivec2& viewSize) const
{
    return bandFor(widenedBy(_fixedShare), viewSize, 8.0);
}

// The adapted band may have all its pixels on one side, where the other has the fixed band's.
glm::ivec2 GuardBandRequest::largestSize(const glm::ivec2& viewSize) const
{
    const GuardBand band = fixedBand(viewSize);
    const glm::ivec2 fixed(band.left, band.bottom);
    const glm::ivec2 adapted(glm::ceil(_maxExtraPixels * glm::dvec2(viewSize)));
    return glm::max(viewSize,
                    glm::min(viewSize + fixed + glm::max(fixed, adapted), MAX_TEXTURE_SIZE));
}

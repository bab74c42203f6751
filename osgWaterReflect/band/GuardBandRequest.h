#ifndef OSGWATERREFLECT_BAND_GUARDBANDREQUEST_H
#define OSGWATERREFLECT_BAND_GUARDBANDREQUEST_H

#include "GuardBand.h"

#include <osgWaterReflect/ViewSettings>

namespace osgWaterReflect
{

/// What the waters of a view ask of the guard band of its eye's image, together.
class GuardBandRequest
{
public:
    /// Adds one sheet of water.
    ///   reflected  how far its rays reach; asked for where its band is ADAPTIVE
    void add(const ViewSettings& settings, const NdcExtent& reflected);

    /// Adds water whose rays may see the sky that the scene draws.
    void addDrawnSky() { _seesDrawnSky = true; }

    /// Whether how far a sheet's rays reach makes a difference.
    static bool asksForReach(const ViewSettings& settings);

    /// What may have to be captured, whatever the scene holds.
    NdcExtent possible() const;

    /// How far the rays of ADAPTIVE bands reach, were the scene infinitely large.
    const NdcExtent& reflected() const { return _reflected; }

    /// Whether any of it depends on what the scene holds.
    bool adapts() const;

    /// Whether rays may see the sky that the scene draws.
    bool seesDrawnSky() const { return _seesDrawnSky; }

    /// [pixels] What of it is captured where the scene reaches so far.
    GuardBand band(const NdcExtent& scene, const glm::ivec2& viewSize) const;

    /// Whether that reaches as far as rays do that go up to an extent, where there is a scene.
    bool serves(const NdcExtent& rays, const NdcExtent& scene, const glm::ivec2& viewSize) const;

    /// [pixels] The widest and the tallest image that any band of these settings makes.
    glm::ivec2 largestSize(const glm::ivec2& viewSize) const;

private:
    GuardBand fixedBand(const glm::ivec2& viewSize) const;

    NdcExtent _reflected; // of ADAPTIVE bands
    double _fixedShare = 0.0;
    double _maxExtraPixels = 0.0;
    bool _seesDrawnSky = false;
};

} // namespace osgWaterReflect

#endif

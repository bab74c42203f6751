#ifndef OSGWATERREFLECT_CAPTURE_BANDDEMAND_H
#define OSGWATERREFLECT_CAPTURE_BANDDEMAND_H

#include "CaptureVisitor.h"
#include "GuardBand.h"

namespace osgWaterReflect
{

/// What the waters of a view ask of its capture's guard band, together.
class BandDemand
{
public:
    /// waters       whose settings and waves count
    ///   clipFromEye  the view's
    ///   time         [s]
    BandDemand(const std::vector<MetWater>& waters, const glm::dmat4& clipFromEye, double time);

    /// What may have to be captured, whatever the scene holds.
    NdcExtent possible() const;

    /// Whether any of it depends on what the scene holds.
    bool adapts() const { return _adapts; }

    /// Whether rays may see the sky that the scene draws.
    bool seesDrawnSky() const { return _seesDrawnSky; }

    /// [pixels] What of it is captured where the scene reaches so far.
    GuardBand band(const NdcExtent& scene, const glm::ivec2& viewSize) const;

    /// Whether an ADAPTIVE band, cut down to its ceiling, reaches as far as the rays of all but the
    /// steepest places of waves.
    bool serves(const NdcExtent& scene, const glm::ivec2& viewSize) const;

    /// [pixels] The widest and the tallest image that any band of these waters' settings makes.
    glm::ivec2 largestSize(const glm::ivec2& viewSize) const;

private:
    GuardBand fixedBand(const glm::ivec2& viewSize) const;

    NdcExtent _reflected;       // of ADAPTIVE bands
    NdcExtent _mostlyReflected; // but for the steepest places
    double _fixedShare = 0.0;
    double _maxExtraPixels = 0.0;
    bool _adapts = false;
    bool _seesDrawnSky = false;
};

} // namespace osgWaterReflect

#endif

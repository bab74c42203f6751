#ifndef OSGWATERREFLECT_SURFACE_WAVEBOUNDS_H
#define OSGWATERREFLECT_SURFACE_WAVEBOUNDS_H

#include "ChordErrors.h"

namespace osgWaterReflect
{

/// What is asked of a water's waves in every frame and does not change with time: taken from the
/// model when the water is given it.
struct WaveBounds
{
    double amplitude = 0.0;    ///< [surface units]
    double maxSlope = 0.0;     ///< [1]
    double rmsSlope = 0.0;     ///< [1]
    double shortestEdge = 0.0; ///< [surface units] of a mesh: finer serves no wave
    ChordErrors chordErrors;   ///< of edges no shorter than that

    /// Those of calm water.
    WaveBounds() = default;

    ///   waves  null for calm water
    explicit WaveBounds(const WaveModel* waves);

    bool calm() const { return maxSlope == 0.0; }
};

} // namespace osgWaterReflect

#endif

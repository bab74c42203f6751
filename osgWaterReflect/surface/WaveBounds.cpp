#include "WaveBounds.h"

using namespace osgWaterReflect;

namespace
{

// Waves need no mesh finer than this part of the shortest.
const double EDGES_PER_WAVE = 8.0;

} // namespace

WaveBounds::WaveBounds(const WaveModel* waves)
{
    if (!waves) return;
    amplitude = waves->getAmplitude();
    maxSlope = waves->getMaxSlope();
    rmsSlope = waves->getRmsSlope();
    shortestEdge = waves->getShortestLength() / EDGES_PER_WAVE;
    chordErrors = ChordErrors(*waves, shortestEdge);
}

// How a texel of the small image (water/LowResTrace.h) holds what came of its ray.

struct TracedRay
{
    float rayLength;      // to where a search ended at something [world units]
    int reason;           // REASON_…
    bool mirrored;        // of a hit: in the mirrored eye's capture
    float hidden;         // TraceResult's [windowZ]
    float sheet;          // number of its sheet of water; 0: there is none
    float fetches;        // of depths, where they are counted
};

// A reason takes less than 16; above it stands whether the mirrored eye's capture showed a hit, and
// above that the number of fetches.
const float MIRRORED = 16.0;
const float REASONS = 32.0;

// The texel of a ray that has been looked for.
vec4 texelOf(Sighting sighting, bool mirrored)
{
    TraceResult result = sighting.result;
    float coded = float(result.reason) + (mirrored ? MIRRORED : 0.0);
#if OSGWR_OUTPUT == OUTPUT_HIT
    coded += REASONS * float(depthFetches);
#endif
    return vec4(rayLengthAt(sighting.ray, result.s), coded, result.hidden, sheetNumber);
}

// The ray that a texel holds.
TracedRay tracedRayOf(vec4 coded)
{
    float fetches = floor(coded.y / REASONS);
    float reason = coded.y - REASONS * fetches;
    bool mirrored = reason >= MIRRORED;
    return TracedRay(coded.x, int(mirrored ? reason - MIRRORED : reason), mirrored, coded.z,
                     coded.a, fetches);
}

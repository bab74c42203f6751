// The water's surface, by place p in the still plane [m].

// Its slope (dh/dx, dh/dy) about a place.
struct WaveSlope
{
    vec2 mean;            // over a pixel
    vec3 covariance;      // of the slopes that this averages away: xx, yy, xy
};

// The waves themselves:
//   float waveHeight(vec2 p)     over the still level [m]
//   float highestWave()          no crest or trough is farther from the still level [m]
//   WaveSlope waveSlope(vec2 p, vec2 dPdx, vec2 dPdy)     over the pixel that these sides span [m],
//                                at the place itself where they are zero
#include "waves"

// Unit normal in surface space.
vec3 normalOf(vec2 slope)
{
    return normalize(vec3(-slope, 1.0));
}

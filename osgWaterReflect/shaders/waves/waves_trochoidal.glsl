// A sum of trochoidal (Gerstner) waves in deep water, asked by the place where the surface is,
// not by the place where the water particle rests [Tessendorf01 3].
//
// A particle resting at r is found at  p = r + D(r),  D = -sum b_i k_i sin(theta_i),
// at the height  sum a_i cos(theta_i) + rise,  theta_i = k_i . r + phase_i,  b_i = a_i / |k_i|.

#define MAX_WAVE_TERMS 32
uniform vec4 osgwr_waveTerms[MAX_WAVE_TERMS]; // wave vector k_i [rad/m], b_i [m^2], phase at p = 0 [rad]
uniform int osgwr_waveTermCount;
uniform int osgwr_waveNewtonSteps;            // to the rest place
uniform float osgwr_waveReach;                // [m] sum of the amplitudes: no particle strays further
uniform float osgwr_waveRise;                 // [m] lifts the mean height to 0

// Loops over the waves count down, for Mesa takes the array's size for the number of turns of one
// that counts up, and runs them all.

// What the sum does at a rest place.
struct WaveSum
{
    vec2 displacement;
    vec3 jacobian;        // xx, yy, xy of I + dD/dr
};

WaveSum sumWaves(vec2 rest)
{
    WaveSum sum;
    sum.displacement = vec2(0.0);
    sum.jacobian = vec3(1.0, 1.0, 0.0);
    for (int i = osgwr_waveTermCount - 1; i >= 0; --i)
    {
        vec2 k = osgwr_waveTerms[i].xy;
        float theta = dot(k, rest) + osgwr_waveTerms[i].w;
        sum.displacement -= k * (osgwr_waveTerms[i].z * sin(theta));
        sum.jacobian -= vec3(k * k, k.x * k.y) * (osgwr_waveTerms[i].z * cos(theta));
    }
    return sum;
}

// The rest place of the particle found at p. It minimises a strictly convex function, for D is
// the gradient of a potential and the steepness sum is under 1. Newton's steps overshoot near sharp
// crests; kept within the reach of the waves about p, where the minimum is, they do not. The error
// by steepness and number of steps is measured in docs/waves.md.
vec2 restPlace(vec2 p)
{
    vec2 offset = vec2(0.0);
    for (int step = 0; step < osgwr_waveNewtonSteps; ++step)
    {
        WaveSum sum = sumWaves(p + offset);
        vec2 residual = -offset - sum.displacement;
        vec3 j = sum.jacobian;
        offset += vec2(j.y * residual.x - j.z * residual.y, j.x * residual.y - j.z * residual.x) /
                  (j.x * j.y - j.z * j.z);
        offset *= min(1.0, osgwr_waveReach / max(length(offset), 1e-30));
    }
    return p + offset;
}

// Height above the still level [m].
float waveHeight(vec2 p)
{
    vec2 rest = restPlace(p);
    float height = osgwr_waveRise;
    for (int i = osgwr_waveTermCount - 1; i >= 0; --i)
    {
        vec2 k = osgwr_waveTerms[i].xy;
        height += length(k) * osgwr_waveTerms[i].z * cos(dot(k, rest) + osgwr_waveTerms[i].w);
    }
    return height;
}

// No crest or trough is farther from the still level [m].
float highestWave()
{
    return osgwr_waveReach + abs(osgwr_waveRise);
}

// Share of a wave's amplitude left after averaging over a pixel's footprint: a Gaussian of half a
// pixel's standard deviation leaves exp(-variance / 2) of a sine. Far waves turn smooth instead
// of noisy.
float pixelAverage(vec2 k, vec2 dPdx, vec2 dPdy)
{
    vec2 phasePerPixel = vec2(dot(k, dPdx), dot(k, dPdy));
    return exp(-0.125 * dot(phasePerPixel, phasePerPixel));
}

// The covariance is that of sines of these amplitudes, and the mean over where the pixel lies in
// each: to leading order in the steepness.
WaveSlope waveSlope(vec2 p, vec2 dPdx, vec2 dPdy)
{
    vec2 rest = restPlace(p);
    vec2 gradient = vec2(0.0);           // of the height, by the rest place
    vec3 jacobian = vec3(1.0, 1.0, 0.0);
    vec3 covariance = vec3(0.0);
    for (int i = osgwr_waveTermCount - 1; i >= 0; --i)
    {
        vec2 k = osgwr_waveTerms[i].xy;
        float theta = dot(k, rest) + osgwr_waveTerms[i].w;
        float left = pixelAverage(k, dPdx, dPdy);
        float b = osgwr_waveTerms[i].z * left;
        gradient -= k * (length(k) * b * sin(theta));
        jacobian -= vec3(k * k, k.x * k.y) * (b * cos(theta));
        vec2 steepness = k * (length(k) * osgwr_waveTerms[i].z);
        covariance += 0.5 * (1.0 - left * left) *
                      vec3(steepness * steepness, steepness.x * steepness.y);
    }
    // Above 0, but for rounding at the sharpest of crests.
    float determinant = max(jacobian.x * jacobian.y - jacobian.z * jacobian.z, 1e-12);
    WaveSlope slope;
    slope.mean = vec2(jacobian.y * gradient.x - jacobian.z * gradient.y,
                      jacobian.x * gradient.y - jacobian.z * gradient.x) / determinant;
    slope.covariance = covariance;
    return slope;
}

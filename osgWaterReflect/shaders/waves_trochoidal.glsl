// A sum of trochoidal (Gerstner) waves in deep water, asked by the place where the surface is,
// not by the place where the water particle rests [Tessendorf01 3].
//
// A particle resting at r is found at  p = r + D(r),  D = -sum b_i k_i sin(theta_i),
// at the height  sum a_i cos(theta_i) + rise,  theta_i = k_i . r + phase_i,  b_i = a_i / |k_i|.

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
    for (int i = waveCount - 1; i >= 0; --i)
    {
        vec2 k = waves[i].xy;
        float theta = dot(k, rest) + waves[i].w;
        sum.displacement -= k * (waves[i].z * sin(theta));
        sum.jacobian -= vec3(k * k, k.x * k.y) * (waves[i].z * cos(theta));
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
    for (int step = 0; step < waveIterations; ++step)
    {
        WaveSum sum = sumWaves(p + offset);
        vec2 residual = -offset - sum.displacement;
        vec3 j = sum.jacobian;
        offset += vec2(j.y * residual.x - j.z * residual.y, j.x * residual.y - j.z * residual.x) /
                  (j.x * j.y - j.z * j.z);
        offset *= min(1.0, waveReach / max(length(offset), 1e-30));
    }
    return p + offset;
}

// Height above the still level [m].
float waveHeight(vec2 p)
{
    vec2 rest = restPlace(p);
    float height = waveRise;
    for (int i = waveCount - 1; i >= 0; --i)
    {
        vec2 k = waves[i].xy;
        height += length(k) * waves[i].z * cos(dot(k, rest) + waves[i].w);
    }
    return height;
}

// No crest or trough is farther from the still level [m].
float highestWave()
{
    return waveReach + abs(waveRise);
}

// Share of a wave's amplitude left after averaging over a pixel's footprint: a Gaussian of half a
// pixel's standard deviation leaves exp(-variance / 2) of a sine. Far waves turn smooth instead
// of noisy.
float pixelAverage(vec2 k, vec2 dPdx, vec2 dPdy)
{
    vec2 phasePerPixel = vec2(dot(k, dPdx), dot(k, dPdy));
    return exp(-0.125 * dot(phasePerPixel, phasePerPixel));
}

// Unit normal in surface space, averaged over the pixel whose sides are dPdx and dPdy [m];
// pass zero for the normal at the point itself.
vec3 waveNormal(vec2 p, vec2 dPdx, vec2 dPdy)
{
    vec2 rest = restPlace(p);
    vec2 gradient = vec2(0.0);           // of the height, by the rest place
    vec3 jacobian = vec3(1.0, 1.0, 0.0);
    for (int i = waveCount - 1; i >= 0; --i)
    {
        vec2 k = waves[i].xy;
        float theta = dot(k, rest) + waves[i].w;
        float b = waves[i].z * pixelAverage(k, dPdx, dPdy);
        gradient -= k * (length(k) * b * sin(theta));
        jacobian -= vec3(k * k, k.x * k.y) * (b * cos(theta));
    }
    // slope = inverse(jacobian) * gradient; the determinant, above 0, goes into the z component.
    float determinant = jacobian.x * jacobian.y - jacobian.z * jacobian.z;
    return normalize(vec3(jacobian.z * gradient.y - jacobian.y * gradient.x,
                          jacobian.z * gradient.x - jacobian.x * gradient.y, determinant));
}

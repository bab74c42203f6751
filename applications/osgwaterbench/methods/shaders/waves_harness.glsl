// Flat water with the normals of waves: the slope is a sum of cosines. HarnessWaves says what for.

#define BENCH_MAX_WAVES 8
uniform vec4 bench_waves[BENCH_MAX_WAVES]; // wave vector [rad/m], slope over wave number [m], phase at p = 0 [rad]
uniform int bench_waveCount;

float waveHeight(vec2 p)
{
    return 0.0;
}

float highestWave()
{
    return 0.0;
}

// At the point itself, not averaged over the pixel.
WaveSlope waveSlope(vec2 p, vec2 dPdx, vec2 dPdy)
{
    vec2 slope = vec2(0.0);
    for (int i = 0; i < bench_waveCount; ++i)
    {
        vec2 k = bench_waves[i].xy;
        slope += k * (bench_waves[i].z * cos(dot(k, p) + bench_waves[i].w));
    }
    return WaveSlope(slope, vec3(0.0));
}

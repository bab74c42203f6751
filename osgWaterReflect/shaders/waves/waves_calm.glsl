// Still water, as a wave model: the compiler folds all of it away.

float waveHeight(vec2 p)
{
    return 0.0;
}

float highestWave()
{
    return 0.0;
}

WaveSlope waveSlope(vec2 p, vec2 dPdx, vec2 dPdy)
{
    return WaveSlope(vec2(0.0), vec3(0.0));
}

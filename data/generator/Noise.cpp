#include "Noise.h"

#include <osg/Math>

#include <cmath>
#include <cstdint>

namespace waterdata
{

namespace
{

float latticeValue(int x, int y, int z)
{
    std::uint32_t hash = static_cast<std::uint32_t>(x) * 0x8da6b343u
                       ^ static_cast<std::uint32_t>(y) * 0xd8163841u
                       ^ static_cast<std::uint32_t>(z) * 0xcb1ab31fu;
    hash = (hash ^ (hash >> 15)) * 0x2c1b3c6du;
    hash = (hash ^ (hash >> 12)) * 0x297a2d39u;
    hash ^= hash >> 15;
    return static_cast<float>(hash >> 8) * (2.0f / 16777216.0f) - 1.0f;
}

float fade(float t)
{
    return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

}

float mix(float a, float b, float share)
{
    return a + (b - a) * share;
}

osg::Vec3 mix(const osg::Vec3& a, const osg::Vec3& b, float share)
{
    return a + (b - a) * share;
}

float smoothStep(float low, float high, float value)
{
    const float t = osg::clampBetween((value - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

float noise(const osg::Vec3& point)
{
    const osg::Vec3 cell(std::floor(point.x()), std::floor(point.y()), std::floor(point.z()));
    const int x = static_cast<int>(cell.x());
    const int y = static_cast<int>(cell.y());
    const int z = static_cast<int>(cell.z());
    const osg::Vec3 inside = point - cell;
    const float u = fade(inside.x());
    const float v = fade(inside.y());
    const float w = fade(inside.z());

    auto row = [&](int dy, int dz)
    {
        return mix(latticeValue(x, y + dy, z + dz), latticeValue(x + 1, y + dy, z + dz), u);
    };
    return mix(mix(row(0, 0), row(1, 0), v), mix(row(0, 1), row(1, 1), v), w);
}

float fractalNoise(const osg::Vec3& point, int octaves)
{
    float sum = 0.0f;
    float strength = 0.5f;
    osg::Vec3 scaled = point;
    for (int octave = 0; octave < octaves; ++octave)
    {
        sum += strength * noise(scaled);
        strength *= 0.5f;
        scaled = scaled * 2.03f + osg::Vec3(17.3f, 31.7f, 5.1f);
    }
    return sum;
}

float ridgeNoise(const osg::Vec3& point, int octaves)
{
    float sum = 0.0f;
    float strength = 0.5f;
    osg::Vec3 scaled = point;
    for (int octave = 0; octave < octaves; ++octave)
    {
        const float crest = 1.0f - std::fabs(noise(scaled));
        sum += strength * crest * crest;
        strength *= 0.5f;
        scaled = scaled * 2.03f + osg::Vec3(17.3f, 31.7f, 5.1f);
    }
    return sum;
}

}

#include "Daylight.h"

#include "Noise.h"

#include <osg/Math>

#include <cmath>

namespace waterdata
{

Daylight afternoon()
{
    const float azimuth = osg::DegreesToRadians(222.0f);
    const float elevation = osg::DegreesToRadians(34.0f);
    Daylight daylight;
    daylight.towardsSun.set(std::cos(elevation) * std::cos(azimuth),
                            std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
    daylight.sunLight.set(1.75f, 1.45f, 1.08f);
    daylight.zenithLight.set(0.30f, 0.42f, 0.66f);
    daylight.horizonLight.set(0.52f, 0.58f, 0.66f);
    daylight.groundLight.set(0.14f, 0.14f, 0.10f);
    daylight.haze = colour(0xb9cfe6);
    daylight.hazeDistance = 620.0f;
    return daylight;
}

Colour toLinear(const Colour& painted)
{
    return Colour(std::pow(painted.x(), 2.2f), std::pow(painted.y(), 2.2f),
                  std::pow(painted.z(), 2.2f));
}

Colour toPainted(const Colour& linear)
{
    Colour painted;
    const float shoulder = 0.6f;
    for (int channel = 0; channel < 3; ++channel)
    {
        float value = std::max(0.0f, linear[channel]);
        if (value > shoulder)
            value =
                shoulder + (1.0f - shoulder) * std::tanh((value - shoulder) / (1.0f - shoulder));
        painted[channel] = std::pow(value, 1.0f / 2.2f);
    }
    return painted;
}

Colour throughHaze(const Colour& painted, float distance, const Daylight& daylight)
{
    const float clear = std::exp(-std::max(0.0f, distance - 60.0f) / daylight.hazeDistance);
    return mix(daylight.haze, painted, clear);
}

}

#include "Puddle.h"

#include "Noise.h"

#include <osg/Math>

#include <cmath>

namespace waterdata
{

namespace
{

const float slope = 0.09f;
const float depth = 0.05f;
const float freeboard = 0.014f;
const float outlineShare = 1.09f;

}

// Two lobes, with bays between them, and ragged everywhere.
float Puddle::shoreDistance(float angle) const
{
    const float x = std::cos(angle) / 2.9f;
    const float y = std::sin(angle) / 1.35f;
    const float ellipse = 1.0f / std::sqrt(x * x + y * y);
    const float lobes =
        1.0f + 0.16f * std::cos(3.0f * angle + 0.7f) + 0.12f * std::cos(5.0f * angle);
    const osg::Vec3 around(std::cos(angle), std::sin(angle), 0.0f);
    return ellipse * lobes * (1.0f + 0.28f * fractalNoise(around * 2.6f, 3));
}

float Puddle::asphaltHeight(const osg::Vec2& place) const
{
    const osg::Vec2 out = place - _centre;
    const float share = out.length() / shoreDistance(std::atan2(out.y(), out.x()));
    const float grain =
        0.004f * fractalNoise(osg::Vec3(place * 3.0f, 1.0f), 3) * smoothStep(0.2f, 0.8f, share);
    return osg::clampBetween((share - 1.0f) * slope + grain, -depth, freeboard);
}

std::vector<osg::Vec3> Puddle::waterOutline() const
{
    std::vector<osg::Vec3> outline;
    const int corners = 128;
    for (int corner = 0; corner < corners; ++corner)
    {
        const float angle = 2.0f * osg::PIf * static_cast<float>(corner) / corners;
        const float distance = shoreDistance(angle) * outlineShare;
        const osg::Vec2 place = _centre + osg::Vec2(std::cos(angle), std::sin(angle)) * distance;
        outline.push_back(osg::Vec3(place, 0.0f));
    }
    return outline;
}

}

#include "LakeLand.h"

#include "Noise.h"

#include <osg/Math>

#include <cmath>

namespace waterdata
{

namespace
{

// The shore's distance from the lake's middle, every 15 degrees from east to north and round.
const int shoreSteps = 24;
const float shoreRadii[shoreSteps] = {44, 42, 37, 35, 40, 43, 42, 41, 42, 41, 36, 31,
                                      31, 33, 34, 34, 34, 35, 36, 37, 38, 40, 43, 45};

float shoreRadius(float angle)
{
    const float step = angle / (2.0f * osg::PIf) * shoreSteps + 2.0f * shoreSteps;
    const int index = static_cast<int>(step);
    return mix(shoreRadii[index % shoreSteps], shoreRadii[(index + 1) % shoreSteps],
               smoothStep(0.0f, 1.0f, step - static_cast<float>(index)));
}

osg::Vec2 atAngle(float angle, float radius)
{
    return osg::Vec2(std::cos(angle), std::sin(angle)) * radius;
}

// Rings around the lake, as metres inland: fine at the shore, wide where the mountains are.
std::vector<float> ringsInland()
{
    // The first lies beyond the lake's middle everywhere, so that its points meet there.
    std::vector<float> rings = {-50.0f, -30.0f, -20.0f, -14.0f, -9.0f, -6.0f, -4.0f, -3.0f};
    float step = 0.35f;
    for (float inland = -2.3f; inland < 760.0f; inland += step)
    {
        rings.push_back(inland);
        if (inland > 4.0f)
            step = std::min(step * 1.09f, 15.0f);
    }
    return rings;
}

}

void LakeLand::addPlot(const osg::Vec2& centre, float radius, float height)
{
    _plots.push_back({centre, radius, height});
}

float LakeLand::inland(const osg::Vec2& place) const
{
    const float bays = 1.5f * fractalNoise(osg::Vec3(place * 0.14f, 3.0f), 3);
    return place.length() - shoreRadius(std::atan2(place.y(), place.x())) + bays;
}

float LakeLand::wildHeight(const osg::Vec2& place) const
{
    const float in = inland(place);
    if (in < 0.0f)
        return -2.8f * (1.0f - std::exp(in / 7.0f));

    const osg::Vec3 flat(place, 0.0f);
    const float distance = place.length();
    const float meadow = 0.13f * in / (1.0f + in / 90.0f)
                       + 0.5f * fractalNoise(flat * 0.12f, 3) * smoothStep(2.0f, 12.0f, in);
    const float rolling =
        13.0f + 22.0f * fractalNoise(flat / 75.0f + osg::Vec3(4.7f, 1.9f, 0.0f), 4);
    const float hills = rolling * smoothStep(12.0f, 150.0f, in);
    const float crests = ridgeNoise(flat / 260.0f + osg::Vec3(2.2f, 0.4f, 0.0f), 4);
    const float range = 0.78f + 0.7f * fractalNoise(flat / 420.0f + osg::Vec3(8.1f, 3.3f, 0.0f), 2);
    const float mountains = 185.0f * crests * range * smoothStep(230.0f, 700.0f, distance);
    return meadow + hills + std::max(0.0f, mountains);
}

float LakeLand::height(const osg::Vec2& place) const
{
    float height = wildHeight(place);
    for (const Plot& plot : _plots)
    {
        const float share =
            smoothStep(plot.radius * 1.7f, plot.radius, (place - plot.centre).length());
        height = mix(height, plot.height, share);
    }
    return height;
}

osg::Vec3 LakeLand::onGround(float x, float y, float lift) const
{
    return osg::Vec3(x, y, height(osg::Vec2(x, y)) + lift);
}

bool LakeLand::onPlot(const osg::Vec2& place, float margin) const
{
    for (const Plot& plot : _plots)
    {
        if ((place - plot.centre).length() < plot.radius + margin)
            return true;
    }
    return false;
}

Colour LakeLand::groundColour(const osg::Vec3& point, float steepness) const
{
    const float patches = fractalNoise(osg::Vec3(point.x(), point.y(), 0.0f) * 0.09f, 4);
    const float speckle = noise(point * 2.3f);
    const Colour sand = shade(mix(colour(0xb9a57f), colour(0x9c8a6c), 0.5f + 0.5f * speckle), 1.0f);
    const Colour mud = colour(0x5a5138);
    const Colour grass = mix(colour(0x8c9a50), colour(0x62783c), 0.5f + patches + 0.15f * speckle);
    const Colour wood = mix(colour(0x4d6b37), colour(0x3c5a33), 0.5f + patches);
    const Colour rock = mix(colour(0x8d8a84), colour(0x6f6d6a), 0.5f + speckle * 0.5f);
    const float distance = osg::Vec2(point.x(), point.y()).length();

    Colour ground = mix(grass, wood, smoothStep(90.0f, 180.0f, distance));
    ground = mix(ground, rock, smoothStep(0.7f, 1.1f, steepness + 0.15f * patches));
    const float mountain = point.z() + 35.0f * patches;
    ground = mix(ground, colour(0x6d747c), smoothStep(50.0f, 85.0f, mountain));
    ground = mix(ground, colour(0xe6ebf2), smoothStep(100.0f, 116.0f, mountain));
    ground = mix(sand, ground, smoothStep(0.12f, 0.5f, point.z() + 0.12f * patches));
    return mix(mud, ground, smoothStep(-1.6f, -0.05f, point.z()));
}

Mesh LakeLand::groundMesh() const
{
    Mesh mesh("land");
    mesh.creaseAngle = 180.0f;
    mesh.longestEdge = 0.0f;

    const int sectors = 384;
    const std::vector<float> rings = ringsInland();
    std::vector<osg::Vec3> points;
    std::vector<Colour> paints;
    for (float ring : rings)
    {
        for (int sector = 0; sector <= sectors; ++sector)
        {
            const float angle = 2.0f * osg::PIf * static_cast<float>(sector % sectors) / sectors;
            const float round = smoothStep(60.0f, 300.0f, ring);
            const float shore = mix(shoreRadius(angle), 40.0f, round);
            const osg::Vec2 place = atAngle(angle, std::max(0.0f, shore + ring));
            const float here = height(place);
            const osg::Vec2 slope(height(place + osg::Vec2(0.5f, 0.0f)) - here,
                                  height(place + osg::Vec2(0.0f, 0.5f)) - here);
            points.push_back(osg::Vec3(place, here));
            paints.push_back(groundColour(points.back(), 2.0f * slope.length()));
        }
    }
    for (std::size_t ring = 0; ring + 1 < rings.size(); ++ring)
    {
        for (int sector = 0; sector < sectors; ++sector)
        {
            const std::size_t a = ring * (sectors + 1) + sector;
            const std::size_t b = a + sectors + 1;
            mesh.triangle(points[a], points[b], points[b + 1], paints[a], paints[b], paints[b + 1]);
            mesh.triangle(points[a], points[b + 1], points[a + 1], paints[a], paints[b + 1],
                          paints[a + 1]);
        }
    }
    return mesh;
}

std::vector<osg::Vec3> LakeLand::waterOutline() const
{
    std::vector<osg::Vec3> outline;
    const int corners = 96;
    for (int corner = 0; corner < corners; ++corner)
    {
        const float angle = 2.0f * osg::PIf * static_cast<float>(corner) / corners;
        outline.push_back(osg::Vec3(atAngle(angle, shoreRadius(angle) + 5.0f), 0.0f));
    }
    return outline;
}

}

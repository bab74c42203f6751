#include "LightBaker.h"

#include "Noise.h"
#include "Random.h"
#include "RayScene.h"

#include <osg/Math>

#include <cmath>

namespace waterdata
{

namespace
{

const int raysPerCorner = 10;
const float sunSpread = 0.018f;
const float skyReach = 40.0f;

// What is nearer than this above a face hides it, like a window frame on a wall.
const float coverDistance = 0.15f;
const float coveredWeight = 0.001f;

struct Frame
{
    osg::Vec3 across, along, up;

    explicit Frame(const osg::Vec3& axis) : up(axis)
    {
        across = up ^ (std::fabs(up.z()) < 0.9f ? osg::Vec3(0, 0, 1) : osg::Vec3(1, 0, 0));
        across.normalize();
        along = up ^ across;
    }

    osg::Vec3 direction(float radius, float angle) const
    {
        const float height = std::sqrt(std::max(0.0f, 1.0f - radius * radius));
        return across * (radius * std::cos(angle)) + along * (radius * std::sin(angle))
               + up * height;
    }
};

Colour skyLight(const osg::Vec3& direction, const Daylight& daylight)
{
    if (direction.z() < 0.0f)
        return daylight.groundLight;
    return mix(daylight.horizonLight, daylight.zenithLight, std::sqrt(direction.z()));
}

// The light that falls on one corner, seen from random points of the triangle near that corner:
// a vertex so gets the mean over all its surroundings and not what happens at one point.
class CornerLight
{
public:
    CornerLight(const RayScene& scene, const Daylight& daylight, Random& random)
        : _scene(scene), _daylight(daylight), _random(random), _sun(daylight.towardsSun)
    {
    }

    struct Gathered
    {
        Colour light;
        float weight = 0.0f;
    };

    Gathered gather(const osg::Vec3& corner, const osg::Vec3& toSecond, const osg::Vec3& toThird,
                    const osg::Vec3& normal, bool leafy) const
    {
        const Frame frame(normal);
        const float facing = std::max(0.0f, normal * _daylight.towardsSun);
        const float sunShare = leafy ? 0.25f + 0.6f * facing : facing;
        const float lift = leafy ? 0.06f : 0.012f;
        Gathered gathered;
        for (int ray = 0; ray < raysPerCorner; ++ray)
        {
            const float u = 0.02f + 0.48f * _random.unit();
            const float v = 0.02f + 0.48f * _random.unit();
            const osg::Vec3 from = corner + toSecond * (u * (1.0f - v)) + toThird * (v * (1.0f - u))
                                 + normal * lift;
            const bool covered = !leafy && _scene.blocked(from, normal, coverDistance);
            const float weight = covered ? coveredWeight : 1.0f;
            gathered.light += (sun(from) * sunShare + sky(from, frame)) * weight;
            gathered.weight += weight;
        }
        return gathered;
    }

private:
    const RayScene& _scene;
    const Daylight& _daylight;
    Random& _random;
    Frame _sun;

    Colour sun(const osg::Vec3& from) const
    {
        const float radius = sunSpread * std::sqrt(_random.unit());
        const osg::Vec3 direction = _sun.direction(radius, _random.angle());
        return _scene.blocked(from, direction, 4000.0f) ? Colour() : _daylight.sunLight;
    }

    Colour sky(const osg::Vec3& from, const Frame& frame) const
    {
        const float radius = std::sqrt(_random.unit());
        const osg::Vec3 direction = frame.direction(radius, _random.angle());
        if (_scene.blocked(from, direction, skyReach))
            return _daylight.groundLight * 0.8f;
        return skyLight(direction, _daylight);
    }
};

// Where a vertex is covered altogether, its neighbours' light shows on the triangles around it.
void fillCovered(const std::vector<unsigned int>& corners, std::vector<Colour>& light,
                 std::vector<float>& weights)
{
    for (int pass = 0; pass < 3; ++pass)
    {
        const std::vector<float> before = weights;
        for (std::size_t index = 0; index < corners.size(); ++index)
        {
            const unsigned int here = corners[index];
            for (std::size_t step = 1; before[here] < 1.0f && step < 3; ++step)
            {
                const unsigned int other = corners[index - index % 3 + (index + step) % 3];
                if (before[other] < 1.0f)
                    continue;
                light[here] += light[other] / before[other];
                weights[here] += 1.0f;
            }
        }
    }
}

void bakeItem(const BakeItem& item, const RayScene& scene, const Daylight& daylight, Random& random)
{
    const auto& points = static_cast<const osg::Vec3Array&>(*item.geometry->getVertexArray());
    const auto& normals = static_cast<const osg::Vec3Array&>(*item.geometry->getNormalArray());
    auto& paints = static_cast<osg::Vec4Array&>(*item.geometry->getColorArray());
    const std::vector<unsigned int> corners = triangleCorners(*item.geometry);

    std::vector<Colour> light(points.size());
    std::vector<float> weights(points.size(), 0.0f);
    const CornerLight cornerLight(scene, daylight, random);
    for (std::size_t first = 0; first < corners.size(); first += 3)
    {
        for (int corner = 0; corner < 3; ++corner)
        {
            const unsigned int here = corners[first + corner];
            const osg::Vec3 toSecond = points[corners[first + (corner + 1) % 3]] - points[here];
            const osg::Vec3 toThird = points[corners[first + (corner + 2) % 3]] - points[here];
            const CornerLight::Gathered gathered = cornerLight.gather(
                points[here], toSecond, toThird, normals[here], item.leafy);
            light[here] += gathered.light;
            weights[here] += gathered.weight;
        }
    }
    fillCovered(corners, light, weights);

    for (std::size_t index = 0; index < points.size(); ++index)
    {
        const Colour paint(paints[index].x(), paints[index].y(), paints[index].z());
        const Colour received = light[index] / std::max(coveredWeight, weights[index]);
        const Colour lit = toPainted(osg::componentMultiply(toLinear(paint), received));
        const float distance = osg::Vec2(points[index].x(), points[index].y()).length();
        paints[index] = osg::Vec4(throughHaze(lit, distance, daylight), paints[index].w());
    }
}

}

void bakeLight(const std::vector<BakeItem>& items, const Daylight& daylight)
{
    RayScene scene;
    for (const BakeItem& item : items)
        scene.add(static_cast<const osg::Vec3Array&>(*item.geometry->getVertexArray()),
                  triangleCorners(*item.geometry));
    scene.build();
    Random random(7);
    for (const BakeItem& item : items)
        bakeItem(item, scene, daylight, random);
}

}

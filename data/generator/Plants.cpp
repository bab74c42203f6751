#include "Plants.h"

#include "Noise.h"
#include "Shapes.h"

#include <osg/Math>

#include <cmath>

namespace waterdata
{

void addConifer(Mesh& mesh, Random& random, float height, int layers)
{
    const Colour needles = mix(colour(0x2f5a3a), colour(0x53703a), random.unit());
    const float spread = height * random.between(0.19f, 0.26f);
    const int sides = layers > 3 ? 10 : 6;
    addTube(mesh, {0.0f, 0.0f, -0.8f}, {0.0f, 0.0f, height * 0.3f}, height * 0.03f, height * 0.02f,
            5, colour(0x5b4634));
    for (int layer = 0; layer < layers; ++layer)
    {
        const float share = static_cast<float>(layer) / static_cast<float>(layers);
        const float foot = height * mix(0.13f, 0.80f, share);
        const float top = std::min(height, foot + height * mix(0.36f, 0.24f, share));
        const float radius = spread * (1.0f - 0.82f * share);
        const float turn = random.angle();
        const Colour tips = shade(needles, 0.92f + 0.3f * share);
        const Colour inner = shade(needles, 0.62f);
        const auto skirt = [&](int side)
        {
            const float angle = turn + 2.0f * osg::PIf * static_cast<float>(side % sides) / sides;
            const bool tip = side % 2 == 0;
            const float reach = radius * (tip ? 1.0f : 0.74f);
            const float sag = tip ? -0.035f * height : 0.0f;
            return osg::Vec3(reach * std::cos(angle), reach * std::sin(angle), foot + sag);
        };
        for (int side = 0; side < sides; ++side)
        {
            const Colour here = side % 2 == 0 ? tips : inner;
            const Colour next = side % 2 == 0 ? inner : tips;
            mesh.triangle(skirt(side), skirt(side + 1), {0.0f, 0.0f, top}, here, next, tips);
            if (sides > 6)
                mesh.triangle(skirt(side + 1), skirt(side), {0.0f, 0.0f, foot + height * 0.07f},
                              inner);
        }
    }
}

namespace
{

void addClump(Mesh& mesh, Random& random, int level, const osg::Vec3& centre, float radius,
              const Colour& leaves)
{
    const float seed = random.between(0.0f, 90.0f);
    addFormedBall(mesh, level, [&](const osg::Vec3& p)
    {
        const float bulge = 1.0f + 0.30f * noise(p * 2.2f + osg::Vec3(seed, 0.0f, 0.0f))
                          + 0.14f * noise(p * 5.0f + osg::Vec3(seed, 7.0f, 0.0f));
        return centre + osg::componentMultiply(p, osg::Vec3(1.0f, 1.0f, 0.85f)) * (radius * bulge);
    }, shade(leaves, random.between(0.88f, 1.1f)));
}

Colour leafColour(Random& random)
{
    const Colour young = mix(colour(0x86a040), colour(0x4f7d36), random.unit());
    return random.unit() < 0.12f ? colour(0xc08a3a) : young;
}

}

void addBroadleaf(Mesh& mesh, Random& random, float height, int level)
{
    const Colour leaves = leafColour(random);
    addTube(mesh, {0.0f, 0.0f, -0.8f}, {0.0f, 0.0f, height * 0.55f}, height * 0.035f,
            height * 0.02f, 6, colour(0x6b5642));
    const int clumps = level > 1 ? 6 : 3;
    for (int clump = 0; clump < clumps; ++clump)
    {
        const float turn = static_cast<float>(clump) + random.unit() * 0.6f;
        const float angle = 2.0f * osg::PIf * turn / static_cast<float>(clumps);
        const float away = clump == 0 ? 0.0f : height * random.between(0.12f, 0.2f);
        const float up = height * (clump == 0 ? 0.76f : random.between(0.44f, 0.68f));
        const osg::Vec3 centre(away * std::cos(angle), away * std::sin(angle), up);
        addClump(mesh, random, level, centre, height * random.between(0.17f, 0.24f), leaves);
    }
}

void addBush(Mesh& mesh, Random& random, float height)
{
    const Colour leaves = shade(leafColour(random), 0.9f);
    addClump(mesh, random, 1, {0.0f, 0.0f, height * 0.35f}, height * 0.7f, leaves);
    addClump(mesh, random, 1, {height * 0.6f, 0.0f, height * 0.2f}, height * 0.5f, leaves);
}

void addReeds(Mesh& mesh, Random& random, const osg::Vec3& foot, float height)
{
    const Colour stalk = mix(colour(0x7c8f44), colour(0xb09a58), random.unit());
    const float facing = random.angle();
    const osg::Vec3 across(std::cos(facing) * 0.02f, std::sin(facing) * 0.02f, 0.0f);
    const osg::Vec3 lean(random.between(-0.16f, 0.16f), random.between(-0.16f, 0.16f), 1.0f);
    const osg::Vec3 middle = foot + lean * (height * 0.55f);
    const osg::Vec3 tip = foot + osg::componentMultiply(lean, osg::Vec3(1.7f, 1.7f, 1.0f)) * height;
    const Colour low = shade(stalk, 0.6f);
    mesh.triangle(foot - across, foot + across, middle + across, low, low, stalk);
    mesh.triangle(foot - across, middle + across, middle - across, low, stalk, stalk);
    mesh.triangle(middle - across, middle + across, tip, stalk, stalk, shade(stalk, 1.15f));
    if (random.unit() < 0.16f)
        addTube(mesh, tip - osg::Vec3(0.0f, 0.0f, 0.24f), tip, 0.022f, 0.016f, 4, colour(0x5d4330));
}

void addRock(Mesh& mesh, Random& random, const osg::Vec3& radii)
{
    const float seed = random.between(0.0f, 90.0f);
    const Colour stone = mix(colour(0x96928a), colour(0x75716b), random.unit());
    addFormedBall(mesh, radii.x() > 0.6f ? 2 : 1, [&](const osg::Vec3& p)
    {
        const float bulge = 0.85f + 0.45f * noise(p * 1.3f + osg::Vec3(seed, 0.0f, 0.0f));
        return osg::componentMultiply(p, radii) * bulge;
    }, stone);
}

}

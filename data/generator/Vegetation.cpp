#include "Noise.h"
#include "Plants.h"

#include <cmath>

namespace waterdata
{

namespace
{

osg::Vec2 somewhere(Random& random, float near, float far)
{
    const float angle = random.angle();
    const float radius = std::sqrt(mix(near * near, far * far, random.unit()));
    return osg::Vec2(std::cos(angle), std::sin(angle)) * radius;
}

void addWood(const LakeLand& land, Mesh& conifers, Mesh& broadleaves)
{
    Random random(11);
    for (int tree = 0; tree < 1650; ++tree)
    {
        const osg::Vec2 place = somewhere(random, 40.0f, 215.0f);
        const float clearing = fractalNoise(osg::Vec3(place * 0.03f, 9.0f), 3);
        const float inland = land.inland(place);
        const float wooded = smoothStep(12.0f, 60.0f, inland) - 0.25f + clearing;
        if (inland < 9.0f || random.unit() > 0.75f * wooded || land.onPlot(place, 3.5f))
            continue;
        const osg::Vec3 foot = land.onGround(place.x(), place.y());
        const bool near = inland < 40.0f && place.y() > -20.0f;
        const bool leaves = fractalNoise(osg::Vec3(place * 0.05f, 2.0f), 2) > 0.10f;
        Mesh& mesh = leaves ? broadleaves : conifers;
        const Placed placed(mesh, foot, random.between(0.0f, 360.0f));
        if (leaves)
            addBroadleaf(mesh, random, random.between(5.5f, 9.0f), 1);
        else
            addConifer(mesh, random, random.between(6.0f, 12.5f), near ? 6 : 3);
    }
}

void addGardenTrees(const LakeLand& land, Mesh& conifers, Mesh& broadleaves)
{
    Random random(23);
    const osg::Vec2 conifersAt[] = {{-30, 26}, {-27, 33}, {-39, 17}, {30, 30}, {33, 24}, {27, 37},
                                    {-33, 27}, {36, 33}, {21, 47}, {-41, -6}, {44, 2}};
    for (const osg::Vec2& place : conifersAt)
    {
        const Placed placed(conifers, land.onGround(place.x(), place.y()));
        addConifer(conifers, random, random.between(7.0f, 11.0f), 7);
    }
    const osg::Vec2 broadleavesAt[] = {{-11, 44},   {8, 55},   {-2, 57},
                                       {19, 43.5f}, {-21, 41}, {-37, 10}};
    for (const osg::Vec2& place : broadleavesAt)
    {
        const Placed placed(broadleaves, land.onGround(place.x(), place.y()));
        addBroadleaf(broadleaves, random, random.between(6.0f, 8.5f), 2);
    }
}

void addShoreBushes(const LakeLand& land, Mesh& broadleaves)
{
    Random random(41);
    for (int bush = 0; bush < 420; ++bush)
    {
        const osg::Vec2 place = somewhere(random, 34.0f, 62.0f);
        const float inland = land.inland(place);
        const float crowd = fractalNoise(osg::Vec3(place * 0.13f, 8.0f), 2);
        if (inland < 2.0f || inland > 14.0f || crowd < 0.08f || land.onPlot(place, 1.0f))
            continue;
        const Placed placed(broadleaves, land.onGround(place.x(), place.y()),
                            random.between(0.0f, 360.0f));
        addBush(broadleaves, random, random.between(0.6f, 1.5f));
    }
}

void addShoreReeds(const LakeLand& land, Mesh& reeds)
{
    Random random(31);
    const osg::Vec2 beds[] = {{-13, -31}, {-26, -20}, {-22, 30}, {25, 25}, {40, -8}, {-31, 8},
                              {16, -34}, {20, 37}};
    for (const osg::Vec2& bed : beds)
    {
        for (int blade = 0; blade < 420; ++blade)
        {
            const osg::Vec2 place = bed + somewhere(random, 0.0f, 4.5f);
            const float ground = land.height(place);
            if (ground < -0.75f || ground > 0.12f)
                continue;
            addReeds(reeds, random, osg::Vec3(place, ground), random.between(1.0f, 1.9f) - ground);
        }
    }
}

void addShoreRocks(const LakeLand& land, Mesh& rocks)
{
    Random random(47);
    for (int stone = 0; stone < 900; ++stone)
    {
        const osg::Vec2 place = somewhere(random, 25.0f, 50.0f);
        const float inland = land.inland(place);
        const float crowd = fractalNoise(osg::Vec3(place * 0.11f, 5.0f), 2);
        if (inland < -2.2f || inland > 1.6f || crowd < -0.05f || land.onPlot(place, -1.0f))
            continue;
        const float size = 0.18f + 1.0f * std::pow(random.unit(), 2.6f);
        const Placed placed(rocks, land.onGround(place.x(), place.y(), size * 0.1f),
                            random.between(0.0f, 360.0f));
        addRock(rocks, random, osg::Vec3(size, size * random.between(0.6f, 1.0f), size * 0.62f));
    }
}

}

std::vector<Mesh> lakeVegetation(const LakeLand& land)
{
    std::vector<Mesh> meshes = {Mesh("conifers"), Mesh("broadleaf trees"), Mesh("reeds"),
                                Mesh("rocks")};
    addWood(land, meshes[0], meshes[1]);
    addGardenTrees(land, meshes[0], meshes[1]);
    addShoreBushes(land, meshes[1]);
    addShoreReeds(land, meshes[2]);
    addShoreRocks(land, meshes[3]);
    for (Mesh& mesh : meshes)
        mesh.longestEdge = 0.0f;
    meshes[0].creaseAngle = 25.0f;
    meshes[0].leafy = true;
    meshes[1].creaseAngle = 70.0f;
    meshes[1].leafy = true;
    meshes[2].leafy = true;
    return meshes;
}

}

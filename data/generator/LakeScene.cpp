#include "LakeScene.h"

#include "Afloat.h"
#include "Bake.h"
#include "House.h"
#include "LakeLand.h"
#include "Plants.h"
#include "Sky.h"
#include "TreeCards.h"
#include "WaterSurface.h"
#include "Waterside.h"

#include <iterator>

namespace waterdata
{

namespace
{

struct Homestead
{
    const char* name;
    osg::Vec2 place;
    float ground;
    float turn;
    HouseStyle style;
};

std::vector<Homestead> homesteads()
{
    HouseStyle red;
    red.porch = true;

    HouseStyle yellow;
    yellow.width = 8.0f;
    yellow.depth = 6.5f;
    yellow.windowsAcross = 3;
    yellow.wall = colour(0xe3b64f);
    yellow.roof = colour(0x9a4f38);
    yellow.door = colour(0x7a3326);

    HouseStyle white;
    white.width = 11.0f;
    white.storeys = 1;
    white.roofHeight = 3.6f;
    white.wall = colour(0xefe9dc);
    white.trim = colour(0x58707f);
    white.roof = colour(0x3f4a54);

    HouseStyle blue;
    blue.width = 7.0f;
    blue.depth = 6.5f;
    blue.windowsAcross = 3;
    blue.roofHeight = 3.4f;
    blue.wall = colour(0x6f93a6);
    blue.roof = colour(0x6b4a3c);

    HouseStyle cabin;
    cabin.width = 6.0f;
    cabin.depth = 5.0f;
    cabin.storeys = 1;
    cabin.storeyHeight = 2.5f;
    cabin.roofHeight = 2.2f;
    cabin.windowsAcross = 3;
    cabin.windowsDeep = 1;
    cabin.wall = colour(0x7d5a3d);
    cabin.trim = colour(0xd9cdb4);
    cabin.roof = colour(0x4f6b3f);
    cabin.porch = true;

    return {{"red house", {1.0f, 49.0f}, 1.1f, -4.0f, red},
            {"yellow house", {-15.0f, 50.5f}, 1.5f, 12.0f, yellow},
            {"white house", {15.5f, 52.0f}, 1.9f, -14.0f, white},
            {"blue house", {-30.0f, 34.0f}, 1.7f, 38.0f, blue},
            {"cabin", {38.0f, 30.0f}, 2.0f, -48.0f, cabin}};
}

Mesh prepared(const char* name, const osg::Vec3& place, float turn, float longestEdge)
{
    Mesh mesh(name);
    mesh.longestEdge = longestEdge;
    mesh.frame = osg::Matrixd::rotate(osg::DegreesToRadians(turn), osg::Z_AXIS)
               * osg::Matrixd::translate(place);
    return mesh;
}

void addBuildings(std::vector<Mesh>& meshes, LakeLand& land)
{
    for (const Homestead& home : homesteads())
    {
        land.addPlot(home.place, 0.62f * home.style.width, home.ground);
        meshes.push_back(prepared(home.name, osg::Vec3(home.place, home.ground), home.turn, 0.65f));
        addHouse(meshes.back(), home.style);
    }
    land.addPlot({-28.0f, 66.0f}, 11.0f, 6.5f);
    meshes.push_back(prepared("church", {-28.0f, 66.0f, 6.5f}, 14.0f, 0.75f));
    addChurch(meshes.back());
    land.addPlot({24.3f, 24.0f}, 3.0f, 0.75f);
    meshes.push_back(prepared("lighthouse", {24.3f, 24.0f, 0.75f}, 20.0f, 0.5f));
    addLighthouse(meshes.back());
    meshes.push_back(prepared("boathouse", {10.5f, 41.0f, 0.0f}, -8.0f, 0.65f));
    addBoathouse(meshes.back());
    meshes.push_back(prepared("pier", {-33.5f, -3.0f, 0.0f}, 6.0f, 0.9f));
    addPier(meshes.back(), 24.0f, 1.8f);
}

void addFloatingThings(std::vector<Mesh>& meshes)
{
    meshes.push_back(prepared("duck", {1.3f, -23.2f, 0.0f}, 205.0f, 0.0f));
    meshes.back().creaseAngle = 60.0f;
    addDuck(meshes.back());
    meshes.push_back(prepared("beach ball", {-2.1f, -21.3f, 0.0f}, 15.0f, 0.0f));
    addBeachBall(meshes.back());
    meshes.push_back(prepared("rowing boat", {4.6f, -14.5f, 0.0f}, 152.0f, 0.25f));
    addRowingBoat(meshes.back());
    meshes.push_back(prepared("buoy", {12.0f, 2.0f, 0.0f}, 0.0f, 0.4f));
    addBuoy(meshes.back());
}

}

osg::ref_ptr<osg::Group> lakeScene(const std::string& dataDirectory)
{
    LakeLand land;
    std::vector<Mesh> meshes;
    addBuildings(meshes, land);
    addFloatingThings(meshes);
    std::vector<Mesh> plants = lakeVegetation(land);
    std::move(plants.begin(), plants.end(), std::back_inserter(meshes));
    meshes.push_back(land.groundMesh());

    const Daylight daylight = afternoon();
    const osg::Vec3 focus(0.0f, -30.0f, 2.0f);
    osg::ref_ptr<osg::Group> scene = bakeScene(std::move(meshes), daylight, focus);
    scene->setName("lake");
    scene->addChild(treeCards(land, daylight));
    scene->addChild(waterSurface(land.waterOutline()));
    scene->addChild(skyBox(dataDirectory, 400.0f));
    return scene;
}

}

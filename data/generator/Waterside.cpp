#include "Waterside.h"

#include "House.h"
#include "Noise.h"
#include "Random.h"
#include "Shapes.h"

#include <osg/Math>

namespace waterdata
{

namespace
{

const Colour wood = colour(0x9b8468);
const Colour wetWood = colour(0x54463a);

void addPost(Mesh& mesh, float x, float y, float top)
{
    addTube(mesh, {x, y, -2.6f}, {x, y, 0.12f}, 0.13f, 0.125f, 8, wetWood);
    addTube(mesh, {x, y, 0.12f}, {x, y, top}, 0.125f, 0.11f, 8, shade(wood, 0.85f));
}

}

void addPier(Mesh& mesh, float length, float width)
{
    const float deck = 0.62f;
    const float half = width * 0.5f;
    Random random(3);
    for (float x = 0.0f; x < length; x += 0.24f)
    {
        const float ragged = random.between(-0.04f, 0.04f);
        addBox(mesh, {x, -half + ragged, deck - 0.06f}, {x + 0.21f, half + ragged, deck},
               shade(wood, random.between(0.85f, 1.1f)));
    }
    for (float side : {-1.0f, 1.0f})
    {
        const float y = side * (half - 0.2f);
        addBox(mesh, {0.0f, y - 0.07f, deck - 0.26f}, {length, y + 0.07f, deck - 0.06f},
               shade(wood, 0.8f));
        int post = 0;
        for (float x = 1.0f; x <= length; x += 2.6f, ++post)
            addPost(mesh, x, side * (half + 0.03f), deck + (post % 2 ? 0.75f : 0.18f));
    }
    addPost(mesh, length - 0.15f, half + 0.03f, deck + 1.0f);
    addPost(mesh, length - 0.15f, -half - 0.03f, deck + 1.0f);
}

void addBoathouse(Mesh& mesh)
{
    const Colour boards = colour(0x8c3b2a);
    const Colour trim = colour(0xece6da);
    const float x = 2.6f;
    const float y = 3.6f;
    for (float postX : {-x, 0.0f, x})
    {
        for (float postY : {-y, -1.2f, 1.2f, y})
        {
            if (postX != 0.0f || postY == y)
                addPost(mesh, postX, postY, 0.8f);
        }
    }
    const float floorLevel = 0.7f;
    const float eaves = 3.1f;
    addBox(mesh, {-x, -y, floorLevel}, {-x + 0.15f, y, eaves}, boards);
    addBox(mesh, {x - 0.15f, -y, floorLevel}, {x, y, eaves}, boards);
    addBox(mesh, {-x, y - 0.15f, floorLevel}, {x, y, eaves}, boards);
    addBox(mesh, {-x, -y - 1.2f, floorLevel - 0.14f}, {x, y, floorLevel}, wood);
    addBox(mesh, {-x, -y, 2.7f}, {x, -y + 0.15f, eaves}, boards);
    for (float side : {-1.0f, 1.0f})
    {
        addBox(mesh, {side * 2.0f - 0.6f, -y, floorLevel}, {side * 2.0f + 0.6f, -y + 0.15f, eaves},
               boards);
        addBox(mesh, {side * 1.4f - 0.09f, -y - 0.05f, floorLevel},
               {side * 1.4f + 0.09f, -y + 0.2f, 2.7f}, trim);
        addBox(mesh, {side * x - 0.11f, -y - 0.05f, floorLevel},
               {side * x + 0.11f, -y + 0.2f, eaves}, trim);
        const Placed window(mesh, osg::Matrixd::rotate(side * osg::PI_2, osg::Z_AXIS)
                                      * osg::Matrixd::translate(side * x, 0.3, 1.5));
        addWindow(mesh, 1.2f, 0.9f, trim);
    }
    for (float end : {-y, y})
    {
        mesh.triangle({-x, end, eaves}, {x, end, eaves}, {0.0f, end, eaves + 2.0f}, boards);
        mesh.triangle({x, end + 0.1f, eaves}, {-x, end + 0.1f, eaves},
                      {0.0f, end + 0.1f, eaves + 2.0f}, boards);
    }
    const Placed roof(mesh, osg::Matrixd::rotate(osg::PI_2, osg::Z_AXIS)
                                * osg::Matrixd::translate(0.0, 0.0, eaves));
    addGableRoof(mesh, 2.0f * y, 2.0f * x, 2.0f, colour(0x6a6661), trim);
}

void addLighthouse(Mesh& mesh)
{
    const int bands = 6;
    const float height = 9.6f;
    std::vector<osg::Vec2> profile;
    for (int band = 0; band <= bands; ++band)
    {
        const float share = static_cast<float>(band) / bands;
        profile.push_back({mix(1.55f, 1.0f, share), height * share});
    }
    addTube(mesh, {0.0f, 0.0f, -1.5f}, {0.0f, 0.0f, 0.5f}, 2.1f, 1.95f, 24, colour(0x8c8983));
    addTurned(mesh, profile, 24, [](int row, int)
    {
        return row % 2 ? colour(0xf4f0e8) : colour(0xc8281f);
    });
    addTube(mesh, {0.0f, 0.0f, height}, {0.0f, 0.0f, height + 0.22f}, 1.5f, 1.5f, 24,
            colour(0x3a3d42));
    for (int bar = 0; bar < 12; ++bar)
    {
        const float angle = 2.0f * osg::PIf * static_cast<float>(bar) / 12.0f;
        const osg::Vec3 foot(1.4f * std::cos(angle), 1.4f * std::sin(angle), height + 0.2f);
        addTube(mesh, foot, foot + osg::Vec3(0.0f, 0.0f, 0.85f), 0.03f, 0.03f, 4, colour(0x3a3d42));
    }
    {
        const Placed rail(mesh, osg::Vec3(0.0f, 0.0f, height + 1.05f));
        addRing(mesh, 1.4f, 0.04f, 24, colour(0x3a3d42));
    }
    addTube(mesh, {0.0f, 0.0f, height + 0.2f}, {0.0f, 0.0f, height + 1.9f}, 0.72f, 0.72f, 12,
            colour(0xbfd6de));
    addTurned(mesh, {{0.0f, height + 1.85f}, {1.05f, height + 1.9f}, {0.12f, height + 3.0f},
                     {0.0f, height + 3.5f}}, 24, [](int, int) { return colour(0xb3241d); });
    for (float level : {1.2f, 5.2f})
    {
        const Placed window(mesh, osg::Vec3(0.0f, -1.62f + level * 0.052f, level));
        if (level < 2.0f)
            addDoor(mesh, 0.8f, 1.8f, colour(0xf4f0e8), colour(0x35506b));
        else
            addWindow(mesh, 0.5f, 0.9f, colour(0xf4f0e8));
    }
}

}

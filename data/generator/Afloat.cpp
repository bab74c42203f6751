#include "Afloat.h"

#include "Shapes.h"

#include <osg/Math>

#include <cmath>

namespace waterdata
{

void addDuck(Mesh& mesh)
{
    const Colour yellow = colour(0xf7c81e);
    addFormedBall(mesh, 4, [](const osg::Vec3& p)
    {
        osg::Vec3 body = osg::componentMultiply(p, osg::Vec3(0.30f, 0.21f, 0.17f));
        const float back = std::max(0.0f, -p.x());
        body.z() += 0.16f * back * back * back + 0.02f * p.x();
        body.y() *= 1.0f - 0.55f * back * back;
        body.z() = std::max(body.z(), -0.12f);
        return body + osg::Vec3(0.0f, 0.0f, 0.09f);
    }, yellow);
    addBall(mesh, {0.17f, 0.0f, 0.345f}, {0.135f, 0.13f, 0.13f}, 28, yellow);
    for (float side : {-1.0f, 1.0f})
    {
        const Placed wing(mesh, osg::Matrixd::rotate(osg::DegreesToRadians(9.0), osg::Y_AXIS)
                                    * osg::Matrixd::translate(-0.06, side * 0.175, 0.135));
        addBall(mesh, {0.0f, 0.0f, 0.0f}, {0.16f, 0.05f, 0.085f}, 18, shade(yellow, 0.97f));
    }
    for (float side : {-1.0f, 1.0f})
        addBall(mesh, {0.265f, side * 0.082f, 0.388f}, {0.020f, 0.020f, 0.026f}, 12,
                colour(0x1c1a1a));
    addBall(mesh, {0.315f, 0.0f, 0.325f}, {0.075f, 0.062f, 0.020f}, 18, colour(0xe8711c));
    addBall(mesh, {0.305f, 0.0f, 0.300f}, {0.060f, 0.050f, 0.016f}, 18, colour(0xcf5a16));
}

void addBeachBall(Mesh& mesh)
{
    const float radius = 0.32f;
    const Placed tilted(mesh, osg::Matrixd::rotate(0.9, osg::Vec3d(0.5, -0.8, 0.0))
                                  * osg::Matrixd::translate(0.0, 0.0, radius * 0.82));
    std::vector<osg::Vec2> profile;
    const int rows = 24;
    for (int row = 0; row <= rows; ++row)
    {
        const float angle = osg::PIf * (static_cast<float>(row) / rows - 0.5f);
        const bool pole = row == 0 || row == rows;
        profile.push_back({pole ? 0.0f : radius * std::cos(angle), radius * std::sin(angle)});
    }
    addTurned(mesh, profile, 48, [](int row, int side)
    {
        const bool cap = row < 2 || row >= rows - 2;
        return cap || (side / 8) % 2 == 0 ? colour(0xf5f2ec) : colour(0xd8261f);
    });
}

namespace
{

const int hullStations = 17;
const int hullRows = 7;

float halfBeam(float along)
{
    return 0.78f * std::pow(std::sin(osg::PIf * (0.30f + 0.70f * along)), 0.72f);
}

// A point of the hull's skin; along 0 (stern) .. 1 (bow), round 0 (keel) .. 1 (gunwale).
osg::Vec3 hullPoint(float along, float round, float side, float inset)
{
    const float half = 2.0f;
    const float beam = std::max(0.0f, halfBeam(along) - inset);
    const float sheer = 0.36f + 0.26f * std::pow(2.0f * along - 0.9f, 2.0f);
    const float keel = -0.15f + 0.22f * std::pow(along, 6.0f) + inset;
    const float out = std::pow(std::sin(round * osg::PI_2f), 0.75f);
    const float up = 1.0f - std::cos(round * osg::PI_2f);
    return osg::Vec3((along - 0.5f) * 2.0f * half + 0.18f * round * along, side * beam * out,
                     keel + (sheer - keel) * (0.25f * round + 0.75f * up));
}

void addSkin(Mesh& mesh, float inset, bool inwards)
{
    const auto paint = [inwards](int row)
    {
        if (inwards)
            return row % 2 ? colour(0xb98a55) : colour(0xa97c4a);
        return row == hullRows - 1 ? colour(0x2c4a6e) : colour(0xf1ede2);
    };
    for (float side : {-1.0f, 1.0f})
    {
        for (int station = 0; station + 1 < hullStations; ++station)
        {
            for (int row = 0; row < hullRows; ++row)
            {
                const float low = static_cast<float>(row) / hullRows;
                const float high = static_cast<float>(row + 1) / hullRows;
                const float here = static_cast<float>(station) / (hullStations - 1);
                const float next = static_cast<float>(station + 1) / (hullStations - 1);
                const osg::Vec3 a = hullPoint(here, low, side, inset);
                const osg::Vec3 b = hullPoint(next, low, side, inset);
                const osg::Vec3 c = hullPoint(next, high, side, inset);
                const osg::Vec3 d = hullPoint(here, high, side, inset);
                if ((side < 0.0f) != inwards)
                    mesh.quad(a, b, c, d, paint(row));
                else
                    mesh.quad(d, c, b, a, paint(row));
            }
        }
    }
}

void addGunwale(Mesh& mesh)
{
    for (float side : {-1.0f, 1.0f})
    {
        for (int station = 0; station + 1 < hullStations; ++station)
        {
            const float here = static_cast<float>(station) / (hullStations - 1);
            const float next = static_cast<float>(station + 1) / (hullStations - 1);
            addTube(mesh, hullPoint(here, 1.0f, side, 0.02f), hullPoint(next, 1.0f, side, 0.02f),
                    0.035f, 0.035f, 6, colour(0x7d5530));
        }
    }
}

void addTransom(Mesh& mesh)
{
    const Colour wood = colour(0x8a6037);
    for (int row = 0; row < hullRows; ++row)
    {
        const float low = static_cast<float>(row) / hullRows;
        const float high = static_cast<float>(row + 1) / hullRows;
        mesh.quad(hullPoint(0.0f, low, 1.0f, 0.0f), hullPoint(0.0f, low, -1.0f, 0.0f),
                  hullPoint(0.0f, high, -1.0f, 0.0f), hullPoint(0.0f, high, 1.0f, 0.0f), wood);
    }
}

// Half the hull's inner width at the floor.
float floorReach(float along, float level, float inset)
{
    float low = 0.0f;
    float high = 1.0f;
    for (int step = 0; step < 20; ++step)
    {
        const float middle = 0.5f * (low + high);
        (hullPoint(along, middle, 1.0f, inset).z() < level ? low : high) = middle;
    }
    return hullPoint(along, low, 1.0f, inset).y();
}

// Boards over the bilge: they hide the water, which the hull does not keep out of a plane.
void addFloor(Mesh& mesh)
{
    const int boards = 7;
    const float level = 0.06f;
    for (int station = 0; station + 1 < hullStations; ++station)
    {
        const float here = static_cast<float>(station) / (hullStations - 1);
        const float next = static_cast<float>(station + 1) / (hullStations - 1);
        const float reachHere = floorReach(here, level, 0.02f);
        const float reachNext = floorReach(next, level, 0.02f);
        for (int board = 0; board < boards; ++board)
        {
            const float right = 2.0f * static_cast<float>(board) / boards - 1.0f;
            const float left = 2.0f * static_cast<float>(board + 1) / boards - 1.0f;
            const float aft = (here - 0.5f) * 4.0f;
            const float fore = (next - 0.5f) * 4.0f;
            mesh.quad({aft, right * reachHere, level}, {fore, right * reachNext, level},
                      {fore, left * reachNext, level}, {aft, left * reachHere, level},
                      shade(colour(0xb48752), board % 2 ? 0.92f : 1.0f));
        }
    }
}

void addOar(Mesh& mesh, float side)
{
    const osg::Vec3 grip(-1.45f, side * 0.14f, 0.35f);
    const osg::Vec3 blade(0.55f, side * 0.20f, 0.36f);
    addTube(mesh, grip, blade, 0.022f, 0.022f, 6, colour(0xc9a06a));
    addSlab(mesh, blade + osg::Vec3(0.0f, -0.07f, 0.01f), blade + osg::Vec3(0.5f, -0.08f, 0.01f),
            blade + osg::Vec3(0.5f, 0.08f, 0.01f), blade + osg::Vec3(0.0f, 0.07f, 0.01f),
            {0.0f, 0.0f, -0.02f}, colour(0xd9472e));
}

}

void addRowingBoat(Mesh& mesh)
{
    addSkin(mesh, 0.0f, false);
    addSkin(mesh, 0.035f, true);
    addGunwale(mesh);
    addTransom(mesh);
    addFloor(mesh);
    for (float seat : {-1.45f, -0.25f, 0.95f})
    {
        const float reach = std::min(halfBeam(0.5f + (seat + 0.13f) / 4.0f),
                                     halfBeam(0.5f + (seat - 0.13f) / 4.0f)) - 0.06f;
        addBox(mesh, {seat - 0.13f, -reach, 0.27f}, {seat + 0.13f, reach, 0.31f}, colour(0xc79a62));
    }
    for (float side : {-1.0f, 1.0f})
        addOar(mesh, side);
}

void addBuoy(Mesh& mesh)
{
    addTurned(mesh, {{0.0f, -0.5f}, {0.42f, -0.3f}, {0.5f, 0.1f}, {0.42f, 0.35f}, {0.16f, 0.5f},
                     {0.09f, 1.5f}, {0.0f, 1.52f}}, 20,
              [](int row, int) { return row == 3 ? colour(0xf0ece2) : colour(0xc9302a); });
    addBall(mesh, {0.0f, 0.0f, 1.62f}, {0.16f, 0.16f, 0.16f}, 14, colour(0xe8c531));
}

}

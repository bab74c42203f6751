#include "House.h"

#include "Noise.h"
#include "Shapes.h"

#include <osg/Math>

namespace waterdata
{

namespace
{

const float overhang = 0.45f;

// Calls `visit` in turn for the four walls, the mesh's frame being on the wall: x along it.
template <typename Visit>
void forEachWall(Mesh& mesh, float width, float depth, Visit visit)
{
    for (int side = 0; side < 4; ++side)
    {
        const bool gable = side % 2 == 1;
        const float distance = (gable ? width : depth) * 0.5f;
        const osg::Matrixd onWall = osg::Matrixd::translate(0.0, -distance, 0.0)
            * osg::Matrixd::rotate(osg::DegreesToRadians(90.0 * side), osg::Z_AXIS);
        const Placed placed(mesh, onWall);
        visit(side, gable ? depth : width);
    }
}

void addWindows(Mesh& mesh, const HouseStyle& style)
{
    forEachWall(mesh, style.width, style.depth, [&](int side, float length)
    {
        const int count = side % 2 == 1 ? style.windowsDeep : style.windowsAcross;
        const float spacing = length / static_cast<float>(count);
        for (int storey = 0; storey < style.storeys; ++storey)
        {
            for (int window = 0; window < count; ++window)
            {
                const float x = (static_cast<float>(window) + 0.5f) * spacing - length * 0.5f;
                const bool door = side == 0 && storey == 0 && window == count / 2;
                const float sill = static_cast<float>(storey) * style.storeyHeight + 1.25f;
                const Placed placed(mesh, osg::Vec3(x, 0.0f, door ? 0.35f : sill));
                if (door)
                    addDoor(mesh, 1.1f, 2.15f, style.trim, style.door);
                else
                    addWindow(mesh, 1.1f, 1.35f, style.trim);
            }
        }
        if (side % 2 == 1)
        {
            const float attic = static_cast<float>(style.storeys) * style.storeyHeight + 0.9f;
            const Placed placed(mesh, osg::Vec3(0.0f, 0.0f, attic));
            addWindow(mesh, 0.9f, 1.0f, style.trim);
        }
    });
}

void addBody(Mesh& mesh, const HouseStyle& style, float eaves)
{
    const float x = style.width * 0.5f;
    const float y = style.depth * 0.5f;
    addBox(mesh, {-x - 0.08f, -y - 0.08f, -2.0f}, {x + 0.08f, y + 0.08f, 0.35f}, colour(0x8c8880));
    addBox(mesh, {-x, -y, 0.3f}, {x, y, eaves}, style.wall);
    const float ridge = eaves + style.roofHeight;
    mesh.triangle({x, -y, eaves}, {x, y, eaves}, {x, 0.0f, ridge}, style.wall);
    mesh.triangle({-x, y, eaves}, {-x, -y, eaves}, {-x, 0.0f, ridge}, style.wall);
    for (float cornerX : {-x, x})
    {
        for (float cornerY : {-y, y})
        {
            const osg::Vec3 corner(cornerX, cornerY, 0.35f);
            addBox(mesh, corner - osg::Vec3(0.12f, 0.12f, 0.0f),
                   corner + osg::Vec3(0.12f, 0.12f, eaves - 0.35f), style.trim);
        }
    }
}

void addChimney(Mesh& mesh, const HouseStyle& style, float ridge)
{
    const Placed placed(mesh, osg::Vec3(style.width * 0.22f, 0.5f, ridge));
    addBox(mesh, {-0.4f, -0.4f, -1.5f}, {0.4f, 0.4f, 0.95f}, colour(0x9a5b48));
    addBox(mesh, {-0.5f, -0.5f, 0.95f}, {0.5f, 0.5f, 1.1f}, colour(0x6e6a66));
}

void addPorch(Mesh& mesh, const HouseStyle& style)
{
    const float spacing = style.width / static_cast<float>(style.windowsAcross);
    const float x = (static_cast<float>(style.windowsAcross / 2) + 0.5f) * spacing
                  - style.width * 0.5f;
    const Placed placed(mesh, osg::Vec3(x, -style.depth * 0.5f - 0.8f, 0.0f));
    addBox(mesh, {-1.3f, -0.8f, -1.5f}, {1.3f, 0.8f, 0.3f}, colour(0x9a958c));
    for (float side : {-1.15f, 1.15f})
        addBox(mesh, {side - 0.07f, -0.7f, 0.3f}, {side + 0.07f, -0.56f, 2.7f}, style.trim);
    const Placed roof(mesh, osg::Matrixd::rotate(osg::PI_2, osg::Z_AXIS)
                                * osg::Matrixd::translate(0.0, 0.0, 2.7));
    addGableRoof(mesh, 1.5f, 2.4f, 0.8f, style.roof, style.trim);
}

}

void addWindow(Mesh& mesh, float width, float height, const Colour& trim, int panesAcross)
{
    const float x = width * 0.5f;
    const float frame = 0.1f;
    addBox(mesh, {-x - frame, -0.05f, -frame}, {x + frame, 0.05f, height + frame}, trim);
    const Colour low = colour(0x33475a);
    const Colour high = colour(0x8fa9bd);
    const float front = -0.06f;
    mesh.triangle({-x, front, 0.0f}, {x, front, 0.0f}, {x, front, height}, low, low, high);
    mesh.triangle({-x, front, 0.0f}, {x, front, height}, {-x, front, height}, low, high, high);
    for (int bar = 1; bar < panesAcross; ++bar)
    {
        const float at = width * static_cast<float>(bar) / static_cast<float>(panesAcross) - x;
        addBox(mesh, {at - 0.035f, -0.09f, 0.0f}, {at + 0.035f, 0.0f, height}, trim);
    }
    addBox(mesh, {-x, -0.09f, height * 0.55f}, {x, 0.0f, height * 0.55f + 0.06f}, trim);
    addBox(mesh, {-x - 0.15f, -0.14f, -frame - 0.05f}, {x + 0.15f, 0.0f, -frame}, trim);
}

void addDoor(Mesh& mesh, float width, float height, const Colour& trim, const Colour& leaf)
{
    const float x = width * 0.5f;
    addBox(mesh, {-x - 0.12f, -0.06f, 0.0f}, {x + 0.12f, 0.05f, height + 0.14f}, trim);
    addBox(mesh, {-x, -0.09f, 0.0f}, {x, 0.0f, height}, leaf);
    const Placed placed(mesh, osg::Vec3(0.0f, -0.04f, height * 0.6f));
    addWindow(mesh, width * 0.5f, height * 0.25f, shade(leaf, 1.1f));
}

void addGableRoof(Mesh& mesh, float width, float depth, float height, const Colour& paint,
                  const Colour& verge)
{
    const float x = width * 0.5f + overhang;
    const float y = depth * 0.5f;
    const float drop = overhang * height / y;
    const osg::Vec3 thickness(0.0f, 0.0f, -0.2f);
    const int rows = 7;
    for (float side : {-1.0f, 1.0f})
    {
        const auto edge = [&](float share, float atX, float lift)
        {
            return osg::Vec3(atX * side, side * mix(y + overhang, 0.0f, share),
                             mix(-drop, height, share) + 0.22f + lift);
        };
        addSlab(mesh, edge(0.0f, x, 0.0f), edge(0.0f, -x, 0.0f), edge(1.0f, -x, 0.0f),
                edge(1.0f, x, 0.0f), thickness, paint);
        for (int row = 0; row < rows; ++row)
        {
            const float low = static_cast<float>(row) / rows;
            const float high = static_cast<float>(row + 1) / rows;
            const float lift = 0.015f;
            mesh.quad(edge(low, x, lift), edge(low, -x, lift), edge(high, -x, lift),
                      edge(high, x, lift), shade(paint, row % 2 ? 1.0f : 0.92f));
        }
        for (float end : {-x, x})
        {
            const osg::Vec3 low(end, side * (y + overhang), -drop + 0.25f);
            const osg::Vec3 high(end, 0.0f, height + 0.25f);
            const osg::Vec3 out(end > 0.0f ? 0.06f : -0.06f, 0.0f, 0.0f);
            addSlab(mesh, low, low + out, high + out, high, {0.0f, 0.0f, -0.3f}, verge);
        }
    }
}

void addHouse(Mesh& mesh, const HouseStyle& style)
{
    const float eaves = static_cast<float>(style.storeys) * style.storeyHeight + 0.5f;
    addBody(mesh, style, eaves);
    addWindows(mesh, style);
    {
        const Placed placed(mesh, osg::Vec3(0.0f, 0.0f, eaves));
        addGableRoof(mesh, style.width, style.depth, style.roofHeight, style.roof, style.trim);
    }
    if (style.chimney)
        addChimney(mesh, style, eaves + style.roofHeight);
    if (style.porch)
        addPorch(mesh, style);
}

void addChurch(Mesh& mesh)
{
    HouseStyle nave;
    nave.width = 14.0f;
    nave.depth = 8.0f;
    nave.storeys = 1;
    nave.storeyHeight = 5.0f;
    nave.roofHeight = 5.0f;
    nave.windowsAcross = 4;
    nave.windowsDeep = 1;
    nave.wall = colour(0xf2ede0);
    nave.trim = colour(0xe2dccb);
    nave.roof = colour(0x8a4a35);
    nave.chimney = false;
    addHouse(mesh, nave);

    const Placed placed(mesh, osg::Vec3(-8.5f, 0.0f, 0.0f));
    addBox(mesh, {-2.2f, -2.2f, -2.0f}, {2.2f, 2.2f, 13.0f}, nave.wall);
    addBox(mesh, {-2.4f, -2.4f, 13.0f}, {2.4f, 2.4f, 13.4f}, nave.trim);
    forEachWall(mesh, 4.4f, 4.4f, [&](int, float)
    {
        const Placed louvre(mesh, osg::Vec3(0.0f, 0.0f, 9.6f));
        addWindow(mesh, 1.1f, 2.0f, nave.trim);
    });
    const Placed spire(mesh, osg::Matrixd::rotate(osg::PI_4, osg::Z_AXIS)
                                 * osg::Matrixd::translate(0.0, 0.0, 13.4));
    addTurned(mesh, {{3.2f, 0.0f}, {2.2f, 1.6f}, {0.0f, 9.0f}}, 4,
              [](int, int) { return colour(0x4c6b62); });
    addTube(mesh, {0.0f, 0.0f, 8.8f}, {0.0f, 0.0f, 10.4f}, 0.06f, 0.06f, 5, colour(0xd0a83c));
}

}

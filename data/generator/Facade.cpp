#include "Facade.h"

#include "House.h"
#include "Shapes.h"

#include <osg/Math>

namespace waterdata
{

namespace
{

const float shopHeight = 3.6f;
const float storeyHeight = 3.0f;
const float houseDepth = 9.0f;

void addShopWindow(Mesh& mesh, float left, float right, const Colour& frame)
{
    const Placed placed(mesh, osg::Vec3((left + right) * 0.5f, -0.02f, 0.75f));
    addWindow(mesh, right - left, 1.85f, frame, 3);
    const float half = (right - left) * 0.5f;
    addBox(mesh, {-half - 0.1f, -0.06f, -0.72f}, {half + 0.1f, 0.0f, -0.12f}, shade(frame, 0.85f));
}

void addAwning(Mesh& mesh, float left, float right, const Colour& paint)
{
    const int stripes = 10;
    const float step = (right - left) / stripes;
    for (int stripe = 0; stripe < stripes; ++stripe)
    {
        const float x = left + step * static_cast<float>(stripe);
        const Colour cloth = stripe % 2 ? colour(0xf3eee2) : paint;
        addSlab(mesh, {x, -1.35f, 2.45f}, {x + step, -1.35f, 2.45f}, {x + step, -0.05f, 3.0f},
                {x, -0.05f, 3.0f}, {0.0f, 0.0f, -0.03f}, cloth);
        addBox(mesh, {x, -1.37f, 2.22f}, {x + step, -1.34f, 2.46f}, cloth);
    }
}

void addShop(Mesh& mesh, const FacadeStyle& style)
{
    const float doorLeft = style.width - 1.75f;
    addBox(mesh, {0.25f, -0.10f, 2.95f}, {style.width - 0.25f, 0.0f, 3.45f}, style.shop);
    addBox(mesh, {0.15f, -0.18f, 3.45f}, {style.width - 0.15f, 0.0f, 3.55f}, style.trim);
    for (float pillar : {0.25f, doorLeft - 0.2f, style.width - 0.5f})
        addBox(mesh, {pillar, -0.09f, 0.0f}, {pillar + 0.25f, 0.0f, 2.95f}, style.shop);
    addShopWindow(mesh, 0.65f, doorLeft - 0.35f, style.shop);
    // The sign's letters, as pale bars.
    const float letter = 0.22f;
    const int letters = static_cast<int>((style.width - 2.6f) / 0.34f);
    for (int index = 0; index < letters; ++index)
    {
        const float x = 1.3f + 0.34f * static_cast<float>(index);
        const float tall = index % 3 == 1 ? 0.18f : 0.26f;
        addBox(mesh, {x, -0.12f, 3.07f}, {x + letter, -0.09f, 3.07f + tall}, colour(0xf0e6c8));
    }
    const Placed door(mesh, osg::Vec3(doorLeft + 0.65f, -0.02f, 0.05f));
    addDoor(mesh, 1.0f, 2.3f, style.shop, shade(style.shop, 1.4f));
    if (style.hasAwning)
    {
        const Placed front(mesh, osg::Vec3(-doorLeft - 0.65f, 0.0f, -0.05f));
        addAwning(mesh, 0.5f, doorLeft - 0.2f, style.awning);
    }
}

void addUpperWindows(Mesh& mesh, const FacadeStyle& style)
{
    const float spacing = style.width / static_cast<float>(style.windows);
    for (int storey = 1; storey < style.storeys; ++storey)
    {
        for (int window = 0; window < style.windows; ++window)
        {
            const float x = (static_cast<float>(window) + 0.5f) * spacing;
            const float z = shopHeight + storeyHeight * static_cast<float>(storey - 1) + 0.75f;
            const Placed placed(mesh, osg::Vec3(x, 0.0f, z));
            addWindow(mesh, 0.95f, 1.6f, style.trim);
            addBox(mesh, {-0.68f, -0.13f, 1.72f}, {0.68f, 0.0f, 1.86f}, style.trim);
        }
    }
}

void addFrontGable(Mesh& mesh, const FacadeStyle& style, float top)
{
    const float middle = style.width * 0.5f;
    const float peak = 3.4f;
    mesh.triangle({0.0f, 0.0f, top}, {style.width, 0.0f, top}, {middle, 0.0f, top + peak},
                  style.wall);
    {
        const Placed window(mesh, osg::Vec3(middle, 0.0f, top + 0.6f));
        addWindow(mesh, 0.8f, 1.1f, style.trim);
    }
    const Placed roof(mesh, osg::Matrixd::rotate(osg::PI_2, osg::Z_AXIS)
                                * osg::Matrixd::translate(middle, houseDepth * 0.5, top));
    addGableRoof(mesh, houseDepth, style.width - 0.5f, peak, style.roof, style.trim);
}

void addEavesRoof(Mesh& mesh, const FacadeStyle& style, float top)
{
    addBox(mesh, {0.0f, -0.35f, top - 0.2f}, {style.width, 0.0f, top + 0.12f}, style.trim);
    addSlab(mesh, {0.0f, -0.3f, top + 0.1f}, {style.width, -0.3f, top + 0.1f},
            {style.width, 4.0f, top + 2.9f}, {0.0f, 4.0f, top + 2.9f}, {0.0f, 0.0f, -0.2f},
            style.roof);
    addSlab(mesh, {0.0f, 4.0f, top + 2.9f}, {style.width, 4.0f, top + 2.9f},
            {style.width, houseDepth, top}, {0.0f, houseDepth, top}, {0.0f, 0.0f, -0.2f},
            style.roof);
    for (float end : {0.0f, style.width})
        mesh.triangle({end, 0.0f, top}, {end, houseDepth, top}, {end, 4.0f, top + 2.8f},
                      style.wall);
    const Placed chimney(mesh, osg::Vec3(style.width * 0.8f, 3.6f, top + 2.0f));
    addBox(mesh, {-0.5f, -0.35f, 0.0f}, {0.5f, 0.35f, 1.9f}, colour(0x95604c));
}

}

float facadeHeight(const FacadeStyle& style)
{
    return shopHeight + storeyHeight * static_cast<float>(style.storeys - 1);
}

void addFacade(Mesh& walls, Mesh& details, const FacadeStyle& style)
{
    const float top = facadeHeight(style);
    addBox(walls, {0.0f, 0.0f, -0.3f}, {style.width, houseDepth, top}, style.wall);
    addBox(details, {0.0f, -0.05f, 0.0f}, {style.width, 0.0f, 0.45f}, colour(0x8f8a80));
    addShop(details, style);
    addUpperWindows(details, style);
    if (style.gabled)
        addFrontGable(details, style, top);
    else
        addEavesRoof(details, style, top);
}

}

#include "TreeCards.h"

#include "Arrays.h"
#include "Noise.h"
#include "Random.h"

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Texture2D>

#include <cmath>

namespace waterdata
{

namespace
{

const int pictureWidth = 128;
const int pictureHeight = 256;

// Paints with round dabs, from back to front, on an empty picture.
class Painter
{
public:
    Painter() : _image(new osg::Image)
    {
        _image->allocateImage(pictureWidth, pictureHeight, 1, GL_RGBA, GL_UNSIGNED_BYTE);
        // Transparent texels wear the leaves' colour, or filtering would draw dark rims.
        for (int y = 0; y < pictureHeight; ++y)
        {
            for (int x = 0; x < pictureWidth; ++x)
                _image->setColor(osg::Vec4(0.42f, 0.50f, 0.22f, 0.0f), x, y);
        }
    }

    void dab(const osg::Vec2& centre, float radius, const Colour& paint, float strength)
    {
        for (int y = static_cast<int>(centre.y() - radius) - 1; y <= centre.y() + radius + 1; ++y)
        {
            for (int x = static_cast<int>(centre.x() - radius) - 1; x <= centre.x() + radius + 1;
                 ++x)
            {
                if (x < 0 || y < 0 || x >= pictureWidth || y >= pictureHeight)
                    continue;
                const float distance = (osg::Vec2(x + 0.5f, y + 0.5f) - centre).length();
                blend(x, y, paint, strength * smoothStep(radius + 0.7f, radius - 0.7f, distance));
            }
        }
    }

    osg::ref_ptr<osg::Image> image() const { return _image; }

private:
    osg::ref_ptr<osg::Image> _image;

    void blend(int x, int y, const Colour& paint, float cover)
    {
        if (cover <= 0.0f)
            return;
        const osg::Vec4 before = _image->getColor(x, y);
        const float alpha = cover + before.w() * (1.0f - cover);
        const Colour under(before.x(), before.y(), before.z());
        _image->setColor(osg::Vec4(mix(under, paint, cover / alpha), alpha), x, y);
    }
};

osg::ref_ptr<osg::Image> birchPicture()
{
    Painter painter;
    Random random(5);
    for (int y = 0; y < 200; ++y)
    {
        const float middle = 64.0f + 3.0f * std::sin(y * 0.02f);
        const float radius = mix(5.0f, 1.3f, y / 200.0f);
        const bool dark = noise(osg::Vec3(0.0f, y * 0.22f, 0.0f)) > 0.35f;
        painter.dab({middle, static_cast<float>(y)}, radius, colour(dark ? 0x6d665e : 0xe9e4d8),
                    1.0f);
    }
    for (int leaf = 0; leaf < 1500; ++leaf)
    {
        const float up = random.unit();
        const float y = mix(62.0f, 246.0f, up);
        const float reach = 52.0f * std::pow(std::sin(osg::PIf * mix(0.12f, 1.0f, up)), 0.7f);
        const float side = random.between(-1.0f, 1.0f);
        const float clump = noise(osg::Vec3(side * 2.4f, up * 7.0f, 2.0f));
        if (clump < -0.15f)
            continue;
        const float lit = 0.72f + 0.25f * up - 0.22f * side + random.between(-0.16f, 0.16f);
        const Colour leaves = mix(colour(0x6f8f3a), colour(0xb3b351), random.unit() * 0.7f);
        painter.dab({64.0f + side * reach, y - 0.12f * std::fabs(side) * reach},
                    random.between(1.6f, 3.4f), shade(leaves, lit), 0.9f);
    }
    osg::ref_ptr<osg::Image> picture = painter.image();
    picture->setFileName("birch.png");
    return picture;
}

osg::ref_ptr<osg::Geometry> card(const osg::Vec3& foot, float height, float turn, float brightness)
{
    const osg::Vec3 across(std::cos(turn) * height * 0.25f, std::sin(turn) * height * 0.25f, 0.0f);
    const osg::Vec3 up(0.0f, 0.0f, height);
    osg::ref_ptr<osg::Vec3Array> points = new osg::Vec3Array;
    points->push_back(foot - across);
    points->push_back(foot + across);
    points->push_back(foot - across + up);
    points->push_back(foot + across + up);
    osg::ref_ptr<osg::Vec2Array> texels = new osg::Vec2Array;
    for (int corner = 0; corner < 4; ++corner)
        texels->push_back(osg::Vec2(corner % 2, corner / 2));
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(points);
    geometry->setTexCoordArray(0, texels, osg::Array::BIND_PER_VERTEX);
    geometry->setColorArray(only<osg::Vec4Array>({brightness, brightness, brightness, 1.0f}),
                            osg::Array::BIND_OVERALL);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, 4));
    return geometry;
}

}

osg::ref_ptr<osg::Group> treeCards(const LakeLand& land, const Daylight&)
{
    const osg::Vec2 places[] = {{-8.5f, 45.5f}, {-6.8f, 46.5f}, {-10.2f, 47.2f}, {-22.0f, 37.5f},
                                {-24.0f, 36.0f}, {20.5f, 44.0f}, {22.3f, 42.6f}, {18.0f, 45.8f},
                                {-33.5f, 2.0f}, {-34.8f, 4.2f}};
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->setName("tree cards");
    Random random(13);
    for (const osg::Vec2& place : places)
    {
        osg::ref_ptr<osg::Geode> geode = new osg::Geode;
        geode->addDrawable(card(land.onGround(place.x(), place.y(), -0.15f),
                                random.between(6.5f, 9.0f), random.between(-0.4f, 0.4f),
                                random.between(0.88f, 1.0f)));
        group->addChild(geode);
    }

    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(birchPicture());
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    osg::StateSet* state = group->getOrCreateStateSet();
    state->setTextureAttributeAndModes(0, texture);
    state->setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
    state->setMode(GL_BLEND, osg::StateAttribute::ON);
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LESS, 0.0, 1.0, false));
    state->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    return group;
}

}

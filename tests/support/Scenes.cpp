#include "Scenes.h"

#include <osg/Geometry>
#include <osg/LightSource>
#include <osg/Material>
#include <osg/ShapeDrawable>

#include <cmath>

using osgWaterReflect::WaterSurface;

namespace
{

osg::ref_ptr<osg::Geode> createShape(osg::Shape* shape, const osg::Vec4& colour)
{
    osg::ref_ptr<osg::TessellationHints> hints = new osg::TessellationHints;
    hints->setDetailRatio(0.3f);
    osg::ref_ptr<osg::ShapeDrawable> drawable = new osg::ShapeDrawable(shape, hints);
    drawable->setColor(colour);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(drawable);
    return geode;
}

void unlit(osg::Node& node)
{
    node.getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
}

} // namespace

osg::ref_ptr<osg::Group> scenes::createHarbour()
{
    osg::ref_ptr<osg::Group> harbour = new osg::Group;
    harbour->addChild(createShape(new osg::Box(osg::Vec3(-4, 3, 1), 2.1f, 2.2f, 4.3f),
                                  osg::Vec4(0.9, 0.5, 0.3, 1)));
    harbour->addChild(createShape(new osg::Box(osg::Vec3(4.5, 5, 2.5), 3.3f, 1.4f, 1.7f),
                                  osg::Vec4(0.4, 0.8, 0.5, 1)));
    harbour->addChild(
        createShape(new osg::Sphere(osg::Vec3(1, 1, 1.6), 1.2f), osg::Vec4(0.8, 0.8, 0.2, 1)));
    harbour->addChild(
        createShape(new osg::Sphere(osg::Vec3(-1.5, -3, 0.1), 0.6f), osg::Vec4(0.9, 0.2, 0.3, 1)));
    for (int i = 0; i < 4; ++i)
        harbour->addChild(
            createShape(new osg::Cylinder(osg::Vec3(2.6 + 0.9 * i, -1.0 + i, 0.3), 0.2f, 3.1f),
                        osg::Vec4(0.5, 0.5, 0.9, 1)));

    osg::StateSet* stateSet = harbour->getOrCreateStateSet();
    stateSet->setTextureAttributeAndModes(0, createChequers());
    stateSet->setMode(GL_LIGHT1, osg::StateAttribute::ON);
    stateSet->setMode(GL_NORMALIZE, osg::StateAttribute::ON);
    osg::ref_ptr<osg::LightSource> lamp = new osg::LightSource;
    lamp->getLight()->setLightNum(1);
    lamp->getLight()->setPosition(osg::Vec4(-6, -5, 6, 1));
    lamp->getLight()->setDiffuse(osg::Vec4(0.7, 0.6, 0.3, 1));
    harbour->addChild(lamp);
    return harbour;
}

osg::ref_ptr<WaterSurface> scenes::inView(const osg::ref_ptr<WaterSurface>& water)
{
    osgWaterReflect::ReflectionSettings settings = water->getReflection();
    settings.capture = osgWaterReflect::CaptureKind::VIEW;
    water->setReflection(settings);
    return water;
}

osg::ref_ptr<WaterSurface> scenes::createLake(double level, double size)
{
    return inView(WaterSurface::createRectangle(osg::Vec3(0, 0, level), osg::Vec3(size, 0, 0),
                                                osg::Vec3(0, size, 0)));
}

osg::ref_ptr<WaterSurface> scenes::withoutBand(const osg::ref_ptr<WaterSurface>& water)
{
    osgWaterReflect::ViewSettings settings = water->getViewSettings();
    settings.guardBand = osgWaterReflect::GuardBandKind::NONE;
    water->setViewSettings(settings);
    return water;
}

osg::ref_ptr<osg::Group> scenes::createBoxes()
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    const auto add = [&](double x, double y, double lowest, double width, double height)
    {
        const osg::Vec3 centre(x, y, lowest + 0.5 * height);
        group->addChild(new osg::ShapeDrawable(new osg::Box(centre, width, width, height)));
    };
    add(-6, 18, -0.5, 3, 4);
    add(-2.5, 9, -0.5, 1, 1.4);
    add(1.5, 12, -0.5, 1.5, 3);
    add(4, 20, -0.5, 4, 6);
    add(-14, 34, -0.5, 6, 9);
    add(12, 40, -0.5, 5, 8);
    add(0, 45, -0.5, 8, 7);
    add(2.5, 7, -0.2, 0.6, 0.7);
    add(-0.8, 6, -0.2, 0.4, 0.5);
    add(-4.5, 13, 0.8, 1, 1);
    return group;
}

osg::ref_ptr<WaterSurface> scenes::createBoxesWater()
{
    return inView(WaterSurface::createRectangle(osg::Vec3(0, 20, 0), osg::Vec3(200, 0, 0),
                                                osg::Vec3(0, 200, 0)));
}

osg::ref_ptr<osg::Node> scenes::createStandIn()
{
    return createQuad(osg::Vec3(-30, -30, 0), osg::Vec3(60, 0, 0), osg::Vec3(0, 60, 0),
                      osg::Vec4(1, 0, 1, 1));
}

int scenes::countDifferentOutsideStandIn(const osg::Image& withStandIn, const osg::Image& a,
                                         const osg::Image& b, double tolerance)
{
    int count = 0;
    for (int y = 0; y < a.t(); ++y)
        for (int x = 0; x < a.s(); ++x)
        {
            const osg::Vec4 stand = withStandIn.getColor(x, y);
            const bool water = stand.r() == 1.0f && stand.g() == 0.0f && stand.b() == 1.0f;
            const osg::Vec4 difference = a.getColor(x, y) - b.getColor(x, y);
            bool differs = false;
            for (int i = 0; i < 3; ++i)
                differs = differs || !(std::abs(difference[i]) <= tolerance);
            count += !water && differs;
        }
    return count;
}

osg::ref_ptr<osg::Node> scenes::createBox(const osg::Vec3& centre, const osg::Vec3& size,
                                          const osg::Vec4& colour)
{
    osg::ref_ptr<osg::Node> box =
        createShape(new osg::Box(centre, size.x(), size.y(), size.z()), colour);
    unlit(*box);
    return box;
}

osg::ref_ptr<osg::Node> scenes::createQuad(const osg::Vec3& corner, const osg::Vec3& widthVec,
                                           const osg::Vec3& heightVec, const osg::Vec4& colour)
{
    osg::ref_ptr<osg::Geometry> quad = osg::createTexturedQuadGeometry(corner, widthVec, heightVec);
    osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array(osg::Array::BIND_OVERALL, 1);
    (*colours)[0] = colour;
    quad->setColorArray(colours);
    unlit(*quad);
    return quad;
}

osg::ref_ptr<osg::Texture2D> scenes::createChequers()
{
    const int size = 64;
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(size, size, 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            image->setColor(
                (x / 8 + y / 8) % 2 ? osg::Vec4(1, 1, 1, 1) : osg::Vec4(0.5, 0.6, 0.7, 1), x, y);
    return new osg::Texture2D(image);
}

osg::ref_ptr<osg::Group> scenes::together(std::initializer_list<osg::ref_ptr<osg::Node>> nodes)
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    for (const osg::ref_ptr<osg::Node>& node : nodes)
        group->addChild(node);
    return group;
}

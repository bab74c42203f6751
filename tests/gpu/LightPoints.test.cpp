// Lamps of osgSim, which are drawn in eye space, without a matrix and without a bound.

#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osgWaterReflect/TrochoidalWaves>

#include <osgSim/LightPointNode>

using namespace osgWaterReflect;

namespace
{

const int WIDTH = 160;
const int HEIGHT = 120;

osg::ref_ptr<osg::Node> createWall()
{
    return scenes::createQuad(osg::Vec3(-12, 4, -1), osg::Vec3(24, 0, 0), osg::Vec3(0, 0, 9),
                              osg::Vec4(0.2, 0.2, 0.2, 1));
}

// A row of bright lamps in front of the wall, each a few pixels wide.
osg::ref_ptr<osg::Node> createLamps()
{
    const osg::ref_ptr<osgSim::LightPointNode> lamps = new osgSim::LightPointNode;
    for (int i = -3; i <= 3; ++i)
        lamps->addLightPoint(
            osgSim::LightPoint(true, osg::Vec3(2 * i, 3.5, 2), osg::Vec4(1, 1, 0, 1), 1.0f, 0.3f));
    lamps->setMinPixelSize(5.0f);
    lamps->setMaxPixelSize(5.0f);
    return lamps;
}

} // namespace

// Crashes where StageContent's extentOf takes every leaf for one with a matrix.
TEST_CASE("lamps that are drawn in eye space are seen in the water")
{
    const auto capture = GENERATE(CaptureKind::VIEW, CaptureKind::FRAME, CaptureKind::MIRROR,
                                  CaptureKind::VIEW_AND_MIRROR, CaptureKind::AUTOMATIC);
    const auto band = GENERATE(GuardBandKind::NONE, GuardBandKind::ADAPTIVE, GuardBandKind::FIXED);
    const bool waves = GENERATE(false, true);
    CAPTURE(static_cast<int>(capture), static_cast<int>(band), waves);
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    ReflectionSettings settings;
    settings.capture = capture;
    REQUIRE(lake->setReflection(settings));
    ViewSettings viewSettings;
    viewSettings.guardBand = band;
    REQUIRE(lake->setViewSettings(viewSettings));
    if (waves) lake->setWaves(TrochoidalWaves::createBreeze(2.0, 0.02));

    OffscreenView view(WIDTH, HEIGHT);
    view.look(osg::Vec3d(0, -14, 3), osg::Vec3d(0, 0, 1.5), 40.0);
    const osg::ref_ptr<osg::Node> wall = createWall();
    const osg::ref_ptr<osg::Image> waterIsMagenta =
        copyOf(view.render(scenes::together({wall, scenes::createStandIn()})));
    const osg::ref_ptr<osg::Group> scene = scenes::together({wall, lake});
    const osg::ref_ptr<osg::Image> dark = copyOf(view.render(scene));
    scene->addChild(createLamps());
    const osg::Image& lit = view.render(scene);

    int lampPixels = 0;
    int reflectedPixels = 0;
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x)
        {
            const osg::Vec4 gain = pixel(lit, x, y) - pixel(*dark, x, y);
            if (gain.r() <= 0.02f) continue;
            const bool water = pixel(*waterIsMagenta, x, y) == osg::Vec4(1, 0, 1, 1);
            ++(water ? reflectedPixels : lampPixels);
        }
    CHECK(lampPixels > 7 * 9);
    // A frame is copied before what is blended is drawn, as light points are.
    if (capture != CaptureKind::FRAME) CHECK(reflectedPixels > 7 * 3);
}

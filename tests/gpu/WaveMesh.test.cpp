// Water that only its waves bring into view, as a stock viewer draws it.

#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/WaterSurface>

using namespace osgWaterReflect;

namespace
{

int countWater(const osg::Image& image)
{
    int count = 0;
    for (int y = 0; y < image.t(); ++y)
        for (int x = 0; x < image.s(); ++x)
            count += pixel(image, x, y).r() > 0.5f;
    return count;
}

} // namespace

// Falls when WaterSurface::traverse asks isCulled(sheet->localBound(0.0)), computeBound leaves out
// the waves, or the mesh's `outside` knows no reach.
TEST_CASE("a crest that rises into the view is drawn, though the still water is below it")
{
    // A trough at the eye, 20 m long waves: the next crest stands 1.2 m high 10 m away.
    TrochoidalWave wave;
    wave.amplitude = 1.0;
    wave.length = 20.0;
    wave.directionDegrees = 90.0;
    wave.phase = osg::PI;
    osg::ref_ptr<TrochoidalWaves> waves = new TrochoidalWaves;
    REQUIRE(waves->setWaves({wave}));
    osg::ref_ptr<WaterSurface> water = scenes::inView(WaterSurface::createRectangle(
        osg::Vec3(0, 32, 0), osg::Vec3(60, 0, 0), osg::Vec3(0, 60, 0)));
    WaterOptics optics;
    optics.waterColour.set(1, 0, 0);
    REQUIRE(water->setOptics(optics));
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(water);

    OffscreenView view(160, 120);
    view.camera().setClearColor(osg::Vec4(0, 0, 0, 1));
    // 24 degrees up at half a field of view of 23: the lowest line of sight climbs by 1 degree
    // from 0.3 m over the still water, and passes the crest 0.7 m below its top.
    const osg::Vec3d eye(0, 0, 0.3);
    const double pitch = 24.0 * osg::PI / 180.0;
    view.look(eye, eye + osg::Vec3d(0, std::cos(pitch), std::sin(pitch)));
    CHECK(countWater(view.render(root)) == 0); // calm

    water->setWaves(waves);
    const osg::Image& image = view.render(root);
    keep(image, "crest");
    // The crest stands 3.4 degrees over the border, 9 rows; steep reflections take some of them.
    CHECK(countWater(image) > 100);
}

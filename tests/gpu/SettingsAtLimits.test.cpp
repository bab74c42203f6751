// Settings of any value, drawn where they are not refused.

#include "support/AnySettings.h"
#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Refusals.h"
#include "support/Scenes.h"

#include <osgWaterReflect/WaterSurface>

#include <algorithm>
#include <cmath>

using namespace osgWaterReflect;
using DebugView = WaterSurface::DebugView;

namespace
{

struct Tried
{
    int taken = 0;
    int refused = 0;
    int silent = 0; // refused without a message, or taken with one
    int notFinite = 0;
    int withWater = 0; // frames that show it
};

// One kind of settings in each frame, all on the same water: what is refused must leave it sound.
Tried tryAny(int settings)
{
    OffscreenView view(16, 12, OffscreenView::Format::RGBA32F);
    view.look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
    const osg::ref_ptr<WaterSurface> water = scenes::createBoxesWater();
    const osg::ref_ptr<TrochoidalWaves> waves = new TrochoidalWaves;
    const osg::ref_ptr<osg::Group> scene = scenes::together({scenes::createBoxes(), water});
    Chance chance(4);
    Refusals refusals;
    Tried tried;
    for (int i = 0; i < settings; ++i)
    {
        bool taken = false;
        switch (chance.integer(0, 7))
        {
        case 0:
            taken = water->setOptics(anySettings<WaterOptics>(chance));
            break;
        case 1:
        {
            auto detail = anySettings<SurfaceDetail>(chance);
            detail.maxVertices = std::min(detail.maxVertices, 3000u); // more would only take longer
            taken = water->setDetail(detail);
            break;
        }
        case 2:
            taken = waves->setWaves(anyWaves(chance));
            break;
        case 3:
        case 4:
            taken = water->setReflection(anySettings<ReflectionSettings>(chance));
            break;
        default:
            taken = water->setViewSettings(anySettings<ViewSettings>(chance));
            break;
        }
        tried.taken += taken;
        tried.refused += !taken;
        tried.silent += taken != refusals.take().empty();
        if (!taken) continue;

        water->setWaves(chance.once(2) ? waves.get() : nullptr);
        const DebugView shown[] = {DebugView::NONE, DebugView::HIT, DebugView::NORMAL};
        water->setDebugView(shown[chance.integer(0, 2)]);
        const double time = chance.once(2) ? 0.0 : std::pow(10.0, chance.between(-3.0, 9.0));
        const osg::Image& picture = view.render(scene, time);
        tried.notFinite += countNotFinite(picture) > 0;
        if (water->getDebugView() == DebugView::HIT)
            tried.withWater += pixel(picture, 8, 2).w() > 1.0f;
        refusals.take();
    }
    return tried;
}

void check(const Tried& tried, int settings)
{
    CHECK(tried.taken > settings / 4);
    CHECK(tried.refused > settings / 4);
    CHECK(tried.withWater > tried.taken / 5);
    CHECK(tried.silent == 0);
    CHECK(tried.notFinite == 0);
}

} // namespace

// Falls where check() takes a thickness of NaN, or a refractive index below 1.
TEST_CASE("settings of any value are refused, or drawn without NaN")
{
    check(tryAny(2000), 2000);
}

TEST_CASE("a million settings of any value are refused, or drawn without NaN", "[.full]")
{
    check(tryAny(1000000), 1000000);
}

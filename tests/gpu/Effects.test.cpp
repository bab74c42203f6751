// A test-only effect in the picture.

#include "support/Catch.h"
#include "support/ListedEffect.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"
#include "support/mist/Mist.h"

#include <cmath>

using osgWaterReflect::WaterSurface;

// Falls when shade.glsl leaves out `#each "over"`, or calls it in a debug view; and when
// EffectState is not drawn with.
TEST_CASE("an effect over the water changes its pixels, and they are the old ones when it is off")
{
    const ListedEffect<Mist> mist;
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    const osg::ref_ptr<osg::Group> root = scenes::together({scenes::createHarbour(), lake});
    OffscreenView view(160, 120, OffscreenView::Format::RGBA32F);
    view.look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
    view.render(root);
    const osg::ref_ptr<osg::Image> without = copyOf(view.render(root));

    const float share = 0.25f;
    lake->setUserValue("mist", share);
    const osg::ref_ptr<osg::Image> misty = copyOf(view.render(root));
    keep(*misty, "effect-mist");
    int changed = 0;
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x)
        {
            const osg::Vec4 old = pixel(*without, x, y);
            const osg::Vec4 now = pixel(*misty, x, y);
            if (now == old) continue;
            ++changed;
            for (int i = 0; i < 3; ++i)
                REQUIRE(std::abs(now[i] - (old[i] + share * (1.0f - old[i]))) < 1e-6f);
        }
    CHECK(changed > 160 * 120 / 3);

    lake->setDebugView(WaterSurface::DebugView::REFLECTION);
    const osg::ref_ptr<osg::Image> reflection = copyOf(view.render(root));
    lake->setUserValue("mist", 0.0f);
    CHECK(countDifferent(*reflection, view.render(root)) == 0);

    lake->setDebugView(WaterSurface::DebugView::NONE);
    CHECK(countDifferent(*without, view.render(root)) == 0);
}

// A test-only effect in the picture.

#include "support/Catch.h"
#include "support/ListedEffect.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"
#include "support/glass/Glass.h"
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

// Breaks where the plan makes the eye's image only for rays (planEffects, eyeImage), hands the
// mirrored one to the effect, or the effect's units are those of another image.
TEST_CASE("an effect that looks at the scene sees it, whatever rays are looked for in")
{
    const ListedEffect<Glass> glass;
    const auto capture = GENERATE(
        osgWaterReflect::CaptureKind::MIRROR, osgWaterReflect::CaptureKind::VIEW,
        osgWaterReflect::CaptureKind::FRAME, osgWaterReflect::CaptureKind::VIEW_AND_MIRROR);
    const double traceScale = GENERATE(1.0, 0.5);
    CAPTURE(static_cast<int>(capture), traceScale);
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    osgWaterReflect::ReflectionSettings settings;
    settings.capture = capture;
    REQUIRE(lake->setReflection(settings));
    osgWaterReflect::ViewSettings viewSettings;
    viewSettings.traceScale = traceScale;
    REQUIRE(lake->setViewSettings(viewSettings));
    const osg::ref_ptr<osg::Node> pile =
        scenes::createBox(osg::Vec3(0, 0, -1), osg::Vec3(4, 4, 1), osg::Vec4(0.9f, 0.2f, 0.1f, 1));
    const osg::ref_ptr<osg::Group> root = scenes::together({scenes::createHarbour(), pile, lake});
    OffscreenView view(160, 120, OffscreenView::Format::RGBA32F);
    view.look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
    const auto picture = [&](const osg::Vec3& waterColour)
    {
        osgWaterReflect::WaterOptics optics = lake->getOptics();
        optics.waterColour = waterColour;
        REQUIRE(lake->setOptics(optics));
        view.render(root);
        return copyOf(view.render(root));
    };
    // Water mixes its body with what it reflects: from black to white, by the share of the body.
    const osg::ref_ptr<osg::Image> black = picture(osg::Vec3(0, 0, 0));
    const osg::ref_ptr<osg::Image> white = picture(osg::Vec3(1, 1, 1));
    lake->setUserValue("glass", true);
    const osg::ref_ptr<osg::Image> through = picture(osg::Vec3(0, 0, 0));
    keep(*through, "effect-glass");
    lake->setNodeMask(0);
    view.render(root);
    const osg::ref_ptr<osg::Image> scene = copyOf(view.render(root));

    int water = 0;
    double worst = 0.0;
    int red = 0;
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x)
        {
            const osg::Vec4 body = pixel(*white, x, y) - pixel(*black, x, y);
            if (body.x() <= 0.0f) continue;
            ++water;
            const osg::Vec4 seen = pixel(*scene, x, y);
            const osg::Vec4 added = pixel(*through, x, y) - pixel(*black, x, y);
            red += added.x() > 0.3f && added.x() > 3.0f * added.y();
            for (int i = 0; i < 3; ++i)
                worst = std::max<double>(worst, std::abs(added[i] - body[i] * seen[i]));
        }
    CHECK(water > 160 * 120 / 3);
    CHECK(red > 50); // what stands under the water
    // A capture may be of 8 bits.
    CHECK(worst <= 0.5 / 255 + 1e-5);
}

// The guard band as a view's captures have it; how wide it must be is tested in tests/unit.

#include "support/CapturedImages.h"
#include "support/Catch.h"
#include "support/MirrorTruth.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osg/Math>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace osgWaterReflect;

namespace
{

const int WIDTH = 160;
const int HEIGHT = 120;

struct BandView : OffscreenView
{
    BandView() : OffscreenView(WIDTH, HEIGHT), captured(CapturedImages::of(camera())) {}

    // Looking along +y from above the boxes' water.
    void pitch(double degrees, double height = 2.0)
    {
        const double down = osg::DegreesToRadians(degrees);
        const osg::Vec3d eye(0, -2, height);
        look(eye, eye + osg::Vec3d(0, std::cos(down), -std::sin(down)));
    }

    int capturedWidth() const { return captured->one().windowZ->s(); }
    int capturedHeight() const { return captured->one().windowZ->t(); }

    osg::ref_ptr<CapturedImages> captured;
};

osg::ref_ptr<WaterSurface> withBand(const osg::ref_ptr<WaterSurface>& water, GuardBandKind kind,
                                    double maxExtraPixels = 1.0)
{
    ViewSettings settings = water->getViewSettings();
    settings.guardBand = kind;
    settings.maxExtraPixels = maxExtraPixels;
    REQUIRE(water->setViewSettings(settings));
    return water;
}

// A small pond in front of the boxes, higher than their water.
osg::ref_ptr<WaterSurface> createPond(double level, double side)
{
    return WaterSurface::createRectangle(osg::Vec3(0, 6, level), osg::Vec3(side, 0, 0),
                                         osg::Vec3(0, side, 0));
}

} // namespace

// Falls when the band is left out, cut to the wrong sides, or the scene's extent is taken through
// another matrix than the view's.
TEST_CASE("with its band the eye's capture shows nearly all that calm water reflects")
{
    for (const double pitchDegrees : {15.0, 20.0, 25.0})
    {
        INFO(pitchDegrees << " degrees");
        const double pitch = osg::DegreesToRadians(pitchDegrees);
        const osg::Vec3d eye(0, -2, 2.0);
        const MirrorView view = {eye, eye + osg::Vec3d(0, std::cos(pitch), -std::sin(pitch))};
        const osg::Plane level(0, 0, 1, 0);
        const auto rightShare = [&](const osg::ref_ptr<WaterSurface>& water, const char* name)
        {
            const MirrorComparison result =
                compareWithMirror(*scenes::createBoxes(), *water, level, view, name);
            return static_cast<double>(result.right) / result.waterPixels;
        };
        const double with = rightShare(scenes::createBoxesWater(), "band");
        const double without =
            rightShare(scenes::withoutBand(scenes::createBoxesWater()), "no band");
        WARN(pitchDegrees << " degrees: right " << 100.0 * with << " %, without a band "
                          << 100.0 * without << " %");
        // The rest are edges, and sides of boxes that face away from the eye.
        CHECK(with > 0.99);
        CHECK(with > without + 0.005);
    }
}

// Falls when rounding makes a pixel of nothing, or content or water out of view asks for a band.
TEST_CASE("a level view of calm water has no band")
{
    BandView view;
    const osg::ref_ptr<osg::Group> scene =
        scenes::together({scenes::createBoxes(), scenes::createBoxesWater()});
    view.pitch(0.0);
    view.render(scene);
    CHECK(view.capturedWidth() == WIDTH);
    CHECK(view.capturedHeight() == HEIGHT);
    view.pitch(20.0);
    view.render(scene);
    CHECK(view.capturedHeight() > HEIGHT);
}

// Falls when widened() moves the view's own part by a fraction of a pixel.
TEST_CASE("a capture with a band shows in its middle what it shows without")
{
    const osg::ref_ptr<osg::Group> boxes = scenes::createBoxes();
    const osg::ref_ptr<WaterSurface> water = scenes::createBoxesWater();
    BandView view;
    view.camera().setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    view.pitch(8.6);
    view.render(scenes::together({boxes, withBand(water, GuardBandKind::NONE)}));
    const osg::ref_ptr<osg::Image> narrow = view.captured->one().colour;
    view.render(scenes::together({boxes, withBand(water, GuardBandKind::FIXED)}));
    const osg::Image& wide = *view.captured->one().colour;
    REQUIRE(wide.s() == WIDTH + 2 * (WIDTH / 4));
    REQUIRE(wide.t() == HEIGHT + 2 * (HEIGHT / 4));
    int different = 0;
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x)
            different +=
                (pixel(wide, x + WIDTH / 4, y + HEIGHT / 4) - pixel(*narrow, x, y)).length() > 0.01;
    // Pixels whose centre lies on an edge may go to its other side.
    CHECK(different <= 5);
}

// Falls when the ceiling is not kept, or a frame's textures are those of its own size.
TEST_CASE("a turning camera changes the band, within its ceiling and without new textures")
{
    const osg::ref_ptr<osg::Group> boxes = scenes::createBoxes();
    for (const double ceiling : {0.0, 0.25, 1.0})
    {
        INFO("ceiling " << ceiling);
        BandView view;
        const osg::ref_ptr<osg::Group> scene = scenes::together(
            {boxes, withBand(scenes::createBoxesWater(), GuardBandKind::ADAPTIVE, ceiling)});
        osg::Texture2D* texture = nullptr;
        int width = 0;
        int sizes = 0;
        int lastHeight = 0;
        int reallocations = 0;
        for (double degrees = 2.0; degrees <= 40.0; degrees += 2.0)
        {
            view.pitch(degrees);
            view.render(scene);
            const int pixels = view.capturedWidth() * view.capturedHeight();
            CHECK(pixels <= (1.0 + ceiling) * WIDTH * HEIGHT);
            CHECK(pixels >= WIDTH * HEIGHT);
            sizes += view.capturedHeight() != lastHeight;
            lastHeight = view.capturedHeight();
            osg::Texture2D* const now = view.captured->textures.front();
            if (texture)
            {
                CHECK(now == texture);
                reallocations += now->getTextureWidth() != width;
            }
            texture = now;
            width = now->getTextureWidth();
        }
        CHECK((sizes > 3) == (ceiling > 0.0));
        CHECK(reallocations == (ceiling > 0.0 ? 1 : 0)); // when the first band is needed
    }
}

// Falls when what the first water asks for is all that is captured, or the first frame after a cut
// is captured as wide as the one before was.
TEST_CASE("whatever water is met first, and after a cut, the first frame is as the next")
{
    const osg::ref_ptr<osg::Group> boxes = scenes::createBoxes();
    const osg::ref_ptr<WaterSurface> water = scenes::createBoxesWater();
    // Level with the eye nearly: it needs next to nothing.
    const osg::ref_ptr<WaterSurface> pond = scenes::inView(createPond(1.9, 0.5));
    osg::ref_ptr<osg::Group> scene;
    SECTION("a level pond first")
    {
        scene = scenes::together({pond, boxes, water});
    }
    SECTION("a level pond second")
    {
        scene = scenes::together({water, boxes, pond});
    }
    const osg::ref_ptr<osg::Group> withoutPond = scenes::together({boxes, water});
    BandView alone;
    int wider = 0;
    BandView view;
    for (const double degrees : {12.0, 0.0, 20.0, 3.0, 35.0})
    {
        INFO(degrees << " degrees");
        view.pitch(degrees);
        const osg::ref_ptr<osg::Image> first = copyOf(view.render(scene));
        const int width = view.capturedWidth();
        const int height = view.capturedHeight();
        CHECK(countDifferent(view.render(scene), *first) == 0);
        CHECK(view.capturedWidth() == width);
        CHECK(view.capturedHeight() == height);

        alone.pitch(degrees);
        alone.render(withoutPond);
        wider += alone.capturedHeight() > HEIGHT;
        CHECK(width >= alone.capturedWidth());
        CHECK(height >= alone.capturedHeight());
    }
    CHECK(wider > 0);
}

// Falls when each level or thickness has a capture of its own.
TEST_CASE("64 waters of any level and thickness share one capture")
{
    const osg::ref_ptr<osg::Group> scene = scenes::createBoxes();
    for (int i = 0; i < 64; ++i)
    {
        const osg::ref_ptr<WaterSurface> pond =
            WaterSurface::createRectangle(osg::Vec3(i % 8 - 3.5, 3 + i / 8, -0.01 * i),
                                          osg::Vec3(0.9, 0, 0), osg::Vec3(0, 0.9, 0));
        ReflectionSettings settings = pond->getReflection();
        settings.thickness = 0.1 + 0.02 * i;
        REQUIRE(pond->setReflection(settings));
        scene->addChild(pond);
    }
    BandView view;
    view.pitch(15.0);
    view.render(scene);
    CHECK(view.captured->images.size() == 1);
    CHECK(view.captured->stages == 6); // and its cells and its sky
}

// Falls when the band is rounded outward by pixels that come and go with what is drawn in it, or
// the border's colours end in an edge.
TEST_CASE("nothing jumps when a camera turns slowly past what the ceiling allows")
{
    const osg::ref_ptr<osg::Group> scene =
        scenes::together({scenes::createBoxes(),
                          withBand(scenes::createBoxesWater(), GuardBandKind::ADAPTIVE, 0.3)});
    BandView view;
    osg::ref_ptr<osg::Image> before;
    std::vector<int> changes;
    for (double degrees = 4.0; degrees < 16.0; degrees += 0.1)
    {
        view.pitch(degrees);
        const osg::ref_ptr<osg::Image> now = copyOf(view.render(scene));
        if (before) changes.push_back(countDifferent(*now, *before, 0.1));
        before = now;
    }
    std::vector<int> sorted = changes;
    std::sort(sorted.begin(), sorted.end());
    WARN("pixels that change: " << sorted[sorted.size() / 2] << " in the median, at most "
                                << sorted.back());
    // All edges move; a jump would move what is between them.
    CHECK(sorted.back() < 3 * sorted[sorted.size() / 2]);
}

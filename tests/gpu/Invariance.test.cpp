// What must not change the picture: the camera's roll, whole periods of time, a line along which
// one water is made two, the resolution.

#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osgWaterReflect/TrochoidalWaves>

#include <osg/Math>

#include <algorithm>
#include <cmath>

using namespace osgWaterReflect;
using DebugView = WaterSurface::DebugView;

namespace
{

const osg::Vec3d EYE(0.3, -2.0, 2.0);
const osg::Vec3d CENTRE(0.0, 20.0, -1.0);

const auto KINDS = {CaptureKind::VIEW, CaptureKind::FRAME, CaptureKind::MIRROR,
                    CaptureKind::VIEW_AND_MIRROR};

osg::ref_ptr<WaterSurface> createPond(double left, double right)
{
    return WaterSurface::createRectangle(osg::Vec3(0.5 * (left + right), 20, 0),
                                         osg::Vec3(right - left, 0, 0), osg::Vec3(0, 60, 0));
}

void set(WaterSurface& water, CaptureKind capture, WaveModel* waves)
{
    ReflectionSettings settings;
    settings.capture = capture;
    REQUIRE(water.setReflection(settings));
    water.setWaves(waves);
}

bool differs(const osg::Vec4& a, const osg::Vec4& b)
{
    return !((a - b).length() <= 0.01);
}

// Whether the water about a pixel shows one surface, or one kind of nothing, without an edge.
bool isPlain(const osg::Image& hits, int x, int y, int step)
{
    const osg::Vec4 own = pixel(hits, x, y);
    for (const auto& [dx, dy] : {std::pair(-step, 0), {step, 0}, {0, -step}, {0, step}})
    {
        const osg::Vec4 beside = pixel(hits, x + dx, y + dy);
        if (beside.w() <= 1.0f || beside.z() != own.z()) return false;
        if (own.x() >= 0.0f && std::hypot(beside.x() - own.x(), beside.y() - own.y()) > 4.0 * step)
            return false;
    }
    return own.w() > 1.0f;
}

} // namespace

// Falls where a search by rows is not that by columns: columnsOf takes extent.x for both.
TEST_CASE("the picture rolls with the camera")
{
    const int size = 120;
    OffscreenView view(size, size, OffscreenView::Format::RGBA32F);
    const osg::ref_ptr<WaterSurface> water = createPond(-30, 30);
    const osg::ref_ptr<osg::Group> scene = scenes::together({scenes::createBoxes(), water});
    for (const bool moving : {false, true})
        for (const CaptureKind kind : KINDS)
        {
            set(*water, kind, moving ? TrochoidalWaves::createBreeze(2.0, 0.1) : nullptr);
            view.look(EYE, CENTRE);
            const osg::ref_ptr<osg::Image> upright = copyOf(view.render(scene));
            view.camera().setViewMatrix(
                view.camera().getViewMatrix() *
                osg::Matrixd(0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1));
            const osg::Image& rolled = view.render(scene);
            int different = 0;
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x)
                    different += differs(pixel(*upright, x, y), pixel(rolled, size - 1 - y, x));
            INFO("capture " << static_cast<int>(kind) << ", moving " << moving);
            CHECK(different <= 5);
        }
}

// Falls where TrochoidalTerm takes the time in single precision.
TEST_CASE("waves come back after whole periods")
{
    const double length = 2.0;
    const double gravity = 9.80665;
    const double period = 2.0 * osg::PI / std::sqrt(gravity * 2.0 * osg::PI / length);
    const osg::ref_ptr<TrochoidalWaves> waves = new TrochoidalWaves;
    REQUIRE(waves->setWaves({{0.02, length, 30.0, 0.4}}));
    const osg::ref_ptr<WaterSurface> water = createPond(-30, 30);
    const osg::ref_ptr<osg::Group> scene = scenes::together({scenes::createBoxes(), water});
    set(*water, CaptureKind::VIEW, waves);
    OffscreenView view(160, 120, OffscreenView::Format::RGBA32F);
    view.look(EYE, CENTRE);
    const osg::ref_ptr<osg::Image> first = copyOf(view.render(scene, 0.25));
    CHECK(countDifferent(view.render(scene, 0.25 + 0.5 * period), *first, 0.01) > 1000);
    for (const double periods : {1.0, 1e3, 1e6})
    {
        INFO(periods << " periods");
        CHECK(countDifferent(view.render(scene, 0.25 + periods * period), *first, 0.01) <= 2);
    }
}

// Falls where a sheet's own anchor or bound shows in what it reflects.
TEST_CASE("one water made two along a line shows no seam")
{
    const osg::ref_ptr<WaterSurface> whole = createPond(-30, 30);
    const osg::ref_ptr<WaterSurface> left = createPond(-30, 0.7);
    const osg::ref_ptr<WaterSurface> right = createPond(0.7, 30);
    const osg::ref_ptr<osg::Group> boxes = scenes::createBoxes();
    const osg::ref_ptr<osg::Group> one = scenes::together({boxes, whole});
    const osg::ref_ptr<osg::Group> two = scenes::together({boxes, left, right});
    OffscreenView view(160, 120, OffscreenView::Format::RGBA32F);
    view.look(EYE, CENTRE);
    for (const bool moving : {false, true})
        for (const CaptureKind kind : KINDS)
        {
            const osg::ref_ptr<WaveModel> waves =
                moving ? TrochoidalWaves::createBreeze(2.0, 0.1) : nullptr;
            for (WaterSurface* water : {whole.get(), left.get(), right.get()})
                set(*water, kind, waves);
            const osg::ref_ptr<osg::Image> expected = copyOf(view.render(one, 3.0));
            const int different = countDifferent(view.render(two, 3.0), *expected, 0.01);
            INFO("capture " << static_cast<int>(kind) << ", moving " << moving);
            CHECK(different <= (moving ? 100 : 2)); // meshes differ in moving water
        }
}

// Falls where EDGE_DEPTH, or what a column is, counts in other than pixels.
TEST_CASE("at three times the resolution the same places are reflected, away from edges")
{
    const osg::ref_ptr<WaterSurface> water = createPond(-30, 30);
    const osg::ref_ptr<osg::Group> scene = scenes::together({scenes::createBoxes(), water});
    for (const CaptureKind kind : KINDS)
    {
        set(*water, kind, nullptr);
        ViewSettings settings = water->getViewSettings();
        settings.guardBand = GuardBandKind::NONE;
        REQUIRE(water->setViewSettings(settings));
        water->setDebugView(DebugView::HIT);
        // Every third pixel of the finer picture has its centre where the coarser one has one.
        const int width = 161;
        const int height = 121;
        OffscreenView once(width, height, OffscreenView::Format::RGBA32F);
        OffscreenView thrice(3 * width, 3 * height, OffscreenView::Format::RGBA32F);
        once.look(EYE, CENTRE);
        thrice.look(EYE, CENTRE);
        const osg::Image& coarse = once.render(scene);
        const osg::Image& fine = thrice.render(scene);
        int plain = 0;
        int apart = 0;
        for (int y = 1; y < height - 1; ++y)
            for (int x = 1; x < width - 1; ++x)
            {
                if (!isPlain(coarse, x, y, 1) || !isPlain(fine, 3 * x + 1, 3 * y + 1, 3)) continue;
                const osg::Vec4 a = pixel(coarse, x, y);
                const osg::Vec4 b = pixel(fine, 3 * x + 1, 3 * y + 1);
                ++plain;
                const double off = std::hypot(3.0 * a.x() - b.x(), 3.0 * a.y() - b.y());
                apart += a.z() != b.z() || (a.x() >= 0.0f && b.x() >= 0.0f && off > 1.5);
            }
        INFO("capture " << static_cast<int>(kind));
        CHECK(apart <= 0.001 * plain);
    }
}

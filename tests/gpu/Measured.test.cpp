// What the water puts out for those who measure it.

#include "support/CapturedImages.h"
#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/PositionCodes.h"
#include "support/Scenes.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/shaders/ShaderSource.h>

#include <algorithm>
#include <cmath>

using namespace osgWaterReflect;
using DebugView = WaterSurface::DebugView;

namespace
{

const int WIDTH = 160;
const int HEIGHT = 120;

// A view of the boxes over water, whose colours tell places, and what is put out there.
struct MeasuredView : OffscreenView
{
    MeasuredView() : OffscreenView(WIDTH, HEIGHT, Format::RGBA32F)
    {
        const osg::ref_ptr<osg::Group> boxes = scenes::createBoxes();
        positionCodes::paint(*boxes);
        scene->addChild(boxes);
        scene->addChild(water);
        camera().setClearColor(osg::Vec4(0, 0, 0, 0));
        look(osg::Vec3d(0, -4, 2), osg::Vec3d(0, 20, 0));
    }

    osg::ref_ptr<osg::Image> show(DebugView debugView)
    {
        water->setDebugView(debugView);
        return copyOf(render(scene));
    }

    osg::ref_ptr<WaterSurface> water = scenes::createBoxesWater();
    osg::ref_ptr<osg::Group> scene = new osg::Group;
};

template <class Check>
int forEachWaterPixel(const osg::Image& points, const Check& check)
{
    int count = 0;
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x)
            if (pixel(points, x, y).a() == -1.0f)
            {
                ++count;
                check(x, y);
            }
    return count;
}

osg::Vec3d xyz(const osg::Vec4& v)
{
    return osg::Vec3d(v.x(), v.y(), v.z());
}

// The four pixels of an image about a place between their centres, and their shares there.
struct Corners
{
    Corners(const osg::Image& image, double x, double y)
    {
        const double left = std::floor(x - 0.5);
        const double low = std::floor(y - 0.5);
        for (int i = 0; i < 4; ++i)
        {
            const double column = left + i % 2;
            const double row = low + i / 2;
            colours[i] = xyz(pixel(image, std::clamp<int>(column, 0, WIDTH - 1),
                                   std::clamp<int>(row, 0, HEIGHT - 1)));
            shares[i] = (1.0 - std::abs(x - 0.5 - column)) * (1.0 - std::abs(y - 0.5 - row));
        }
    }

    osg::Vec3d mixed() const
    {
        osg::Vec3d sum;
        for (int i = 0; i < 4; ++i)
            sum += colours[i] * shares[i];
        return sum;
    }

    // Whether no component is beyond those of all four.
    bool span(const osg::Vec3d& colour) const
    {
        for (int c = 0; c < 3; ++c)
        {
            const auto [least, most] =
                std::minmax({colours[0][c], colours[1][c], colours[2][c], colours[3][c]});
            if (colour[c] < least - ROUNDING || colour[c] > most + ROUNDING) return false;
        }
        return true;
    }

    // Of codes in the thousandths of which a pixel is; single precision.
    static constexpr double ROUNDING = 1e-4;

    osg::Vec3d colours[4];
    double shares[4];
};

} // namespace

// Falls when POINT puts out the place in surface space, or NORMAL the one toward the water.
TEST_CASE("points and normals of the water are put out in eye space")
{
    MeasuredView view;
    osg::ref_ptr<TrochoidalWaves> waves = TrochoidalWaves::createBreeze(2.0, 0.2);
    SurfaceDetail detail;
    detail.maxErrorPixels = 0.05; // so that the mesh is close to the waves, near by
    REQUIRE(view.water->setDetail(detail));
    for (const bool moving : {false, true})
    {
        view.water->setWaves(moving ? waves.get() : nullptr);
        const osg::ref_ptr<osg::Image> points = view.show(DebugView::POINT);
        const osg::ref_ptr<osg::Image> normals = view.show(DebugView::NORMAL);
        const osg::Matrixd worldFromEye = osg::Matrixd::inverse(view.camera().getViewMatrix());
        const osg::Matrixd eyeFromClip = osg::Matrixd::inverse(view.camera().getProjectionMatrix());
        double worstHeight = 0.0;
        double worstSight = 0.0;
        double leastUp = 1.0;
        const int count = forEachWaterPixel(
            *points,
            [&](int x, int y)
            {
                const osg::Vec3d pointEye = xyz(pixel(*points, x, y));
                const osg::Vec3d point = pointEye * worldFromEye;
                const double height =
                    moving ? waves->getHeight(osg::Vec2d(point.x(), point.y()), 0.0) : 0.0;
                // Farther away a pixel spans whole waves, and so do the mesh's triangles.
                if (!moving || pointEye.length() < 4.5)
                    worstHeight = std::max(worstHeight, std::abs(point.z() - height));
                osg::Vec3d sight =
                    osg::Vec3d((x + 0.5) / WIDTH * 2 - 1, (y + 0.5) / HEIGHT * 2 - 1, 0.5) *
                    eyeFromClip;
                sight.normalize();
                worstSight = std::max(worstSight, (sight ^ pointEye).length() / pointEye.length());
                const osg::Vec3d normal = xyz(pixel(*normals, x, y));
                CHECK(std::abs(normal.length() - 1.0) < 1e-6);
                leastUp = std::min(leastUp, osg::Matrixd::transform3x3(normal, worldFromEye).z());
            });
        INFO("moving " << moving);
        CHECK(count > 5000);
        // A hundredth of a pixel off the sight line; the mesh misses near crests (29 mm) by
        // millimetres.
        CHECK(worstSight < 1e-4);
        CHECK(worstHeight < (moving ? 0.008 : 1e-4));
        CHECK(leastUp > (moving ? 0.95 : 1.0 - 1e-6));
    }
}

// Falls when the colour is that of the nearest pixel alone, the place is the pixel's own or the sky
// has none, when fetches are counted twice, or when the reason is not the debug view's.
TEST_CASE("the place that a water pixel shows is put out, and what it cost")
{
    MeasuredView view;
    ReflectionSettings settings;
    settings.capture = osgWaterReflect::CaptureKind::VIEW;
    settings.search = Search::SEQUENTIAL;
    REQUIRE(view.water->setReflection(settings));
    const osg::ref_ptr<CapturedImages> captured = CapturedImages::of(view.camera());
    const osg::ref_ptr<osg::Image> points = view.show(DebugView::POINT);
    const osg::ref_ptr<osg::Image> hits = view.show(DebugView::HIT);
    const osg::ref_ptr<osg::Image> reflections = view.show(DebugView::REFLECTION);
    int shown = 0;
    int mixed = 0;
    int sky = 0;
    double mostFetches = 0.0;
    const int count =
        forEachWaterPixel(*points,
                          [&](int x, int y)
                          {
                              const osg::Vec4 hit = pixel(*hits, x, y);
                              const osg::Vec4 colour = pixel(*reflections, x, y);
                              mostFetches = std::max<double>(mostFetches, hit.a());
                              if (hit.x() < 0.0f)
                              {
                                  ++sky;
                                  CHECK(hit.y() == -1.0f);
                                  CHECK(hit.z() != 0.0f);
                                  CHECK(!positionCodes::isPlace(colour));
                                  return;
                              }
                              ++shown;
                              const Corners corners(*captured->one().colour, hit.x(), hit.y());
                              CHECK(corners.span(xyz(colour)));
                              mixed += (corners.mixed() - xyz(colour)).length() < Corners::ROUNDING;
                          });
    CHECK(shown > 500);
    // The rest, an eighth in a picture this small, lie at edges: not all four pixels show the same.
    CHECK(mixed > 0.8 * shown);
    CHECK(sky > 500);
    CHECK(shown + sky == count);
    // One a column, two ends, three at the hit and four about its place.
    CHECK(mostFetches > 0.4 * HEIGHT); // the rows that the longest ray passes
    CHECK(mostFetches <= WIDTH + 9);
}

// Falls when KeptProgram does not ask for replacements, or keeps the replaced program.
TEST_CASE("water takes up a replaced shader piece, and gives it up")
{
    MeasuredView view;
    const osg::ref_ptr<osg::Image> own = view.show(DebugView::NONE);
    {
        const ShaderReplacement replacement(
            "fresnel.glsl", "float fresnelReflectance(float c, float eta) { return 0.0; }\n");
        CHECK(countDifferent(*own, *view.show(DebugView::NONE)) > 5000);
    }
    CHECK(countDifferent(*own, *view.show(DebugView::NONE)) == 0);
}

// Water traced at a fraction of the view's resolution. The whole trace is what it is held against,
// where it is not the mirrored eye.

#include "support/CapturedImages.h"
#include "support/Catch.h"
#include "support/MirrorTruth.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/water/LowResTrace.h>

#include <osgUtil/RenderStage>
#include <osgViewer/Renderer>

#include <cmath>

using osgWaterReflect::CaptureKind;
using osgWaterReflect::LowResTrace;
using osgWaterReflect::ReflectionSettings;
using osgWaterReflect::TrochoidalWaves;
using osgWaterReflect::ViewSettings;
using osgWaterReflect::WaterSurface;

namespace
{

const osg::Vec4 SKY(0.1, 0.9, 0.3, 1);

void setScale(WaterSurface& water, double traceScale)
{
    ViewSettings settings = water.getViewSettings();
    settings.traceScale = traceScale;
    REQUIRE(water.setViewSettings(settings));
}

void setCapture(WaterSurface& water, CaptureKind capture)
{
    ReflectionSettings settings = water.getReflection();
    settings.capture = capture;
    REQUIRE(water.setReflection(settings));
}

// The harbour and its lake, of which only the reflections are shown.
struct HarbourView : OffscreenView
{
    HarbourView(int width = 320, int height = 240) : OffscreenView(width, height)
    {
        camera().setClearColor(SKY);
        look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
        lake->setDebugView(WaterSurface::DebugView::REFLECTION);
    }

    osg::ref_ptr<osg::Image> show(double traceScale)
    {
        setScale(*lake, traceScale);
        return copyOf(render(root));
    }

    // The image of the traces; null where there is none.
    osg::Texture2D* found()
    {
        auto* renderer = dynamic_cast<osgViewer::Renderer*>(camera().getRenderer());
        REQUIRE(renderer);
        osg::Texture2D* texture = nullptr;
        for (const auto& before : renderer->getSceneView(0)->getRenderStage()->getPreRenderList())
        {
            osg::Camera& of = *before.second->getCamera();
            if (of.getName() != LowResTrace::CAMERA_NAME) continue;
            CHECK(texture == nullptr);
            auto& attached = of.getBufferAttachmentMap()[osg::Camera::COLOR_BUFFER0];
            texture = dynamic_cast<osg::Texture2D*>(attached._texture.get());
        }
        return texture;
    }

    osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    osg::ref_ptr<osg::Group> root = scenes::together({scenes::createHarbour(), lake});
};

double distance(const osg::Vec4& a, const osg::Vec4& b)
{
    return (a - b).length();
}

// Sum of the differences of two pictures, by pixel.
double difference(const osg::Image& a, const osg::Image& b)
{
    double sum = 0.0;
    for (int y = 0; y < a.t(); ++y)
        for (int x = 0; x < a.s(); ++x)
            sum += distance(pixel(a, x, y), pixel(b, x, y));
    return sum;
}

} // namespace

// Half the side has 99.8 % and 0.30 %, a quarter 99.7 % and 0.44 %.
// What is lost lies at silhouettes: beside one, a ray that passes is met where a neighbour was.
// Breaks with: tracedFromWindow's half texel left out, or a hit taken wherever a small pixel has
// one, unchecked (trace_upsample.glsl).
TEST_CASE("calm water traced at a fraction shows most of what the mirrored eye sees")
{
    const double pitch = osg::DegreesToRadians(8.6);
    const osg::Vec3d eye(0, -2, 2);
    const MirrorView view = {eye, eye + osg::Vec3d(0, std::cos(pitch), -std::sin(pitch))};
    const struct
    {
        double scale;
        double right;
        double falseHits;
    } expectations[] = {{0.5, 0.995, 0.004}, {0.25, 0.99, 0.006}};
    for (const auto& expected : expectations)
        DYNAMIC_SECTION("scale " << expected.scale)
        {
            const osg::ref_ptr<WaterSurface> water = scenes::createBoxesWater();
            setScale(*water, expected.scale);
            const MirrorComparison result =
                compareWithMirror(*scenes::createBoxes(), *water, osg::Plane(0, 0, 1, 0), view,
                                  "trace scale " + std::to_string(expected.scale));
            WARN(result.visibleRight << " of " << result.visible << " right, " << result.skyHit
                                     << " of " << result.sky << " falsely hit, median error "
                                     << result.medianError << " px");
            CHECK(result.visibleRight >= expected.right * result.visible);
            CHECK(result.skyHit <= expected.falseHits * result.sky);
            CHECK(result.medianError < 0.5); // as the full trace: of the nearest captured pixel
        }
}

// Breaks with: tracedFromWindow's half texel left out (trace_upsample.glsl).
TEST_CASE("away from edges the picture of a fraction is that of the full trace")
{
    HarbourView view;
    const osg::ref_ptr<osg::Image> full = view.show(1.0);
    view.lake->setDebugView(WaterSurface::DebugView::REASON);
    const osg::ref_ptr<osg::Image> reasons = view.show(1.0);
    view.lake->setDebugView(WaterSurface::DebugView::REFLECTION);
    const osg::ref_ptr<osg::Image> half = view.show(0.5);
    keep(*full, "trace scale full");
    keep(*half, "trace scale half");
    int inside = 0;
    int different = 0;
    for (int y = 3; y < view.height() - 3; ++y)
        for (int x = 3; x < view.width() - 3; ++x)
        {
            bool edge = false;
            for (int i = 0; i < 49; ++i)
                edge = edge || distance(pixel(*reasons, x, y),
                                        pixel(*reasons, x + i % 7 - 3, y + i / 7 - 3)) > 0.01;
            if (edge) continue;
            ++inside;
            different += distance(pixel(*full, x, y), pixel(*half, x, y)) > 0.1;
        }
    WARN(different << " of " << inside << " pixels");
    CHECK(inside > 30000);
    CHECK(different < 0.01 * inside); // where one thing ends before another
}

// Nothing breaks it yet that has been tried: colours are read where the pixel's own ray is seen.
TEST_CASE("an upright edge is as sharp as in the full trace, and where it is")
{
    OffscreenView view(320, 240);
    view.camera().setClearColor(osg::Vec4(0, 0, 1, 1));
    view.look(osg::Vec3d(0.13, -10, 2), osg::Vec3d(0, 0, 1));
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    lake->setDebugView(WaterSurface::DebugView::REFLECTION);
    const osg::ref_ptr<osg::Group> root = scenes::together(
        {scenes::createBox(osg::Vec3(-1, 4, 2), osg::Vec3(2, 1, 5), osg::Vec4(1, 0, 0, 1)), lake});
    int redOfFull = 0;
    for (double scale : {1.0, 0.5, 0.25})
    {
        setScale(*lake, scale);
        const osg::Image& picture = view.render(root);
        int rows = 0;
        int between = 0; // pixels neither of the box nor of the sky
        int changes = 0;
        int reds = 0;
        for (int y = 70; y < 100; ++y, ++rows)
            for (int x = 100; x < 220; ++x)
            {
                const double red = pixel(picture, x, y).r();
                reds += red > 0.5;
                between += red > 0.1 && red < 0.9;
                changes += (red > 0.5) != (pixel(picture, x + 1, y).r() > 0.5);
            }
        INFO("scale " << scale);
        CHECK(between <= 2 * rows); // of two edges, each mixed of two captured pixels
        CHECK(changes == 2 * rows);
        if (scale == 1.0) redOfFull = reds;
        CHECK(std::abs(reds - redOfFull) <= rows); // half a pixel at each edge
    }
}

// Everything is red but the sky, which is green: black, or the water's blue, would be a hole.
// Nothing breaks it yet that has been tried: whatever is taken, it is read from the capture.
TEST_CASE("slivers of water and water behind things have no holes")
{
    OffscreenView view(321, 239);
    view.camera().setClearColor(osg::Vec4(0, 1, 0, 1));
    view.look(osg::Vec3d(0, -10, 2), osg::Vec3d(0, 0, 0.5));
    const osg::Vec4 red(1, 0, 0, 1);
    const osg::ref_ptr<osg::Group> root = scenes::together(
        {scenes::createBox(osg::Vec3(0, 6, 2), osg::Vec3(8, 1, 5), red),
         scenes::createBox(osg::Vec3(-1, -4, 1), osg::Vec3(0.02, 0.02, 3), red),
         scenes::createBox(osg::Vec3(1, -4, 1.0), osg::Vec3(0.7, 0.02, 0.3), red)});
    std::vector<osg::ref_ptr<WaterSurface>> waters;
    for (double thin : {4.0, 0.3, 0.1, 0.03, 0.01})
        for (bool along : {false, true})
        {
            const double at = 0.8 * waters.size();
            waters.push_back(WaterSurface::createRectangle(
                along ? osg::Vec3(at - 3, -2, 0) : osg::Vec3(0, at - 6, -0.1),
                along ? osg::Vec3(thin, 0, 0) : osg::Vec3(20, 0, 0),
                along ? osg::Vec3(0, 6, 0) : osg::Vec3(0, thin, 0)));
            waters.back()->setDebugView(WaterSurface::DebugView::REFLECTION);
            root->addChild(waters.back());
        }
    for (double scale : {0.5, 0.25, 0.01})
    {
        for (const osg::ref_ptr<WaterSurface>& water : waters)
            setScale(*water, scale);
        const osg::Image& picture = view.render(root);
        int holes = 0;
        for (int y = 0; y < view.height(); ++y)
            for (int x = 0; x < view.width(); ++x)
            {
                const osg::Vec4 colour = pixel(picture, x, y);
                holes += std::abs(colour.r() + colour.g() - 1.0) > 0.02 || colour.b() > 0.01;
            }
        INFO("scale " << scale);
        CHECK(holes == 0);
    }
}

// Breaks with: the viewport's offset left out of foundFromWindow, or the size not followed
// (LowResTrace::resize).
TEST_CASE("views of any size, and moved in the window, show nearly what the full trace shows")
{
    HarbourView view(321, 239);
    const struct
    {
        int x, y, width, height;
    } viewports[] = {
        {0, 0, 321, 239}, {37, 51, 200, 151}, {0, 0, 1, 1}, {300, 200, 3, 2}, {0, 0, 321, 239}};
    for (const auto& v : viewports)
    {
        view.camera().setViewport(v.x, v.y, v.width, v.height);
        view.camera().setProjectionMatrixAsPerspective(46.0, double(v.width) / v.height, 0.1, 1e3);
        const osg::ref_ptr<osg::Image> full = view.show(1.0);
        const osg::ref_ptr<osg::Image> half = view.show(0.5);
        REQUIRE(view.found());
        CHECK(view.found()->getTextureWidth() == std::max(1, (v.width + 1) / 2));
        CHECK(view.found()->getTextureHeight() == std::max(1, (v.height + 1) / 2));
        INFO(v.width << "x" << v.height);
        CHECK(countDifferent(*full, *half, 0.1) <= 0.03 * v.width * v.height + 1);
    }
}

// Breaks where one WaterView serves for all cameras.
TEST_CASE("a second, smaller view takes nothing from the first")
{
    HarbourView first;
    const osg::ref_ptr<osg::Image> alone = first.show(0.5);
    HarbourView second(90, 60);
    second.root = first.root;
    second.lake = first.lake;
    const osg::ref_ptr<osg::Image> small = second.show(0.5);
    CHECK(countDifferent(*first.show(0.5), *alone) == 0);
    CHECK(countDifferent(*second.show(0.5), *small) == 0);
    REQUIRE(first.found());
    REQUIRE(second.found());
    CHECK(second.found() != first.found());
}

// Breaks where the pass does not begin anew in each frame (LowResTrace).
TEST_CASE("a scale of 1 has no image of its own, before and after another scale")
{
    HarbourView view;
    const osg::ref_ptr<CapturedImages> captured = CapturedImages::of(view.camera());
    const osg::ref_ptr<osg::Image> full = view.show(1.0);
    CHECK(view.found() == nullptr);
    const unsigned int stages = captured->stages;
    view.show(0.5);
    CHECK(view.found() != nullptr);
    CHECK(captured->stages == stages + 1);
    CHECK(countDifferent(*view.show(1.0), *full) == 0);
    CHECK(view.found() == nullptr);
    CHECK(captured->stages == stages);
}

// Breaks with: the pass left out of WaterView::forEachGLObjects.
TEST_CASE("released water keeps no image of traces, and draws the same again")
{
    HarbourView view;
    const osg::ref_ptr<osg::Image> before = view.show(0.5);
    const osg::ref_ptr<osg::Texture2D> found = view.found();
    osg::State& state = *view.camera().getGraphicsContext()->getState();
    REQUIRE(found);
    CHECK(found->getTextureObject(state.getContextID()));
    view.root->releaseGLObjects(nullptr);
    CHECK_FALSE(found->getTextureObject(state.getContextID()));
    CHECK(countDifferent(*view.show(0.5), *before) == 0);
}

// Breaks with: the image sized by the last water (LowResTrace).
TEST_CASE("several waters share the image, and the largest scale below 1 sizes it")
{
    HarbourView view;
    const osg::ref_ptr<WaterSurface> upper = scenes::createLake(0.8, 6.0);
    upper->setDebugView(WaterSurface::DebugView::REFLECTION);
    view.root->addChild(upper);
    const osg::ref_ptr<osg::Image> full = view.show(1.0);
    CHECK(view.found() == nullptr);
    for (double scale : {0.25, 0.5, 1.0})
    {
        setScale(*upper, scale);
        const osg::ref_ptr<osg::Image> half = view.show(0.5);
        CHECK(view.found()->getTextureWidth() == 160);
        CHECK(countDifferent(*full, *half, 0.1) < 0.03 * 320 * 240);
        const osg::ref_ptr<osg::Image> quarter = view.show(0.25);
        CHECK(view.found()->getTextureWidth() == (scale == 0.5 ? 160 : 80));
        CHECK(countDifferent(*full, *quarter, 0.1) < 0.05 * 320 * 240);
    }
}

// Lakes at two levels have a mirrored eye each. The upper is met last, and what it captures is not
// there yet where the lower has begun the image of the traces.
// Breaks with: the pass left where its first sheet has put it (LowResTrace::draw).
TEST_CASE("several mirrored eyes are all captured before a fraction is traced")
{
    HarbourView view;
    const osg::ref_ptr<WaterSurface> upper = scenes::createLake(0.8, 6.0);
    upper->setDebugView(WaterSurface::DebugView::REFLECTION);
    view.root->addChild(upper);
    for (const osg::ref_ptr<WaterSurface>& water : {view.lake, upper})
        setCapture(*water, CaptureKind::MIRROR);
    setScale(*upper, 0.5);
    view.show(0.5);
    view.look(scenes::HARBOUR_EYE + osg::Vec3d(6, 3, 1), scenes::HARBOUR_CENTRE);
    const osg::ref_ptr<osg::Image> half = view.show(0.5);
    CHECK(countDifferent(*half, *view.show(0.5)) == 0); // nothing is of the frame before
    setScale(*upper, 1.0);
    const osg::ref_ptr<osg::Image> full = view.show(1.0);
    keep(*full, "trace scale mirrored full");
    keep(*half, "trace scale mirrored half");
    CHECK(countDifferent(*full, *half, 0.1) < 0.03 * 320 * 240);
}

// The eye sees a red roof, and in the water its green underside, which only the mirrored eye shows.
// Breaks with: MIRRORED left out of texelOf, or not told apart in raysAbout (trace_upsample.glsl).
TEST_CASE("a fraction says which of two captures shows a hit")
{
    OffscreenView view(320, 240);
    view.camera().setClearColor(osg::Vec4(0, 0, 1, 1));
    view.look(osg::Vec3d(0.13, -10, 5), osg::Vec3d(0, 0, 1));
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    lake->setDebugView(WaterSurface::DebugView::REFLECTION);
    setCapture(*lake, CaptureKind::VIEW_AND_MIRROR);
    const osg::Vec3 along(4, 0, 0);
    const osg::Vec3 across(0, 3, 0);
    const osg::ref_ptr<osg::Group> root = scenes::together(
        {scenes::createQuad(osg::Vec3(-2, 1, 2.1), along, across, osg::Vec4(1, 0, 0, 1)),
         scenes::createQuad(osg::Vec3(-2, 1, 2.0), along, across, osg::Vec4(0, 1, 0, 1)), lake});
    int greenOfFull = 0;
    for (double scale : {1.0, 0.5, 0.25})
    {
        setScale(*lake, scale);
        const osg::Image& picture = view.render(root);
        keep(picture, "trace scale both " + std::to_string(scale));
        int green = 0;
        for (int y = 0; y < view.height(); ++y)
            for (int x = 0; x < view.width(); ++x)
                green += pixel(picture, x, y).g() > 0.9;
        INFO("scale " << scale);
        if (scale == 1.0) greenOfFull = green;
        CHECK(green > 500);
        CHECK(std::abs(green - greenOfFull) < 0.1 * greenOfFull);
    }
}

// Over a lake lies a higher pond, split by gaps a pixel wide. The pond's rays meet a board in the
// air; those of the lake, 3 m lower, pass under it to the sky.
// Breaks where all sheets have the same number (LowResTrace).
TEST_CASE("water seen through gaps of other water meets nothing that only that other meets")
{
    OffscreenView view(320, 240, OffscreenView::Format::RGBA32F);
    view.look(osg::Vec3d(0.13, -10, 4), osg::Vec3d(0, 0, 2));
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    lake->setDebugView(WaterSurface::DebugView::HIT);
    const osg::ref_ptr<osg::Group> root =
        scenes::together({scenes::createQuad(osg::Vec3(-8, 6, 4), osg::Vec3(16, 0, 0),
                                             osg::Vec3(0, 0, 2.5), osg::Vec4(1, 0, 0, 1)),
                          lake});
    std::vector<osg::ref_ptr<WaterSurface>> strips;
    for (int i = -4; i < 4; ++i)
    {
        strips.push_back(WaterSurface::createRectangle(osg::Vec3(i + 0.5, -1, 1.5),
                                                       osg::Vec3(0.97, 0, 0), osg::Vec3(0, 10, 0)));
        strips.back()->setDebugView(WaterSurface::DebugView::REFLECTION);
        root->addChild(strips.back());
    }
    const auto show = [&](double scale)
    {
        setScale(*lake, scale);
        for (const osg::ref_ptr<WaterSurface>& strip : strips)
            setScale(*strip, scale);
        return copyOf(view.render(root));
    };
    const osg::ref_ptr<osg::Image> full = show(1.0);
    const osg::ref_ptr<osg::Image> half = show(0.5);
    keep(*full, "trace scale gaps full");
    keep(*half, "trace scale gaps half");
    int besideBoard = 0; // pixels of the lake that see the sky beside the pond's that do not
    int falseHits = 0;
    for (int y = 0; y < view.height(); ++y)
        for (int x = 3; x < view.width() - 3; ++x)
        {
            const bool sky = pixel(*full, x, y).r() == -1.0f;
            const osg::Vec4 left = pixel(*full, x - 3, y);
            const osg::Vec4 right = pixel(*full, x + 3, y);
            const osg::Vec4 red(1, 0, 0, 1);
            if (!sky || distance(left, red) > 0.01 || distance(right, red) > 0.01) continue;
            ++besideBoard;
            falseHits += pixel(*half, x, y).r() != -1.0f;
        }
    CHECK(besideBoard > 100);
    CHECK(falseHits == 0);
}

// Within a tenth; 2 % and 1 % when it was written.
TEST_CASE("under a moving eye a fraction flickers little more than the full trace")
{
    for (bool moving : {false, true})
    {
        HarbourView view;
        if (moving) view.lake->setWaves(TrochoidalWaves::createBreeze(1.0, 0.05));
        double changes[2] = {0.0, 0.0};
        osg::ref_ptr<osg::Image> last[2];
        for (int frame = 0; frame < 6; ++frame)
        {
            const osg::Vec3d step(0.02 * frame, 0.01 * frame, 0.0);
            view.look(scenes::HARBOUR_EYE + step, scenes::HARBOUR_CENTRE + step);
            for (int i : {0, 1})
            {
                const osg::ref_ptr<osg::Image> picture = view.show(i ? 0.5 : 1.0);
                if (last[i]) changes[i] += difference(*picture, *last[i]);
                last[i] = picture;
            }
        }
        WARN("change " << changes[1] << ", of the full trace " << changes[0]);
        CHECK(changes[1] < 1.1 * changes[0]);
    }
}

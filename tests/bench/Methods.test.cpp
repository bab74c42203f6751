// The methods that the bench compares with the library's own, each where the truth is known.

#include "support/CapturedImages.h"
#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/PositionCodes.h"
#include "support/Scenes.h"

#include <osgwaterbench/methods/MethodScope.h>

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/reference/SceneTracer.h>
#include <osgWaterReflect/water/WaterProgram.h>

#include <osg/ShapeDrawable>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

using namespace osgWaterReflect;
using namespace osgwaterbench;
using osgWaterReflect::reference::SceneTracer;
using DebugView = WaterSurface::DebugView;

namespace
{

const int WIDTH = 320;
const int HEIGHT = 240;
const osg::Vec4 SKY_COLOUR(0.2f, 0.4f, 0.6f, 1.0f);

osg::Vec3d xyz(const osg::Vec4& v)
{
    return osg::Vec3d(v.x(), v.y(), v.z());
}

osg::ref_ptr<osg::TextureCubeMap> createSky()
{
    osg::ref_ptr<osg::TextureCubeMap> sky = new osg::TextureCubeMap;
    for (unsigned int face = 0; face < 6; ++face)
    {
        osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(1, 1, 1, GL_RGBA, GL_FLOAT);
        image->setInternalTextureFormat(GL_RGBA32F_ARB);
        image->setColor(SKY_COLOUR, 0, 0);
        sky->setImage(face, image);
    }
    return sky;
}

osg::ref_ptr<osg::Group> createBranchedBoxes()
{
    osg::ref_ptr<osg::Group> boxes = scenes::createBoxes();
    boxes->addChild(
        new osg::ShapeDrawable(new osg::Box(osg::Vec3(0, 1.5, 2.85), 4.0f, 1.0f, 0.3f)));
    return boxes;
}

// Reads the mirrored camera's windowZ back after each frame.
class ReadMirror : public osg::Camera::DrawCallback
{
public:
    explicit ReadMirror(MirrorCamera& mirror) : _mirror(&mirror) {}

    void operator()(osg::RenderInfo& renderInfo) const override
    {
        if (_mirror->getNodeMask() == 0u) return;
        windowZ = new osg::Image;
        windowZ->allocateImage(WIDTH, HEIGHT, 1, GL_LUMINANCE, GL_FLOAT);
        renderInfo.getState()->applyTextureAttribute(0, _mirror->windowZ());
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, windowZ->data());
    }

    mutable osg::ref_ptr<osg::Image> windowZ;

private:
    osg::ref_ptr<MirrorCamera> _mirror;
};

// How what a method shows compares with the exact rays.
struct Tally
{
    int visible = 0;      // pixels whose true reflection the eye sees, inside the image
    int visibleRight = 0; // of these, shown from within 1.5 px of the true place
    int hits = 0;         // pixels whose ray meets something, seen by the eye or not
    int hitsRight = 0;    // of these, shown from within 1.5 px
    int sky = 0;
    int skyFalse = 0;     // of these, shown anything
    double fetches = 0.0; // a pixel, on average
    double median = 0.0;  // [pixels] from the true place, of the visible that are shown anything
    double medianX = 0.0; // the same, of |x| ...
    double medianY = 0.0; // ... and of |y|
};

double medianOf(std::vector<double> values)
{
    if (values.empty()) return 0.0;
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
}

// A view of things that stand in water, whose colours tell places, from 2 m above it.
struct BenchView : OffscreenView
{
    explicit BenchView(osg::ref_ptr<osg::Group> scene) :
        OffscreenView(WIDTH, HEIGHT, Format::RGBA32F)
    {
        positionCodes::paint(*scene);
        scene->getOrCreateStateSet()->setMode(GL_CULL_FACE, osg::StateAttribute::ON);
        bed.scene = scene;
        bed.water = scenes::createBoxesWater();
        bed.water->setSky(createSky());
        bed.mirror = new MirrorCamera(WIDTH, HEIGHT, GL_RGBA32F_ARB);
        bed.mirror->addChild(scene);
        root->addChild(bed.mirror);
        root->addChild(scene);
        root->addChild(bed.water);
        camera().setClearColor(osg::Vec4(0, 0, 0, 0));
        captured = CapturedImages::of(camera());
        readMirror = new ReadMirror(*bed.mirror);
        camera().addPostDrawCallback(readMirror);
        look(osg::Vec3d(0, -4, 2), osg::Vec3d(0, 9.25, 0)); // 8.6 degrees down
    }

    osg::ref_ptr<osg::Image> show(const Method& method, DebugView debugView)
    {
        bed.mirror->follow(camera(), osg::Plane(0, 0, 1, 0), 200.0);
        const MethodScope scope(method, bed);
        bed.water->setDebugView(debugView);
        return copyOf(render(root));
    }

    osg::Vec2d windowOf(const osg::Vec3d& place)
    {
        const osg::Vec3d ndc = place * camera().getViewMatrix() * camera().getProjectionMatrix();
        return osg::Vec2d((0.5 * ndc.x() + 0.5) * WIDTH, (0.5 * ndc.y() + 0.5) * HEIGHT);
    }

    // Calls check(x, y, point, direction) for each pixel of water, of the reflected ray in the
    // world.
    template <class Check>
    int forEachRay(const Check& check)
    {
        const Method library = libraryMethod("sequential", searchOfView());
        const osg::ref_ptr<osg::Image> points = show(library, DebugView::POINT);
        const osg::ref_ptr<osg::Image> normals = show(library, DebugView::NORMAL);
        const osg::Matrixd worldFromEye = osg::Matrixd::inverse(camera().getViewMatrix());
        int count = 0;
        for (int y = 0; y < HEIGHT; ++y)
            for (int x = 0; x < WIDTH; ++x)
            {
                if (pixel(*points, x, y).a() != -1.0f) continue;
                ++count;
                osg::Vec3d sight = xyz(pixel(*points, x, y));
                const osg::Vec3d point = sight * worldFromEye;
                sight.normalize();
                const osg::Vec3d normal = xyz(pixel(*normals, x, y));
                osg::Vec3d dir = osg::Matrixd::transform3x3(
                    sight - normal * (2.0 * (sight * normal)), worldFromEye);
                dir.z() = std::abs(dir.z()); // what goes down meets still water
                check(x, y, point, dir);
            }
        return count;
    }

    // Where what a pixel shows is seen by the eye [pixels]; none for the sky.
    std::optional<osg::Vec2d> shownWindow(const Method& method, const osg::Vec4& hit)
    {
        if (hit.x() < 0.0f) return std::nullopt;
        const osg::Vec2d window(hit.x(), hit.y());
        if (!method.mirror) return window;
        const std::optional<osg::Vec3d> place = bed.mirror->placeAt(window, *readMirror->windowZ);
        REQUIRE(place);
        return windowOf(*place);
    }

    Tally compare(const Method& method)
    {
        const SceneTracer truth(*bed.scene);
        const osg::Vec3d eye = osg::Vec3d() * osg::Matrixd::inverse(camera().getViewMatrix());
        const osg::ref_ptr<osg::Image> hits = show(method, DebugView::HIT);
        Tally tally;
        std::vector<double> errors, errorsX, errorsY;
        const int count = forEachRay(
            [&](int x, int y, const osg::Vec3d& point, const osg::Vec3d& dir)
            {
                const osg::Vec4 hit = pixel(*hits, x, y);
                tally.fetches += hit.a();
                const std::optional<osg::Vec2d> shown = shownWindow(method, hit);
                const auto met = truth.trace(point, dir);
                if (!met)
                {
                    ++tally.sky;
                    tally.skyFalse += shown.has_value();
                    return;
                }
                const osg::Vec2d trueWindow = windowOf(met->point);
                const double error = shown ? (*shown - trueWindow).length() : 1e9;
                ++tally.hits;
                tally.hitsRight += error <= 1.5;
                const bool inside = trueWindow.x() >= 0.5 && trueWindow.x() <= WIDTH - 0.5 &&
                                    trueWindow.y() >= 0.5 && trueWindow.y() <= HEIGHT - 0.5;
                if (!inside || truth.occluded(eye, met->point, 0.01)) return;
                ++tally.visible;
                tally.visibleRight += error <= 1.5;
                if (!shown) return;
                errors.push_back(error);
                errorsX.push_back(std::abs(shown->x() - trueWindow.x()));
                errorsY.push_back(std::abs(shown->y() - trueWindow.y()));
            });
        tally.fetches /= count;
        tally.median = medianOf(errors);
        tally.medianX = medianOf(errorsX);
        tally.medianY = medianOf(errorsY);
        const auto percent = [](int part, int whole) { return 100.0 * part / std::max(whole, 1); };
        WARN(method.name << ": visible right " << percent(tally.visibleRight, tally.visible)
                         << " % of " << tally.visible << ", all hits right "
                         << percent(tally.hitsRight, tally.hits) << " %, sky false "
                         << percent(tally.skyFalse, tally.sky) << " % of " << tally.sky
                         << ", median " << tally.median << " px (x " << tally.medianX << ", y "
                         << tally.medianY << "), fetches " << tally.fetches);
        return tally;
    }

    TestBed bed;
    osg::ref_ptr<osg::Group> root = new osg::Group;
    osg::ref_ptr<CapturedImages> captured;
    osg::ref_ptr<ReadMirror> readMirror;
};

} // namespace

// A wall behind still water, in a view off axis: what is met stands in closed form. Falls when a
// pixel is thrown back without the projection's skew, when Q is laid through other pixels, when
// fetches are not counted one by one, or when the halving passes the first column.
TEST_CASE("the searches of the paper and the baseline meet a wall where it is")
{
    const double wallY = 16.0;
    osg::ref_ptr<osg::Group> wall = new osg::Group;
    wall->addChild(
        new osg::ShapeDrawable(new osg::Box(osg::Vec3(0, wallY + 1, 4.5), 60.0f, 2.0f, 10.0f)));
    BenchView view(wall);
    view.camera().setProjectionMatrixAsFrustum(-0.05, 0.07, -0.05, 0.04, 0.1, 1000.0);
    for (const Method& method : {paperMethod(), paperBinaryMethod(), baselineMethod()})
    {
        const osg::ref_ptr<osg::Image> hits = view.show(method, DebugView::HIT);
        const osg::ref_ptr<osg::Image> colours = view.show(method, DebugView::REFLECTION);
        int visible = 0;
        int right = 0;
        int countedRight = 0;
        double worstColour = 0.0;
        view.forEachRay(
            [&](int x, int y, const osg::Vec3d& point, const osg::Vec3d& dir)
            {
                const osg::Vec3d met = point + dir * ((wallY - point.y()) / dir.y());
                const osg::Vec2d window = view.windowOf(met);
                // The ray's image has to have a length, and an end inside the image.
                if (!(window.x() > 1 && window.x() < WIDTH - 1 && window.y() > y + 3 &&
                      window.y() < HEIGHT - 2))
                    return;
                ++visible;
                const osg::Vec4 hit = pixel(*hits, x, y);
                const osg::Vec2d shown(hit.x(), hit.y());
                // At the first row's centre behind the wall. (Q is that of single precision: two
                // pixels that span a four-hundredth of a radian make it uncertain by some
                // hundredths of a pixel.) A row leads the ray aside by some of this.
                if (!(std::abs(shown.y() - window.y()) <= 1.05 &&
                      std::abs(shown.x() - window.x()) <= 0.2))
                    return;
                ++right;
                worstColour = std::max(
                    worstColour,
                    (view.windowOf(positionCodes::place(pixel(*colours, x, y))) - shown).length());
                // The steps from the pixel's own centre, along the longer side of the image.
                const double steps =
                    std::max(std::abs(shown.x() - x - 0.5), std::abs(shown.y() - y - 0.5));
                const double fetches = hit.a();
                if (method.name == "paper")
                    countedRight += std::abs(fetches - 2.0 * steps) <= 2.5;
                else if (method.name == "baseline")
                    countedRight += std::abs(fetches - steps) <= 1.5;
                else
                    countedRight += fetches >= 2.0 * std::floor(std::log2(steps)) &&
                                    fetches <= 2.0 * std::ceil(std::log2(WIDTH + 1));
            });
        INFO(method.name << ": " << right << " of " << visible);
        CHECK(visible > 20000);
        CHECK(right == visible);
        CHECK(countedRight == visible);
        CHECK(worstColour <= 0.75); // half a pixel's diagonal
    }
}

// The paper's test has no thickness: whatever hangs ahead of the eye, above its level, is met by
// all rays that pass behind it. Falls when a thickness is slipped into the paper's search.
TEST_CASE("what hangs ahead of the eye fills the paper's sky, and not the library's")
{
    for (const bool branch : {false, true})
    {
        BenchView view(branch ? createBranchedBoxes() : scenes::createBoxes());
        WARN((branch ? "with a branch" : "without a branch"));
        const Tally paper = view.compare(paperMethod());
        const Tally binary = view.compare(paperBinaryMethod());
        const Tally baseline = view.compare(baselineMethod());
        const Tally library = view.compare(libraryMethod("sequential", searchOfView()));
        CHECK(paper.visible > 3000);
        CHECK(library.visibleRight >= 0.98 * library.visible);
        CHECK(library.skyFalse <= 0.005 * library.sky);
        CHECK(baseline.fetches >= library.fetches);
        CHECK(binary.fetches < 20.0);
        if (branch)
        {
            CHECK(paper.skyFalse >= 0.5 * paper.sky);
            CHECK(binary.skyFalse >= 0.5 * binary.sky);
            CHECK(baseline.skyFalse <= 0.1 * baseline.sky);
        }
        else
        {
            CHECK(paper.visibleRight >= 0.95 * paper.visible);
            CHECK(paper.skyFalse <= 0.01 * paper.sky);
            CHECK(paper.median > library.median);
            CHECK(binary.visibleRight < 0.95 * binary.visible);
            CHECK(baseline.visibleRight >= 0.95 * baseline.visible);
            CHECK(std::abs(paper.fetches - 2.0 * baseline.fetches) <= 0.1 * paper.fetches);
        }
    }
}

// Falls when what is under the water is left in the mirrored image, or culled the wrong way round;
// when the pixel's own place is looked up half a pixel off; and when places are told with other
// matrices than the image was taken with.
TEST_CASE("a mirrored camera shows what calm water reflects, the hidden too")
{
    BenchView view(createBranchedBoxes());
    view.camera().setProjectionMatrixAsFrustum(-0.05, 0.07, -0.05, 0.04, 0.1, 1000.0);
    const Method method = mirrorMethod({0.3, false});
    const Tally tally = view.compare(method);
    CHECK(tally.hits > tally.visible);
    CHECK(tally.hitsRight >= 0.995 * tally.hits); // a silhouette's pixel may be either's
    CHECK(tally.skyFalse <= 0.005 * tally.sky);
    CHECK(tally.fetches == 1.0);
    CHECK(tally.median < 0.05);

    const osg::ref_ptr<osg::Image> hits = view.show(method, DebugView::HIT);
    const osg::ref_ptr<osg::Image> colours = view.show(method, DebugView::REFLECTION);
    double worst = 0.0;
    view.forEachRay(
        [&](int x, int y, const osg::Vec3d&, const osg::Vec3d&)
        {
            const osg::Vec4 hit = pixel(*hits, x, y);
            const osg::Vec4 colour = pixel(*colours, x, y);
            CHECK(positionCodes::isPlace(colour) == (hit.x() >= 0.0f));
            if (hit.x() < 0.0f) return;
            const osg::Vec2d window(hit.x(), hit.y());
            const auto place = view.bed.mirror->placeAt(window, *view.readMirror->windowZ);
            REQUIRE(place);
            const osg::Vec3d told = positionCodes::place(colour);
            worst = std::max(worst, (*place - told).length() / told.length());
        });
    CHECK(worst < 1e-3); // 24 bits of depth, and codes in steps of 3e-5
}

// Falls when an axis of the bending is turned round, or left in the world's orientation: the view
// looks along the world's -x.
TEST_CASE("a mirrored image is bent the way that waves bend it")
{
    BenchView view(scenes::createBoxes());
    view.bed.water->setWaves(TrochoidalWaves::createBreeze(2.0, 0.08));
    view.look(osg::Vec3d(17, 16, 2), osg::Vec3d(0, 14, 0));
    const Tally unbent = view.compare(mirrorMethod({0.0, false}));
    const Tally bent = view.compare(mirrorMethod({0.3, false}));
    const Tally bentBack = view.compare(mirrorMethod({-0.3, false}));
    const Tally bentOverDistance = view.compare(mirrorMethod({3.0, true}));
    for (const Tally& better : {bent, bentOverDistance})
    {
        CHECK(better.medianX < 0.9 * unbent.medianX);
        CHECK(better.medianY < 0.9 * unbent.medianY);
        CHECK(better.visibleRight > 1.2 * unbent.visibleRight);
    }
    CHECK(bentBack.medianX > 1.2 * unbent.medianX);
    CHECK(bentBack.medianY > 1.2 * unbent.medianY);
    // Even so, waves are more than a bent image can show.
    CHECK(view.compare(libraryMethod("sequential", searchOfView())).visibleRight >
          1.8 * bent.visibleRight);
}

// Falls when a searching method's answer is that of the sky, or the other way round.
TEST_CASE("the sky alone is reflected where there is no search")
{
    BenchView view(scenes::createBoxes());
    const osg::ref_ptr<osg::Image> hits = view.show(skyOnlyMethod(), DebugView::HIT);
    const osg::ref_ptr<osg::Image> colours = view.show(skyOnlyMethod(), DebugView::REFLECTION);
    const int count = view.forEachRay(
        [&](int x, int y, const osg::Vec3d&, const osg::Vec3d&)
        {
            CHECK(pixel(*hits, x, y) == osg::Vec4(-1, -1, 1, 0));
            CHECK((pixel(*colours, x, y) - SKY_COLOUR).length() < 1e-6);
        });
    CHECK(count > 20000);
}

// Falls when a method's scene stays in the capture, or out of the next method's; when the mirrored
// camera is rendered for methods that do not ask for it; or when programs are dropped and linked
// anew as methods alternate.
TEST_CASE("methods alternate without paying for one another")
{
    BenchView view(scenes::createBoxes());
    const std::vector<Method> methods = {libraryMethod("sequential", searchOfView()),
                                         paperMethod(),
                                         skyOnlyMethod(),
                                         mirrorMethod({0.1, true}),
                                         baselineMethod(),
                                         paperBinaryMethod()};
    std::vector<osg::observer_ptr<osg::Program>> programs;
    std::vector<osg::ref_ptr<osg::Image>> pictures;
    for (int round = 0; round < 2; ++round)
        for (std::size_t i = 0; i < methods.size(); ++i)
        {
            const Method& method = methods[i];
            INFO(method.name << ", round " << round);
            const osg::ref_ptr<osg::Image> picture = view.show(method, DebugView::REFLECTION);

            const CapturedImage& captured = view.captured->one();
            bool empty = true;
            bool framed = false;
            for (int y = 0; y < HEIGHT; ++y)
                for (int x = 0; x < WIDTH; ++x)
                {
                    empty = empty && pixel(*captured.windowZ, x, y).r() == 1.0f;
                    framed = framed || positionCodes::isPlace(pixel(*picture, x, y));
                }
            CHECK(empty == !method.usesCapture);
            CHECK(framed);
            const bool hierarchical = method.settings.search == Search::HIERARCHICAL;
            CHECK(view.captured->stages == (method.mirror ? 2u : hierarchical ? 5u : 1u));

            // Whoever asks while the method is at work gets its program: the one of round 0.
            const auto before = view.bed.programs.size();
            const MethodScope scope(method, view.bed);
            const osg::ref_ptr<osg::Program> program =
                programOf(keyOf(WaterPass::SHADE, *view.bed.water, method.settings, Images::ONE,
                                effectsOf(*view.bed.water, EffectView())));
            CHECK(view.bed.programs.size() == before);
            if (round == 0)
            {
                programs.push_back(program.get());
                pictures.push_back(picture);
                for (std::size_t j = 0; j < i; ++j)
                    CHECK(programs[j].get() != program.get());
            }
            else
            {
                CHECK(programs[i].valid());
                CHECK(programs[i].get() == program.get());
                CHECK(countDifferent(*pictures[i], *picture) == 0);
            }
        }
    CHECK(view.bed.programs.size() == methods.size());
}

TEST_CASE("a mirror method without a mirrored camera is refused")
{
    TestBed bed;
    bed.water = scenes::createBoxesWater();
    bed.scene = scenes::createBoxes();
    CHECK_THROWS_WITH(MethodScope(mirrorMethod({0.1, false}), bed),
                      "MethodScope: expected a mirrored camera for the method mirror, got none");
}

// Captures of the eye mirrored in the water.

#include "support/CapturedImages.h"
#include "support/Catch.h"
#include "support/MirrorTruth.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osgWaterReflect/Transforms.h>
#include <osgWaterReflect/TrochoidalWaves>

#include <osg/Billboard>
#include <osg/CullFace>
#include <osg/Depth>
#include <osg/LOD>
#include <osg/LightSource>
#include <osg/MatrixTransform>

#include <cmath>

using namespace osgWaterReflect;
using DebugView = WaterSurface::DebugView;

namespace
{

const osg::Vec4 RED(1, 0, 0, 1);
const osg::Vec4 GREEN(0, 1, 0, 1);
const osg::Vec4 BLUE(0, 0, 1, 1);

void setCapture(WaterSurface& water, CaptureKind capture, Search search = Search::HIERARCHICAL)
{
    ReflectionSettings settings = water.getReflection();
    settings.capture = capture;
    settings.search = search;
    REQUIRE(water.setReflection(settings));
}

osg::ref_ptr<WaterSurface> createPond(const osg::Vec3& centre, double size,
                                      CaptureKind capture = CaptureKind::MIRROR)
{
    osg::ref_ptr<WaterSurface> pond =
        WaterSurface::createRectangle(centre, osg::Vec3(size, 0, 0), osg::Vec3(0, size, 0));
    setCapture(*pond, capture);
    return pond;
}

// Looking along +y, pitched down.
MirrorView pitched(double height, double pitchDegrees)
{
    const double pitch = osg::DegreesToRadians(pitchDegrees);
    const osg::Vec3d eye(0.0137, -2, height);
    return {eye, eye + osg::Vec3d(0, std::cos(pitch), -std::sin(pitch))};
}

// Boxes, and slabs that hang over the water so that only their undersides are reflected where the
// view is steep.
osg::ref_ptr<osg::Group> createOverhangs()
{
    const osg::ref_ptr<osg::Group> scene = scenes::createBoxes();
    for (int i = 0; i < 4; ++i)
        scene->addChild(scenes::createBox(osg::Vec3(1.3 * i - 2.0, 0.5 + 0.9 * i, 0.5 + 0.4 * i),
                                          osg::Vec3(0.8, 0.6, 0.2), osg::Vec4(1, 1, 1, 1)));
    return scene;
}

// Where single precision rounds another way at a silhouette, a pixel of the one image shows what is
// nearer and of the other what is behind it: all else has to be right.
void checkExact(const MirrorComparison& result)
{
    WARN(result.waterPixels << " water pixels, " << 100.0 * result.right / result.waterPixels
                            << " % right, " << result.sky << " of sky");
    CHECK(result.waterPixels > 20000);
    CHECK(result.sky < 0.99 * result.waterPixels);
    CHECK(result.right >= 0.9999 * result.waterPixels);
    CHECK(result.wrongInside == 0);
}

struct HarbourView : OffscreenView
{
    explicit HarbourView(int width = 160, int height = 120, Format format = Format::RGBA32F) :
        OffscreenView(width, height, format), captured(CapturedImages::of(camera()))
    {
        look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
    }

    int numMirrored() const
    {
        int count = 0;
        for (const CapturedImage& image : captured->images)
            count += image.mirrored;
        return count;
    }

    osg::ref_ptr<CapturedImages> captured;
};

bool isNear(const osg::Vec4& a, const osg::Vec4& b, double tolerance = 0.02)
{
    return (a - b).length() <= tolerance;
}

int countColour(const osg::Image& image, const osg::Vec4& colour)
{
    int count = 0;
    for (int y = 0; y < image.t(); ++y)
        for (int x = 0; x < image.s(); ++x)
            count += isNear(pixel(image, x, y), colour);
    return count;
}

// An upright view of 101 by 101 pixels, 45 degrees down its middle, over a calm pond that reflects
// in full what is in front of the eye.
struct PondView : OffscreenView
{
    PondView() : OffscreenView(101, 101, Format::RGBA32F), pond(createPond(osg::Vec3(), 40.0))
    {
        camera().setClearColor(osg::Vec4(0, 0, 0, 1));
        look(EYE, osg::Vec3d(0, 0, 0), 60.0);
        pond->setDebugView(DebugView::REFLECTION);
    }
    const osg::Vec3d EYE{0, -4, 4};
    osg::ref_ptr<WaterSurface> pond;
};

} // namespace

// Breaks with MIRRORED false (CaptureBinding::bind), without a floor (MirroredCapture::draw), with
// the image not turned left for right in clipFromEye (mirroredEye).
TEST_CASE("calm water shows all that the mirrored eye sees in the mirrored capture", "[mirror]")
{
    MirrorView rolled = pitched(4.0, 25.0);
    rolled.rollDegrees = 25.0;
    MirrorView orthographic = pitched(4.0, 25.0);
    orthographic.orthographicHeight = 12.0;
    MirrorView offAxis = pitched(4.0, 25.0);
    offAxis.offAxis.set(0.3, -0.2);
    const struct
    {
        const char* name;
        MirrorView view;
    } views[] = {
        {"level", pitched(2.0, 0.0)},     {"pitch 25", pitched(4.0, 25.0)},
        {"pitch 60", pitched(6.0, 60.0)}, {"pitch 80", pitched(8.0, 80.0)},
        {"grazing", pitched(0.15, 0.3)},  {"rolled", rolled},
        {"orthographic", orthographic},   {"off-axis", offAxis},
    };
    for (const auto& view : views)
        for (Search search : {Search::SEQUENTIAL, Search::HIERARCHICAL, Search::BINARY})
            DYNAMIC_SECTION(view.name << ", search " << static_cast<int>(search))
            {
                const osg::ref_ptr<WaterSurface> water = scenes::createBoxesWater();
                setCapture(*water, CaptureKind::MIRROR, search);
                checkExact(compareWithMirror(*createOverhangs(), *water, osg::Plane(0, 0, 1, 0),
                                             view.view, std::string("mirror ") + view.name));
            }
}

// Breaks where mirroredEye takes the side of the still water from its normal alone.
TEST_CASE("from under the water, and over tilted water, the mirrored capture is as exact",
          "[mirror]")
{
    SECTION("from under the water")
    {
        const osg::ref_ptr<osg::Group> scene = scenes::createBoxes();
        scene->addChild(scenes::createBox(osg::Vec3(1, 6, -3), osg::Vec3(3, 1, 1), RED));
        const osg::ref_ptr<WaterSurface> water = scenes::createBoxesWater();
        setCapture(*water, CaptureKind::MIRROR);
        checkExact(compareWithMirror(*scene, *water, osg::Plane(0, 0, -1, 0), pitched(-2.0, -15.0),
                                     "mirror from below"));
    }
    for (double degrees : {-6.0, 6.0})
        DYNAMIC_SECTION(degrees << " degrees about x")
        {
            const double angle = osg::DegreesToRadians(degrees);
            const osg::Vec3d along(0, std::cos(angle), std::sin(angle));
            const osg::Vec3d normal(0, -std::sin(angle), std::cos(angle));
            const osg::Vec3d centre = along * 20.0;
            const osg::ref_ptr<WaterSurface> water = WaterSurface::createRectangle(
                centre, osg::Vec3(200, 0, 0), osg::Vec3(along * 120.0));
            setCapture(*water, CaptureKind::MIRROR);
            checkExact(compareWithMirror(*scenes::createBoxes(), *water, osg::Plane(normal, centre),
                                         pitched(3.0, 8.6), "mirror tilted"));
        }
}

TEST_CASE("undersides of what hangs over the water are seen in the mirrored capture only",
          "[mirror]")
{
    PondView view;
    const osg::ref_ptr<osg::Group> scene = scenes::together(
        {scenes::createQuad(osg::Vec3(-1, -1, 1.1), osg::Vec3(2, 0, 0), osg::Vec3(0, 2, 0), GREEN),
         scenes::createQuad(osg::Vec3(-0.7, -0.7, 1), osg::Vec3(1.4, 0, 0), osg::Vec3(0, 1.4, 0),
                            RED),
         view.pond});
    CHECK(countColour(view.render(scene), RED) > 100);
    setCapture(*view.pond, CaptureKind::VIEW_AND_MIRROR);
    CHECK(countColour(view.render(scene), RED) > 100);
    setCapture(*view.pond, CaptureKind::VIEW);
    CHECK(countColour(view.render(scene), RED) == 0);
}

// Breaks where the plan has one mirrored image for all planes, or one for each sheet.
TEST_CASE("each plane of water has one mirrored capture, which all of its sheets share", "[mirror]")
{
    double now = 0.0;
    HarbourView view;
    view.record().clock = [&now] { return now; };
    const osg::ref_ptr<osg::Group> root =
        scenes::together({scenes::createHarbour(), createPond(osg::Vec3(-5, 0, 0), 8.0)});
    view.render(root);
    CHECK(view.captured->images.size() == 1);
    CHECK(view.numMirrored() == 1);
    CHECK(view.captured->stages ==
          7); // the capture, its straight windowZ, its sky and four of its cells

    root->addChild(createPond(osg::Vec3(5, 0, 0), 8.0));
    osg::ref_ptr<osg::MatrixTransform> moved = new osg::MatrixTransform(
        osg::Matrixd::rotate(0.7, osg::Vec3d(0, 0, 1)) * osg::Matrixd::translate(3, 9, 0.3));
    moved->addChild(createPond(osg::Vec3(0, 0, -0.3), 3.0)); // the same plane
    root->addChild(moved);
    view.render(root);
    CHECK(view.numMirrored() == 1);

    const osg::ref_ptr<WaterSurface> high = createPond(osg::Vec3(0, -6, 0.5), 4.0);
    root->addChild(high);
    root->addChild(createPond(osg::Vec3(0, 9, 0), 4.0, CaptureKind::VIEW));
    root->addChild(createPond(osg::Vec3(6, -3, 0), 4.0, CaptureKind::VIEW_AND_MIRROR));
    view.render(root);
    CHECK(view.numMirrored() == 2);
    CHECK(view.captured->images.size() == 3);
    CHECK(view.record().numCaptures() == 3);

    // What is not used is held for a while, and then let go.
    root->removeChild(high);
    now += 0.9 * WaterView::HOLD_TIME;
    view.render(root);
    CHECK(view.record().numCaptures() == 3);
    now += 0.2 * WaterView::HOLD_TIME;
    view.render(root);
    CHECK(view.record().numCaptures() == 2);
    root->removeChildren(1, root->getNumChildren() - 1);
    root->addChild(createPond(osg::Vec3(0, 0, 0), 4.0, CaptureKind::VIEW));
    now += 1.1 * WaterView::HOLD_TIME;
    view.render(root);
    CHECK(view.record().numCaptures() == 1);
    CHECK(view.numMirrored() == 0);
}

TEST_CASE("two ponds at different levels each show what the eye mirrored in them sees", "[mirror]")
{
    HarbourView view;
    const osg::ref_ptr<osg::Group> harbour = scenes::createHarbour();
    const auto low = createPond(osg::Vec3(-7, -2, -0.4), 12.0);
    const auto high = createPond(osg::Vec3(7, -2, 0.4), 12.0);
    const osg::ref_ptr<osg::Image> lowAlone = copyOf(view.render(scenes::together({harbour, low})));
    const osg::ref_ptr<osg::Image> highAlone =
        copyOf(view.render(scenes::together({harbour, high})));
    const osg::Image& both = view.render(scenes::together({harbour, low, high}));
    int different = 0;
    int waterPixels = 0;
    const osg::ref_ptr<osg::Image> picture = copyOf(both);
    const osg::ref_ptr<osg::Image> without = copyOf(view.render(harbour));
    for (int y = 0; y < picture->t(); ++y)
        for (int x = 0; x < picture->s(); ++x)
        {
            const osg::Vec4 bare = pixel(*without, x, y);
            const bool isLow = !isNear(pixel(*lowAlone, x, y), bare, 0.0);
            const bool isHigh = !isNear(pixel(*highAlone, x, y), bare, 0.0);
            if (isLow == isHigh) continue; // neither, or the one hides the other
            ++waterPixels;
            different +=
                !isNear(pixel(*picture, x, y), pixel(isLow ? *lowAlone : *highAlone, x, y), 1e-6);
        }
    CHECK(waterPixels > 2000);
    CHECK(different == 0);
}

// Green is the sky, blue what is behind it. Nothing breaks it yet that has been tried; skyColour
// going up in the mirrored image, too, does not.
TEST_CASE("what passes over things sees the scene's own sky in the mirrored image", "[mirror]")
{
    PondView view;
    view.camera().setClearColor(BLUE);
    view.look(osg::Vec3d(0, -8, 2), osg::Vec3d(0, 0, 0.5));
    const osg::ref_ptr<osg::Node> dome =
        scenes::createBox(osg::Vec3(), osg::Vec3(200, 200, 200), GREEN);
    dome->getOrCreateStateSet()->setAttributeAndModes(
        new osg::Depth(osg::Depth::LESS, 0.0, 1.0, false));
    dome->getOrCreateStateSet()->setRenderBinDetails(-1, "RenderBin");
    const osg::ref_ptr<osg::Group> scene = scenes::together(
        {dome, view.pond, scenes::createBox(osg::Vec3(0, 4, 0), osg::Vec3(20, 1, 3), RED)});
    view.pond->setWaves(TrochoidalWaves::createBreeze(3.0, 0.3));
    const osg::Image& picture = view.render(scene);
    CHECK(countColour(picture, RED) > 500);
    CHECK(countColour(picture, GREEN) > 500);
    CHECK(countColour(picture, BLUE) == 0);
}

// A face of one normal, lit from a direction, has one colour wherever the eye is. Breaks where
// CaptureVisitor::cull does not turn the view's lights for the capture's eye.
TEST_CASE("what is lit by the view's head light, or by the scene, is lit so in the mirrored image",
          "[mirror]")
{
    PondView view;
    // It leans back: a head light at the mirrored eye would light it half as much.
    const osg::ref_ptr<osg::Geometry> wall = osg::createTexturedQuadGeometry(
        osg::Vec3(-3, 3, 0), osg::Vec3(6, 0, 0), osg::Vec3(0, 1.2, 4));
    const osg::ref_ptr<osg::Group> scene = scenes::together({wall, view.pond});
    SECTION("a head light")
    {
        view.viewer().setLightingMode(osg::View::HEADLIGHT);
    }
    SECTION("a sky light")
    {
        view.viewer().setLightingMode(osg::View::SKY_LIGHT);
    }
    SECTION("the scene's own")
    {
        view.viewer().setLightingMode(osg::View::NO_LIGHT);
        osg::ref_ptr<osg::LightSource> lamp = new osg::LightSource;
        lamp->getLight()->setPosition(osg::Vec4(0.3, -0.8, 0.4, 0));
        scene->addChild(lamp);
        scene->getOrCreateStateSet()->setMode(GL_LIGHT0, osg::StateAttribute::ON);
        scene->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::ON);
    }
    const osg::Image& picture = view.render(scene);
    const osg::Vec4 seen = pixel(picture, 50, 95);      // the wall
    const osg::Vec4 reflected = pixel(picture, 50, 65); // its reflection
    INFO(seen.r() << " and " << reflected.r());
    CHECK(seen.r() > 0.1f);
    CHECK(seen.r() < 0.99f);
    CHECK(isNear(seen, reflected, 1e-4));
}

// Breaks with a mirrored view matrix that is not turned left for right (mirroredEye).
TEST_CASE("culled back faces, billboards and levels of detail are right in the mirrored image",
          "[mirror]")
{
    PondView view;
    const auto quad = [](double x, const osg::Vec4& colour)
    {
        return scenes::createQuad(osg::Vec3(x, 0, 0.2), osg::Vec3(1, 0, 0), osg::Vec3(0, 0, 3),
                                  colour);
    };
    osg::ref_ptr<osg::Group> scene = scenes::together({view.pond});
    SECTION("back faces")
    {
        // The left one faces the eye, the right one turns its back on it.
        scene->addChild(scenes::createQuad(osg::Vec3(-1.5, 2, 0.2), osg::Vec3(1.5, 0, 0),
                                           osg::Vec3(0, 0, 3), RED));
        scene->addChild(scenes::createQuad(osg::Vec3(1.5, 2, 0.2), osg::Vec3(-1.5, 0, 0),
                                           osg::Vec3(0, 0, 3), BLUE));
        scene->getOrCreateStateSet()->setAttributeAndModes(new osg::CullFace);
        const osg::Image& picture = view.render(scene);
        CHECK(countColour(picture, RED) > 500);
        CHECK(countColour(picture, BLUE) == 0);
        CHECK(isNear(pixel(picture, 45, 50), RED));
    }
    SECTION("billboards")
    {
        const osg::ref_ptr<osg::Billboard> billboard = new osg::Billboard;
        billboard->setMode(osg::Billboard::AXIAL_ROT);
        billboard->setAxis(osg::Vec3(0, 0, 1));
        billboard->setNormal(osg::Vec3(0, -1, 0));
        for (const auto& side : {quad(-1, RED), quad(0, BLUE)})
            billboard->addDrawable(side->asGeometry(), osg::Vec3(0, 2, 0));
        billboard->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
        scene->addChild(billboard);
        const osg::Image& picture = view.render(scene);
        CHECK(isNear(pixel(picture, 45, 90), RED)); // itself
        CHECK(isNear(pixel(picture, 55, 90), BLUE));
        CHECK(isNear(pixel(picture, 45, 55), RED)); // its reflection
        CHECK(isNear(pixel(picture, 55, 55), BLUE));
    }
    SECTION("levels of detail")
    {
        // 7.2 m from the eye, 9.2 m from the mirrored one: as the view sees it.
        const osg::ref_ptr<osg::LOD> lod = new osg::LOD;
        lod->setCenterMode(osg::LOD::USER_DEFINED_CENTER);
        lod->setCenter(osg::Vec3(0, 2, 3));
        lod->setRadius(3.0);
        const auto level = [](const osg::Vec4& colour)
        {
            return scenes::createQuad(osg::Vec3(-1, 2, 0.2), osg::Vec3(2, 0, 0), osg::Vec3(0, 0, 3),
                                      colour);
        };
        lod->addChild(level(GREEN), 0.0f, 8.0f);
        lod->addChild(level(RED), 8.0f, 100.0f);
        scene->addChild(lod);
        const osg::Image& picture = view.render(scene);
        CHECK(countColour(picture, GREEN) > 500);
        CHECK(countColour(picture, RED) == 0);
    }
    SECTION("shaders that ask OpenSceneGraph for the view's matrix")
    {
        // Green above the height of 1.5 in the world, else blue.
        osg::ref_ptr<osg::Program> program = new osg::Program;
        program->addShader(new osg::Shader(osg::Shader::VERTEX, R"glsl(#version 130
            uniform mat4 osg_ViewMatrixInverse;
            varying vec4 placeWorld;
            void main()
            {
                vec4 placeEye = gl_ModelViewMatrix * gl_Vertex;
                placeWorld = osg_ViewMatrixInverse * placeEye;
                gl_Position = gl_ProjectionMatrix * placeEye;
            })glsl"));
        program->addShader(new osg::Shader(osg::Shader::FRAGMENT, R"glsl(#version 130
            varying vec4 placeWorld;
            void main()
            {
                float high = step(1.5, placeWorld.z);
                gl_FragColor = vec4(0.0, high, 1.0 - high, 1.0);
            })glsl"));
        const osg::ref_ptr<osg::Node> wall =
            scenes::createQuad(osg::Vec3(-1, 2, 0), osg::Vec3(2, 0, 0), osg::Vec3(0, 0, 3), RED);
        wall->getOrCreateStateSet()->setAttribute(program);
        scene->addChild(wall);
        const osg::Image& picture = view.render(scene);
        int reflectedGreen = 0;
        int reflectedBlue = 0;
        for (int y = 0; y < 60; ++y)
        {
            reflectedGreen += isNear(pixel(picture, 50, y), GREEN);
            reflectedBlue += isNear(pixel(picture, 50, y), BLUE);
        }
        CHECK(reflectedGreen > 5);
        CHECK(reflectedBlue > 5);
    }
}

// Breaks without the floor (MirroredCapture::draw), or with one that waves do not lower.
TEST_CASE("nothing under the water is in the mirrored image, but what waves may lay bare",
          "[mirror]")
{
    PondView view;
    const osg::ref_ptr<osg::Group> scene = scenes::together(
        {view.pond, scenes::createBox(osg::Vec3(0, 0, -3), osg::Vec3(30, 30, 1), RED), // the ground
         scenes::createBox(osg::Vec3(0, 0, -0.2), osg::Vec3(1, 1, 0.1), GREEN),
         scenes::createBox(osg::Vec3(0, 1.5, 0), osg::Vec3(1, 1, 1), BLUE)});
    const osg::ref_ptr<CapturedImages> captured = CapturedImages::of(view.camera());
    view.render(scene);
    CHECK(countColour(*captured->one().colour, RED) == 0);
    CHECK(countColour(*captured->one().colour, GREEN) == 0);
    CHECK(countColour(*captured->one().colour, BLUE) > 100);

    const osg::ref_ptr<TrochoidalWaves> waves = TrochoidalWaves::createBreeze(8.0, 0.5);
    REQUIRE(waves->getAmplitude() > 0.25);
    REQUIRE(waves->getAmplitude() < 2.0);
    view.pond->setWaves(waves);
    view.render(scene);
    CHECK(countColour(*captured->one().colour, RED) == 0);
    CHECK(countColour(*captured->one().colour, GREEN) > 100);
}

// A step of the oblique depth buffer is what it would be in an ordinary one whose near plane is
// where the steepest line of sight of the view comes up to the floor.
TEST_CASE("an oblique near plane costs no depth where the eye is higher than a near plane is far",
          "[mirror]")
{
    const double far = 500.0;
    for (double height : {0.15, 2.0, 20.0})
        for (double pitchDegrees : {0.0, 25.0, 60.0})
        {
            const double pitch = osg::DegreesToRadians(pitchDegrees);
            const double halfView = osg::DegreesToRadians(23.0);
            const glm::dmat4 clipFromEye =
                fromOsg(osg::Matrixd::perspective(46.0, 4.0 / 3.0, 0.5, far));
            // The mirrored eye looks up by the pitch.
            WaterPlane floor;
            floor.plane = glm::dvec4(0.0, std::cos(pitch), -std::sin(pitch), -height);
            const ObliqueProjection oblique = obliqueProjection(clipFromEye, floor, 0.0);
            const double depth = 100.0;
            const auto windowZ = [&](double at)
            {
                const glm::dvec4 clip =
                    oblique.clipFromEye * glm::dvec4(0.0, at * std::tan(halfView), -at, 1.0);
                return 0.5 * clip.z / clip.w + 0.5;
            };
            const double perMetre = (windowZ(depth + 0.01) - windowZ(depth - 0.01)) / 0.02;
            const double steepest =
                std::cos(pitch) * std::tan(halfView) + std::sin(pitch) - height / far;
            CHECK(perMetre == Approx(height / steepest / (depth * depth)).epsilon(1e-6));
            WARN("eye " << height << " m up, pitch " << pitchDegrees << ": as near at "
                        << height / steepest << " m; a step at 100 m is "
                        << 1000.0 / (perMetre * 16777216.0) << " mm");
        }
}

// What nothing has hidden is settled when it comes to the sky: it is not looked for again, which
// the count of fetches tells. Breaks where lookFor(mirrorCapture) is asked for all rays to the sky,
// or for those that hit.
TEST_CASE("both captures leave what the eye's image shows, and fill in what it loses", "[mirror]")
{
    const osg::ref_ptr<osg::Group> scene = createOverhangs();
    const osg::ref_ptr<WaterSurface> water = scenes::createBoxesWater();
    scene->addChild(water);
    water->setDebugView(DebugView::HIT);
    OffscreenView view(320, 240, OffscreenView::Format::RGBA32F);
    view.camera().setClearColor(osg::Vec4(0, 0, 0, -9));
    for (bool moving : {false, true})
    {
        water->setWaves(moving ? TrochoidalWaves::createBreeze(2.0, 0.15) : nullptr);
        const MirrorView pitch = pitched(2.0, 20.0);
        view.look(pitch.eye, pitch.centre);
        setCapture(*water, CaptureKind::VIEW);
        const osg::ref_ptr<osg::Image> alone = copyOf(view.render(scene));
        setCapture(*water, CaptureKind::VIEW_AND_MIRROR);
        const osg::Image& both = view.render(scene);
        int hits = 0;
        int hitsChanged = 0;
        int sky = 0;
        int skyChanged = 0;
        int lost = 0;
        int filled = 0;
        for (int y = 0; y < view.height(); ++y)
            for (int x = 0; x < view.width(); ++x)
            {
                const osg::Vec4 a = pixel(*alone, x, y);
                const osg::Vec4 b = pixel(both, x, y);
                if (a.a() < 0.0f) continue;
                const bool changed = (a - b).length() > 0.0f;
                if (a.z() == 0.0f)
                {
                    ++hits;
                    hitsChanged += changed;
                }
                else if (a.z() == 1.0f)
                {
                    ++sky;
                    skyChanged += changed;
                }
                else
                {
                    ++lost;
                    filled += b.z() >= 16.0f;
                }
            }
        WARN(hits << " hits, " << sky << " of sky, " << skyChanged << " of these looked for again; "
                  << lost << " lost, " << filled << " filled");
        CHECK(hits > 5000);
        CHECK(hitsChanged == 0);
        CHECK(sky > 2000);
        CHECK(skyChanged < 0.2 * sky);
        CHECK(filled > 500);
        CHECK(filled < lost);
    }
}

TEST_CASE("in the mirrored capture the hierarchical search finds what the sequential one finds",
          "[mirror]")
{
    const osg::ref_ptr<osg::Group> scene = createOverhangs();
    const osg::ref_ptr<WaterSurface> water = scenes::createBoxesWater();
    scene->addChild(water);
    water->setDebugView(DebugView::HIT);
    OffscreenView view(333, 241, OffscreenView::Format::RGBA32F);
    view.camera().setClearColor(osg::Vec4(0, 0, 0, -9));
    for (bool moving : {false, true})
        for (CaptureKind capture : {CaptureKind::MIRROR, CaptureKind::VIEW_AND_MIRROR})
            for (double pitchDegrees : {5.0, 25.0})
            {
                water->setWaves(moving ? TrochoidalWaves::createBreeze(2.0, 0.15) : nullptr);
                const MirrorView pitch = pitched(2.0, pitchDegrees);
                view.look(pitch.eye, pitch.centre);
                setCapture(*water, capture, Search::SEQUENTIAL);
                const osg::ref_ptr<osg::Image> sequential = copyOf(view.render(scene));
                setCapture(*water, capture, Search::HIERARCHICAL);
                const osg::Image& hierarchical = view.render(scene);
                int pixels = 0;
                int different = 0;
                for (int y = 0; y < view.height(); ++y)
                    for (int x = 0; x < view.width(); ++x)
                    {
                        const osg::Vec4 a = pixel(*sequential, x, y);
                        const osg::Vec4 b = pixel(hierarchical, x, y);
                        if (a.a() < 0.0f) continue;
                        ++pixels;
                        different +=
                            a.z() != b.z() || std::hypot(a.x() - b.x(), a.y() - b.y()) > 1e-3;
                    }
                INFO("moving " << moving << ", capture " << static_cast<int>(capture) << ", pitch "
                               << pitchDegrees << ": " << different << " of " << pixels);
                CHECK(pixels > 20000);
                CHECK(different <= 1e-4 * pixels);
            }
}

// Breaks where WaterView::forEachGLObjects leaves out its captures.
TEST_CASE("mirrored captures are released with their water, resized with the view, and come back",
          "[mirror]")
{
    HarbourView view;
    const osg::ref_ptr<WaterSurface> lake = createPond(osg::Vec3(), 60.0);
    const osg::ref_ptr<osg::Group> root = scenes::together({scenes::createHarbour(), lake});
    const osg::ref_ptr<osg::Image> before = copyOf(view.render(root));
    const unsigned int context = view.camera().getGraphicsContext()->getState()->getContextID();
    const std::vector<osg::ref_ptr<osg::Texture2D>> textures = view.captured->textures;
    REQUIRE(textures.size() == 3); // with the straightened windowZ
    root->releaseGLObjects(nullptr);
    for (const osg::ref_ptr<osg::Texture2D>& texture : textures)
        CHECK(texture->getTextureObject(context) == nullptr);
    CHECK(countDifferent(view.render(root), *before) == 0);
    root->resizeGLObjectBuffers(64);
    CHECK(countDifferent(view.render(root), *before) == 0);

    view.camera().setViewport(0, 0, 80, 60);
    view.render(root);
    CHECK(view.captured->one().colour->s() == 80);
    view.camera().setViewport(0, 0, 160, 120);
    CHECK(countDifferent(view.render(root), *before) == 0);
    CHECK(view.record().numCaptures() == 1);
}

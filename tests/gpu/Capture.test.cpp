#include "support/CapturedImages.h"
#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osg/Material>
#include <osg/MatrixTransform>
#include <osg/PolygonMode>
#include <osg/Program>
#include <osgUtil/CullVisitor>

#include <random>

using osgWaterReflect::ReflectionSettings;
using osgWaterReflect::WaterSurface;

namespace
{

// The frame is a frame buffer object as the capture is: a window's buffer may be stored upside
// down, and interpolation then rounds another way.
struct HarbourView : OffscreenView
{
    explicit HarbourView(int width = 160, int height = 120, Format format = Format::RGBA32F) :
        OffscreenView(width, height, format), captured(CapturedImages::of(camera()))
    {
        look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
    }
    osg::ref_ptr<CapturedImages> captured;
};

// Counts the culls that come to its node.
class CountVisits : public osg::NodeCallback
{
public:
    void operator()(osg::Node* node, osg::NodeVisitor* visitor) override
    {
        ++count;
        traverse(node, visitor);
    }
    int count = 0;
};

// Pushes state in the cull, as shadow techniques and effects do.
class PushState : public osg::NodeCallback
{
public:
    explicit PushState(osg::StateSet* stateSet) : _stateSet(stateSet) {}
    void operator()(osg::Node* node, osg::NodeVisitor* visitor) override
    {
        visitor->asCullVisitor()->pushStateSet(_stateSet.get());
        traverse(node, visitor);
        visitor->asCullVisitor()->popStateSet();
    }

private:
    osg::ref_ptr<osg::StateSet> _stateSet;
};

// State that would show on everything: everything of it OVERRIDEs what lies below.
osg::ref_ptr<osg::StateSet> createLoudState()
{
    const unsigned int force = osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE;
    osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
    osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setDiffuse(osg::Material::FRONT_AND_BACK, osg::Vec4(1, 0, 1, 1));
    material->setEmission(osg::Material::FRONT_AND_BACK, osg::Vec4(1, 0, 0, 1));
    stateSet->setAttributeAndModes(material, force);

    osg::ref_ptr<osg::Image> green = new osg::Image;
    green->allocateImage(1, 1, 1, GL_RGB, GL_UNSIGNED_BYTE);
    green->setColor(osg::Vec4(0, 1, 0, 1), 0, 0);
    stateSet->setTextureAttributeAndModes(0, new osg::Texture2D(green), force);
    stateSet->setTextureAttributeAndModes(1, new osg::Texture2D(green), force);

    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(
        osg::Shader::FRAGMENT, "#version 130\nvoid main() { gl_FragColor = vec4(0, 0, 1, 1); }"));
    stateSet->setAttributeAndModes(program, force);
    stateSet->setMode(GL_BLEND, force);
    stateSet->setMode(GL_CULL_FACE, force);
    return stateSet;
}

WaterSurface& withScale(WaterSurface& water, double scale)
{
    osgWaterReflect::ViewSettings settings = water.getViewSettings();
    settings.captureScale = scale;
    REQUIRE(water.setViewSettings(settings));
    return water;
}

} // namespace

// Breaks where CaptureVisitor::cull does not hand the view's positioned lights on.
TEST_CASE("the capture is, pixel for pixel, the frame without water")
{
    const osg::ref_ptr<osg::Group> harbour = scenes::createHarbour();
    HarbourView without;
    without.camera().attach(osg::Camera::DEPTH_BUFFER, createWindowZTexture(160, 120));
    const osg::Image& frame = without.render(harbour);
    CHECK(without.captured->images.empty());

    // A context of its own, where no light has been set before.
    HarbourView with;
    with.render(scenes::together({harbour, scenes::createLake()}));
    const CapturedImage& capture = with.captured->one();
    CHECK(capture.colourFormat == GL_RGBA32F_ARB);
    CHECK(countDifferent(*capture.colour, frame) == 0);
    CHECK(countDifferent(*capture.windowZ, *without.captured->frameWindowZ) == 0);
}

// Breaks where Capture::allocate takes another format than colourFormat's.
TEST_CASE("the capture of a window has a window's 8 bits and its colours")
{
    HarbourView view(160, 120, OffscreenView::Format::RGBA8);
    const osg::ref_ptr<osg::Group> harbour = scenes::createHarbour();
    const osg::ref_ptr<osg::Image> frame = copyOf(view.render(harbour));
    view.render(scenes::together({harbour, scenes::createLake()}));
    CHECK(view.captured->one().colourFormat == GL_RGBA8);
    // Mesa keeps a window's buffer upside down, which rounds otherwise: without any water, a window
    // differs so from a frame buffer object, by one step of 8 bits in places and by more where a
    // point of an edge has moved across a pixel's centre: under a thousandth of the picture.
    CHECK(countDifferent(*view.captured->one().colour, *frame, 1.01 / 255.0) < 19);
}

// Crashes where CaptureVisitor::apply(Transform) keeps references to what its stacks hold, which
// move it when they grow.
TEST_CASE("a capture shows what is below many transforms, however they lie in the view")
{
    // Chains of transforms that run on within the view and beyond, with a box on each link.
    const osg::ref_ptr<osg::Group> scene = scenes::together({scenes::createHarbour()});
    std::mt19937 random(12);
    std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
    for (int chain = 0; chain < 12; ++chain)
    {
        osg::ref_ptr<osg::Group> last = scene;
        for (int link = 0; link < 40; ++link)
        {
            osg::Matrixd matrix =
                osg::Matrixd::rotate(anywhere(random), osg::Vec3d(0, 0, 1)) *
                osg::Matrixd::translate(anywhere(random), anywhere(random), 0.1 * anywhere(random));
            const osg::ref_ptr<osg::MatrixTransform> next = new osg::MatrixTransform(matrix);
            next->addChild(scenes::createBox(osg::Vec3(0.3 * anywhere(random), 0, 1.5),
                                             osg::Vec3(0.2, 0.3, 0.1),
                                             osg::Vec4(0.02 * link, 0.08 * chain, 0.5, 1)));
            last->addChild(next);
            last = next;
        }
    }
    HarbourView view;
    const osg::ref_ptr<osg::Image> dry = copyOf(view.render(scene));
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    ReflectionSettings settings;
    settings.capture = osgWaterReflect::CaptureKind::VIEW;
    REQUIRE(lake->setReflection(settings));
    osgWaterReflect::ViewSettings viewSettings;
    viewSettings.guardBand = osgWaterReflect::GuardBandKind::NONE;
    REQUIRE(lake->setViewSettings(viewSettings));
    scene->addChild(lake);
    view.render(scene);
    CHECK(countDifferent(*view.captured->one().colour, *dry) == 0);
}

// Breaks where WaterSurface::traverse goes on to its drawables in a capture.
TEST_CASE("no water is in a capture, neither the one that asks nor any other")
{
    HarbourView view;
    const osg::ref_ptr<osg::Group> harbour = scenes::createHarbour();
    const osg::ref_ptr<osg::Image> frame = copyOf(view.render(harbour));

    view.render(scenes::together({harbour, scenes::createLake(), scenes::createLake(0.7, 8.0),
                                  scenes::createLake(-0.5, 90.0)}));
    CHECK(countDifferent(*view.captured->one().colour, *frame) == 0);
}

// Breaks where CaptureVisitor::cull starts from the view's own state graph, or keeps all that it
// has pushed (without the line that shortens the list to the view's own).
TEST_CASE("state above the water, or its own, does not show in the capture or on the water")
{
    HarbourView view;
    const osg::ref_ptr<osg::Group> harbour = scenes::createHarbour();
    const osg::ref_ptr<osg::Image> frame = copyOf(view.render(harbour));
    const osg::ref_ptr<osg::Image> expected =
        copyOf(view.render(scenes::together({harbour, scenes::createLake()})));

    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    const osg::ref_ptr<osg::Group> above = scenes::together({lake});
    const osg::ref_ptr<osg::Group> root = scenes::together({harbour, above});
    SECTION("a StateSet on a group above it")
    {
        above->setStateSet(createLoudState());
    }
    SECTION("a StateSet on the water's node")
    {
        lake->setStateSet(createLoudState());
    }
    SECTION("state that a callback pushes in the cull")
    {
        above->setCullCallback(new PushState(createLoudState()));
    }
    SECTION("state that the water's own callback pushes in the cull")
    {
        lake->setCullCallback(new PushState(createLoudState()));
    }
    const osg::Image& picture = view.render(root);
    CHECK(countDifferent(*view.captured->one().colour, *frame) == 0);
    CHECK(countDifferent(picture, *expected) == 0);
}

// Breaks where CaptureVisitor::cull leaves the view's StateSets out.
TEST_CASE("state of the view and of the scene's root does show in the capture")
{
    HarbourView view;
    const osg::ref_ptr<osg::Group> harbour = scenes::createHarbour();
    const osg::ref_ptr<osg::Group> root = scenes::together({harbour});
    osg::ref_ptr<osg::PolygonMode> wires =
        new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK, osg::PolygonMode::LINE);
    SECTION("the camera's StateSet")
    {
        view.camera().getOrCreateStateSet()->setAttribute(wires);
    }
    SECTION("the root's StateSet")
    {
        root->getOrCreateStateSet()->setAttribute(wires);
    }
    SECTION("state that the root's callback pushes")
    {
        osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
        stateSet->setAttribute(wires);
        root->setCullCallback(new PushState(stateSet));
    }
    const osg::ref_ptr<osg::Image> frame = copyOf(view.render(root));
    root->addChild(scenes::createLake());
    view.render(root);
    CHECK(countDifferent(*view.captured->one().colour, *frame) == 0);
}

// Breaks where the plan takes the scale of the first water.
TEST_CASE("the most demanding water sets the capture's size, whichever the view meets first")
{
    HarbourView view;
    const osg::ref_ptr<osg::Group> harbour = scenes::createHarbour();
    const osg::ref_ptr<WaterSurface> coarse = scenes::createLake();
    withScale(*coarse, 0.25);
    view.render(scenes::together({harbour, coarse}));
    CHECK(view.captured->one().colour->s() == 40);
    CHECK(view.captured->one().colour->t() == 30);
    CHECK(view.captured->one().windowZ->s() == 40);

    const osg::ref_ptr<WaterSurface> fine = scenes::createLake(0.8, 8.0);
    withScale(*fine, 0.9);
    ReflectionSettings thick = fine->getReflection();
    thick.thickness = 2.0;
    fine->setReflection(thick);
    const osg::ref_ptr<osg::Image> fineLast =
        copyOf(view.render(scenes::together({harbour, coarse, fine})));
    CHECK(view.captured->one().colour->s() == 144);
    CHECK(view.captured->one().colour->t() == 108);
    const osg::Image& fineFirst = view.render(scenes::together({fine, coarse, harbour}));
    CHECK(view.captured->one().colour->s() == 144);
    CHECK(countDifferent(fineFirst, *fineLast) == 0);
}

// Breaks where CaptureVisitor::cull does not push _stageState: views keep their viewport in their
// StateSet too.
TEST_CASE("a capture at half size is the frame of a view of half the size")
{
    const osg::ref_ptr<osg::Group> harbour = scenes::createHarbour();
    HarbourView smallView(80, 60);
    const osg::ref_ptr<osg::Image> small = copyOf(smallView.render(harbour));

    HarbourView view;
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    withScale(*lake, 0.5);
    view.render(scenes::together({harbour, lake}));
    CHECK(countDifferent(*view.captured->one().colour, *small) == 0);
}

// Breaks where WaterView::isEnrolling is always false.
TEST_CASE("however many waters a view sees, the scene is culled and drawn once more")
{
    HarbourView view;
    const osg::ref_ptr<osg::Group> harbour = scenes::createHarbour();
    const osg::ref_ptr<CountVisits> visits = new CountVisits;
    harbour->setCullCallback(visits);
    const osg::ref_ptr<osg::Group> root = scenes::together({harbour});
    view.render(root);
    REQUIRE(visits->count == 1);
    for (int waters = 1; waters <= 3; ++waters)
    {
        root->addChild(scenes::createLake(0.4 * waters, 60.0 / waters));
        view.render(root); // where new water asks for a wider capture, it is culled twice
        visits->count = 0;
        view.render(root);
        CHECK(visits->count == 2);
        CHECK(view.captured->stages == 6); // and its cells and its sky are computed once
    }
}

// Breaks where WaterSurface::traverse does not ask whether a sheet is culled.
TEST_CASE("water that no view sees costs nothing")
{
    HarbourView view;
    const osg::ref_ptr<osg::Group> harbour = scenes::createHarbour();
    const osg::ref_ptr<CountVisits> visits = new CountVisits;
    harbour->setCullCallback(visits);
    osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    SECTION("behind the eye")
    {
        lake = scenes::inView(WaterSurface::createRectangle(
            osg::Vec3(0, -60, 0), osg::Vec3(10, 0, 0), osg::Vec3(0, 10, 0)));
    }
    SECTION("masked out")
    {
        lake->setNodeMask(0);
    }
    SECTION("masked out for this view only")
    {
        lake->setNodeMask(0x2);
        view.camera().setCullMask(~0x2u);
    }
    SECTION("to the left and to the right of the view, though what bounds both is in it")
    {
        lake = scenes::inView(WaterSurface::createRectangle(
            osg::Vec3(-100, 50, 0), osg::Vec3(10, 0, 0), osg::Vec3(0, 10, 0)));
        const osg::ref_ptr<WaterSurface> right = scenes::inView(WaterSurface::createRectangle(
            osg::Vec3(100, 50, 0), osg::Vec3(10, 0, 0), osg::Vec3(0, 10, 0)));
        lake->addDrawable(right->getDrawable(0));
    }
    view.render(scenes::together({harbour, lake}));
    CHECK(visits->count == 1);
    CHECK(view.captured->stages == 0);
    CHECK(view.captured->images.empty());
}

// Breaks where the capture is traced with the view's projection (in CapturedScene::fitTo
// _clipFromEye = fromOsg(*view.getProjectionMatrix())).
TEST_CASE("near and far of the capture are fitted to the scene, however far the water reaches")
{
    HarbourView view;
    view.camera().attach(osg::Camera::DEPTH_BUFFER, createWindowZTexture(160, 120));
    const osg::ref_ptr<osg::Group> harbour = scenes::createHarbour();
    SECTION("as the view fits its own") {}
    SECTION("or as they are given, where the view does not fit its own")
    {
        view.camera().setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    }
    view.render(harbour);
    const osg::ref_ptr<osg::Image> frameWindowZ = view.captured->frameWindowZ;
    const osg::ref_ptr<osg::Image> reflected =
        copyOf(view.render(scenes::together({harbour, scenes::createLake(0.0, 60.0)})));
    view.render(scenes::together({harbour, scenes::createLake(0.0, 800.0)}));
    CHECK(countDifferent(*view.captured->one().windowZ, *frameWindowZ) == 0);

    // Where both waters are, the larger shows the same. Its float mesh is rasterised anew: a
    // hundredth of the pixels may round another way.
    const osg::Image& picture = view.render(view.viewer().getSceneData());
    int lakePixels = 0;
    int different = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 160; ++x)
        {
            ++lakePixels;
            different += (pixel(picture, x, y) - pixel(*reflected, x, y)).length() > 0.02f;
        }
    CHECK(different <= lakePixels / 100);
}

// Breaks where search_sequential.glsl does not ask for surfaceZ < 1.
TEST_CASE("background is no hit, though the far plane lies just behind the last object")
{
    // A post left of the middle: rays over calm water with an upright camera stay in their column,
    // so whatever hits has the post's columns.
    HarbourView view;
    view.look(osg::Vec3d(0, -10, 2), osg::Vec3d(0, 0, 2));
    const osg::ref_ptr<osg::Node> post =
        scenes::createBox(osg::Vec3(-2, 0, 2), osg::Vec3(1, 1, 4.5), osg::Vec4(1, 1, 1, 1));
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    lake->setDebugView(WaterSurface::DebugView::REASON);
    const osg::Image& picture = view.render(scenes::together({post, lake}));

    // Green is a hit.
    const osg::Vec4 hit(0.1, 0.7, 0.1, 1.0);
    int hits = 0;
    int first = 160;
    int last = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 160; ++x)
            if ((pixel(picture, x, y) - hit).length() < 0.01f)
            {
                ++hits;
                first = std::min(first, x);
                last = std::max(last, x);
            }
    // Front face x in [-2.5, -1.5] at 9.5 m, 60 px / tan 23 degrees a metre at 1 m.
    const double pixelsAtOneMetre = 60.0 / std::tan(23.0 * M_PI / 180.0);
    CHECK(hits > 100);
    CHECK(first >= std::floor(80.0 - 2.5 / 9.5 * pixelsAtOneMetre));
    CHECK(last <= std::ceil(80.0 - 1.5 / 10.5 * pixelsAtOneMetre));
}

// Breaks where Capture::allocate does not call resizeAttachments, or CaptureVisitor::cull does not
// push _stageState.
TEST_CASE("the capture follows the view's viewport from frame to frame")
{
    const osg::ref_ptr<osg::Group> root =
        scenes::together({scenes::createHarbour(), scenes::createLake()});
    HarbourView view(160, 120, OffscreenView::Format::RGBA8);
    const osg::ref_ptr<osg::Image> full = copyOf(view.render(root));
    HarbourView smallView(80, 60, OffscreenView::Format::RGBA8);
    const osg::ref_ptr<osg::Image> small = copyOf(smallView.render(root));

    view.camera().setViewport(0, 0, 80, 60);
    CHECK(countDifferent(view.render(root), *small) == 0);
    CHECK(view.captured->one().colour->s() == 80);
    CHECK(view.captured->one().colour->t() == 60);

    // Even offsets, for mipmaps are chosen by squares of 2 by 2 pixels. The offset moves every
    // coordinate in the window: half a thousandth of the pixels may round another way.
    view.camera().setViewport(38, 22, 80, 60);
    CHECK(countDifferent(view.render(root), *small, 0.004) <= 2);
    CHECK(view.captured->one().colour->s() == 80);

    view.camera().setViewport(0, 0, 160, 120);
    CHECK(countDifferent(view.render(root), *full) == 0);
    CHECK(view.captured->one().colour->s() == 160);

    // The narrowest views there are.
    for (int width : {1, 2, 3})
    {
        view.camera().setViewport(0, 0, width, 1);
        view.render(root);
        CHECK(view.captured->one().colour->s() == width);
        CHECK(view.captured->one().colour->t() == 1);
    }
}

// Breaks where ViewRecord::serves does not ask for the viewport's size.
TEST_CASE("an empty viewport draws no capture and raises no error")
{
    const osg::ref_ptr<osg::Group> root =
        scenes::together({scenes::createHarbour(), scenes::createLake()});
    HarbourView view(160, 120, OffscreenView::Format::RGBA8);
    view.camera().detach(osg::Camera::COLOR_BUFFER); // OSG itself fails to read no pixels back
    for (const auto& size : {std::make_pair(0, 0), std::make_pair(160, 0), std::make_pair(0, 120)})
    {
        view.camera().setViewport(0, 0, size.first, size.second);
        view.render(root);
        CHECK(view.captured->images.empty());
    }
}

// Breaks where Capture::allocate does not take the camera's colour format.
TEST_CASE("colours above 1 are reflected as they are, where the frame can hold them")
{
    HarbourView view;
    view.look(osg::Vec3d(0, -10, 2), osg::Vec3d(0, 0, 0.5));
    const osg::ref_ptr<osg::Node> box =
        scenes::createBox(osg::Vec3(0, 2, 1), osg::Vec3(6, 2, 4), osg::Vec4(1, 1, 1, 1));
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(
        osg::Shader::FRAGMENT,
        "#version 130\nvoid main() { gl_FragColor = vec4(5.0, 1000.0, 0.25, 1.0); }"));
    box->getOrCreateStateSet()->setAttribute(program);
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    lake->setDebugView(WaterSurface::DebugView::REFLECTION);
    const osg::Image& picture = view.render(scenes::together({box, lake}));
    CHECK(view.captured->one().colourFormat == GL_RGBA32F_ARB);

    // The box's reflection stands under its foot, at 11 m from the eye and 2 m below it: row
    // 60 - ... of the middle column; a little lower is well inside.
    const osg::Vec4 reflected = pixel(picture, 80, 45);
    CHECK(reflected.r() == Approx(5.0));
    CHECK(reflected.g() == Approx(1000.0));
    CHECK(reflected.b() == Approx(0.25));
}

// Breaks where ViewRecord::serves refuses a camera that has samples.
TEST_CASE("a multisampled frame reflects as a plain one does, but for its edges")
{
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    const osg::ref_ptr<osg::Group> root = scenes::together({scenes::createHarbour(), lake});
    HarbourView plainView(160, 120, OffscreenView::Format::RGBA8);
    const osg::ref_ptr<osg::Image> plain = copyOf(plainView.render(root));

    HarbourView view(160, 120, OffscreenView::Format::RGBA8);
    osg::ref_ptr<osg::Image> image =
        view.camera().getBufferAttachmentMap()[osg::Camera::COLOR_BUFFER]._image;
    view.camera().detach(osg::Camera::COLOR_BUFFER);
    view.camera().setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    view.camera().attach(osg::Camera::COLOR_BUFFER0, image.get(), 4, 4);
    const osg::Image& picture = view.render(root);
    keep(picture, "multisampled");
    CHECK(view.captured->one().colour->s() == 160);
    // Edges of the harbour, of its chequers and of both their reflections: under a fifth of the
    // picture.
    CHECK(countDifferent(picture, *plain, 0.05) < 160 * 120 / 5);
    CHECK(countDifferent(picture, *plain, 0.0) > 0);
}

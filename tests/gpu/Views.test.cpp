#include "support/CapturedImages.h"
#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osgWaterReflect/offscreen/OffscreenContext.h>

#include <osg/MatrixTransform>
#include <osgViewer/CompositeViewer>

using osgWaterReflect::WaterSurface;

namespace
{

const int WIDTH = 160;
const int HEIGHT = 120;

// The whole window after all of a frame: an image that a camera writes lacks what is drawn after
// that camera, and the other eye.
class Screenshot : public osg::GraphicsOperation
{
public:
    Screenshot() : osg::GraphicsOperation("Screenshot", true), image(new osg::Image)
    {
        image->allocateImage(WIDTH, HEIGHT, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    }
    void operator()(osg::GraphicsContext*) override
    {
        glReadBuffer(GL_FRONT);
        glReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, image->data());
    }
    osg::ref_ptr<osg::Image> image;
};

struct HarbourView : OffscreenView
{
    HarbourView() : OffscreenView(WIDTH, HEIGHT), captured(CapturedImages::of(camera()))
    {
        look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
        camera().getGraphicsContext()->add(_screenshot);
    }
    const osg::Image& render(osg::Node* scene)
    {
        OffscreenView::render(scene);
        return *_screenshot->image;
    }
    osg::ref_ptr<CapturedImages> captured;

private:
    osg::ref_ptr<Screenshot> _screenshot = new Screenshot;
};

class CountDraws : public osg::Camera::DrawCallback
{
public:
    void operator()(osg::RenderInfo&) const override { ++count; }
    mutable int count = 0;
};

osg::ref_ptr<osg::Image> lakePixels(HarbourView& view, osg::Group& root, osg::Node& lake)
{
    const osg::ref_ptr<osg::Node> keepLake = &lake;
    const osg::ref_ptr<osg::Node> plain = scenes::createStandIn();
    root.replaceChild(&lake, plain);
    const osg::ref_ptr<osg::Image> pixels = copyOf(view.render(&root));
    root.replaceChild(plain, &lake);
    return pixels;
}

// A text panel's like: a camera of its own, drawn over the picture.
osg::ref_ptr<osg::Camera> createHud()
{
    osg::ref_ptr<osg::Camera> hud = new osg::Camera;
    hud->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    hud->setProjectionMatrixAsOrtho2D(0, WIDTH, 0, HEIGHT);
    hud->setViewMatrix(osg::Matrixd::identity());
    hud->setRenderOrder(osg::Camera::POST_RENDER);
    hud->setClearMask(GL_DEPTH_BUFFER_BIT);
    hud->setAllowEventFocus(false);
    hud->addChild(scenes::createQuad(osg::Vec3(10, 10, 0), osg::Vec3(40, 0, 0), osg::Vec3(0, 20, 0),
                                     osg::Vec4(1, 1, 0, 1)));
    hud->addChild(scenes::createQuad(osg::Vec3(100, 95, 0), osg::Vec3(40, 0, 0),
                                     osg::Vec3(0, 20, 0), osg::Vec4(0, 1, 1, 1)));
    return hud;
}

// A camera that renders a scene to a texture before the frame.
struct TextureCamera
{
    TextureCamera(int width, int height)
    {
        texture = new osg::Texture2D;
        texture->setTextureSize(width, height);
        texture->setInternalFormat(GL_RGBA8);
        texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
        texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
        camera = new osg::Camera;
        camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
        camera->setRenderOrder(osg::Camera::PRE_RENDER);
        camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
        camera->attach(osg::Camera::COLOR_BUFFER0, texture);
        camera->setViewport(0, 0, width, height);
        camera->setClearColor(osg::Vec4(0.1, 0.3, 0.5, 1));
        camera->setProjectionMatrixAsPerspective(46.0, double(width) / height, 0.1, 1000.0);
        camera->setFinalDrawCallback(draws);
    }

    // An upright panel behind the harbour that shows the texture.
    osg::ref_ptr<osg::Node> createPanel() const
    {
        osg::ref_ptr<osg::Node> panel = scenes::createQuad(
            osg::Vec3(-2, 8, 3), osg::Vec3(4, 0, 0), osg::Vec3(0, 0, 3), osg::Vec4(1, 1, 1, 1));
        panel->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
        return panel;
    }

    osg::ref_ptr<osg::Camera> camera;
    osg::ref_ptr<osg::Texture2D> texture;
    osg::ref_ptr<CountDraws> draws = new CountDraws;
};

// The whole window, filled with a camera's texture: what that camera has rendered.
osg::ref_ptr<osg::Camera> createScreen(osg::Texture2D& texture)
{
    osg::ref_ptr<osg::Camera> screen = new osg::Camera;
    screen->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    screen->setProjectionMatrixAsOrtho2D(0, 1, 0, 1);
    screen->setViewMatrix(osg::Matrixd::identity());
    screen->setRenderOrder(osg::Camera::POST_RENDER);
    osg::ref_ptr<osg::Node> quad = scenes::createQuad(osg::Vec3(), osg::Vec3(1, 0, 0),
                                                      osg::Vec3(0, 1, 0), osg::Vec4(1, 1, 1, 1));
    quad->getOrCreateStateSet()->setTextureAttributeAndModes(0, &texture);
    screen->addChild(quad);
    return screen;
}

// One of several views that share a context.
struct SharedView
{
    SharedView(osg::Camera& camera, osg::GraphicsContext& context) :
        camera(camera), image(new osg::Image)
    {
        image->allocateImage(WIDTH, HEIGHT, 1, GL_RGBA, GL_UNSIGNED_BYTE);
        camera.setGraphicsContext(&context);
        camera.setViewport(0, 0, WIDTH, HEIGHT);
        camera.setDrawBuffer(GL_FRONT);
        camera.setReadBuffer(GL_FRONT);
        camera.attach(osg::Camera::COLOR_BUFFER, image);
        camera.setProjectionMatrixAsPerspective(46.0, double(WIDTH) / HEIGHT, 0.1, 1000.0);
    }
    void look(const osg::Vec3d& eye)
    {
        camera.setViewMatrixAsLookAt(eye, scenes::HARBOUR_CENTRE, osg::Vec3d(0, 0, 1));
    }
    osg::Camera& camera;
    osg::ref_ptr<osg::Image> image;
};

const osg::Vec3d OTHER_EYE(-9.0, -9.0, 5.0);

} // namespace

// Breaks where CaptureVisitor::apply(Camera) culls every camera.
TEST_CASE("head-up displays and textures that the scene renders are drawn once, as without water")
{
    HarbourView view;
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    const osg::ref_ptr<osg::Group> harbour = scenes::createHarbour();
    const osg::ref_ptr<osg::Group> root = scenes::together({harbour, lake});
    const osg::ref_ptr<CountDraws> hudDraws = new CountDraws;
    TextureCamera mirror(64, 48);
    mirror.camera->setViewMatrixAsLookAt(osg::Vec3d(3, -12, 6), osg::Vec3d(0, 0, 1),
                                         osg::Vec3d(0, 0, 1));
    mirror.camera->addChild(scenes::createHarbour());
    const osg::ref_ptr<osg::Camera> hud = createHud();
    hud->setFinalDrawCallback(hudDraws);
    SECTION("below the root, before the scene")
    {
        root->insertChild(0, hud);
        root->insertChild(0, mirror.camera);
        root->addChild(mirror.createPanel());
    }
    SECTION("below the root, after the water")
    {
        root->addChild(mirror.createPanel());
        root->addChild(mirror.camera);
        root->addChild(hud);
    }
    SECTION("deep in the scene")
    {
        harbour->addChild(scenes::together({mirror.camera, mirror.createPanel()}));
        harbour->addChild(scenes::together({hud}));
    }
    const osg::ref_ptr<osg::Image> mask = lakePixels(view, *root, *lake);
    hudDraws->count = 0;
    mirror.draws->count = 0;

    lake->setNodeMask(0);
    const osg::ref_ptr<osg::Image> without = copyOf(view.render(root));
    CHECK(hudDraws->count == 1);
    CHECK(mirror.draws->count == 1);
    lake->setNodeMask(~0u);
    const osg::Image& with = view.render(root);
    CHECK(hudDraws->count == 2);
    CHECK(mirror.draws->count == 2);
    CHECK(view.captured->images.size() == 1);
    CHECK(scenes::countDifferentOutsideStandIn(*mask, with, *without) == 0);
    CHECK(pixel(with, 20, 20).b() == 0.0f); // yellow, or yellow under the harbour's texture
    CHECK(pixel(with, 20, 20).r() > 0.4f);
    CHECK(countDifferent(with, *without) > WIDTH * HEIGHT / 10); // there is water, too
}

// Breaks where CaptureVisitor::cull pushes the view's own matrix object.
TEST_CASE("whatever lights a view has, the scene beside the water is lit as without it")
{
    HarbourView view;
    SECTION("a head light")
    {
        view.viewer().setLightingMode(osg::View::HEADLIGHT);
    }
    SECTION("a sky light")
    {
        view.viewer().setLightingMode(osg::View::SKY_LIGHT);
    }
    SECTION("none but the scene's own")
    {
        view.viewer().setLightingMode(osg::View::NO_LIGHT);
    }
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    const osg::ref_ptr<osg::Group> root = scenes::together({scenes::createHarbour(), lake});
    const osg::ref_ptr<osg::Image> mask = lakePixels(view, *root, *lake);
    lake->setNodeMask(0);
    const osg::ref_ptr<osg::Image> without = copyOf(view.render(root));
    lake->setNodeMask(~0u);
    CHECK(scenes::countDifferentOutsideStandIn(*mask, view.render(root), *without) == 0);
    // The capture is an upright frame buffer object: see the test of a window's capture.
    CHECK(countDifferent(*view.captured->one().colour, *without, 1.01 / 255.0) < 19);
}

// Breaks where ViewRecord::captureFor keeps one capture for all cameras.
TEST_CASE("a camera that renders to a texture has a capture of its own, and the picture of a view")
{
    const osg::ref_ptr<osg::Group> scene =
        scenes::together({scenes::createHarbour(), scenes::createLake()});
    // A head light stays at the outermost view's eye, so the scene is lit by its own lamp alone.
    // The view to compare with is drawn to a frame buffer object of the same format, too.
    scene->getOrCreateStateSet()->setMode(GL_LIGHT0, osg::StateAttribute::OFF);
    OffscreenView alone(WIDTH, HEIGHT);
    const osg::ref_ptr<osg::Image> expected =
        alone.camera().getBufferAttachmentMap()[osg::Camera::COLOR_BUFFER]._image;
    alone.camera().detach(osg::Camera::COLOR_BUFFER);
    alone.camera().setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    alone.camera().attach(osg::Camera::COLOR_BUFFER0, expected.get());
    alone.camera().setClearColor(osg::Vec4(0.1, 0.3, 0.5, 1));
    alone.look(OTHER_EYE, scenes::HARBOUR_CENTRE);
    alone.render(scene);

    HarbourView view;
    TextureCamera nested(WIDTH, HEIGHT);
    nested.camera->setViewMatrixAsLookAt(OTHER_EYE, scenes::HARBOUR_CENTRE, osg::Vec3d(0, 0, 1));
    nested.camera->addChild(scene);
    const osg::ref_ptr<osg::Group> root = scenes::together({nested.camera});
    int captures = 1;
    SECTION("with nothing beside it") {}
    SECTION("with the same water beside it")
    {
        root->addChild(scene);
        captures = 2;
    }
    SECTION("with water before it and after it")
    {
        root->insertChild(0, scenes::createLake(-0.5));
        root->addChild(scene);
        captures = 2;
    }
    SECTION("below another camera that renders to a texture")
    {
        TextureCamera outer(40, 30);
        root->removeChild(nested.camera);
        outer.camera->addChild(nested.camera);
        outer.camera->addChild(scene);
        outer.camera->setViewMatrixAsLookAt(osg::Vec3d(5, -20, 9), osg::Vec3d(),
                                            osg::Vec3d(0, 0, 1));
        root->addChild(outer.camera);
        root->addChild(scene);
        captures = 3;
    }
    root->addChild(createScreen(*nested.texture));
    view.render(root);
    const osg::Image& picture = view.render(root);
    CHECK(static_cast<int>(view.captured->images.size()) == captures);
    CHECK(countDifferent(picture, *expected) == 0);
    CHECK(nested.draws->count == 2);
}

// Breaks where CaptureVisitor::cull leaves out the StateSets of the camera's path, or the lights
// that its stage inherits.
TEST_CASE("state and lights above a camera that renders to a texture apply to its capture")
{
    HarbourView view;
    TextureCamera nested(WIDTH, HEIGHT);
    nested.camera->setViewMatrixAsLookAt(OTHER_EYE, scenes::HARBOUR_CENTRE, osg::Vec3d(0, 0, 1));
    const osg::ref_ptr<osg::Group> harbour = scenes::createHarbour();
    nested.camera->addChild(harbour);
    const osg::ref_ptr<osg::Group> above = scenes::together({nested.camera});
    SECTION("the outer view's head light") {}
    SECTION("none, for state above puts it out")
    {
        above->getOrCreateStateSet()->setMode(GL_LIGHT0, osg::StateAttribute::OFF |
                                                             osg::StateAttribute::OVERRIDE);
    }
    const osg::ref_ptr<osg::Group> root = scenes::together({above, createScreen(*nested.texture)});
    const osg::ref_ptr<osg::Image> without = copyOf(view.render(root));
    nested.camera->addChild(scenes::createLake());
    view.render(root);
    REQUIRE(view.captured->images.size() == 1);
    const osg::Image& capture = *view.captured->one().colour;

    CHECK(countDifferent(capture, *without) == 0);
}

// Breaks where one capture a frame serves all views (ViewRecord::of, captureFor and
// Capture::require).
TEST_CASE("two views of one scene each show what they show alone")
{
    const osg::ref_ptr<osg::Group> scene =
        scenes::together({scenes::createHarbour(), scenes::createLake()});
    HarbourView alone;
    const osg::ref_ptr<osg::Image> first = copyOf(alone.render(scene));
    alone.look(OTHER_EYE, scenes::HARBOUR_CENTRE);
    const osg::ref_ptr<osg::Image> second = copyOf(alone.render(scene));

    const osg::ref_ptr<osg::GraphicsContext> context =
        osgWaterReflect::createOffscreenContext(WIDTH, HEIGHT);
    SECTION("in a CompositeViewer")
    {
        osgViewer::CompositeViewer viewer;
        viewer.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
        osg::ref_ptr<osgViewer::View> viewA = new osgViewer::View;
        osg::ref_ptr<osgViewer::View> viewB = new osgViewer::View;
        SharedView a(*viewA->getCamera(), *context);
        SharedView b(*viewB->getCamera(), *context);
        a.look(scenes::HARBOUR_EYE);
        b.look(OTHER_EYE);
        viewA->setSceneData(scene);
        viewB->setSceneData(scene);
        viewer.addView(viewA);
        viewer.addView(viewB);
        viewer.realize();
        for (int frame = 0; frame < 3; ++frame)
            viewer.frame(0.0);
        CHECK(countDifferent(*a.image, *first) == 0);
        CHECK(countDifferent(*b.image, *second) == 0);
    }
    SECTION("as slaves of one view")
    {
        osgViewer::Viewer viewer;
        viewer.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
        viewer.getCamera()->setViewMatrixAsLookAt(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE,
                                                  osg::Vec3d(0, 0, 1));
        viewer.getCamera()->setProjectionMatrixAsPerspective(46.0, double(WIDTH) / HEIGHT, 0.1,
                                                             1000.0);
        const osg::Matrixd other =
            osg::Matrixd::lookAt(OTHER_EYE, scenes::HARBOUR_CENTRE, osg::Vec3d(0, 0, 1));
        osg::ref_ptr<osg::Camera> cameraA = new osg::Camera;
        osg::ref_ptr<osg::Camera> cameraB = new osg::Camera;
        SharedView a(*cameraA, *context);
        SharedView b(*cameraB, *context);
        viewer.addSlave(cameraA);
        viewer.addSlave(cameraB, osg::Matrixd(),
                        viewer.getCamera()->getInverseViewMatrix() * other);
        viewer.setSceneData(scene);
        viewer.realize();
        for (int frame = 0; frame < 3; ++frame)
            viewer.frame(0.0);
        CHECK(countDifferent(*a.image, *first) == 0);
        // The slave's matrix is a product, whose rounding moves a few edges.
        CHECK(countDifferent(*b.image, *second, 0.01) <= 20);
    }
}

// Breaks where ViewRecord::passFor does not ask for the serial number.
TEST_CASE("one water under two transforms is drawn at both places")
{
    HarbourView view;
    const osg::ref_ptr<osg::Group> harbour = scenes::createHarbour();
    const auto at = [](osg::Node& node, const osg::Vec3d& place)
    {
        osg::ref_ptr<osg::MatrixTransform> transform =
            new osg::MatrixTransform(osg::Matrixd::translate(place));
        transform->addChild(&node);
        return transform;
    };
    const osg::Vec3d left(-5, 0, -0.3);
    const osg::Vec3d right(5, 2, 0.4);
    const osg::ref_ptr<osg::Image> expected = copyOf(view.render(scenes::together(
        {harbour, at(*scenes::createLake(0, 9), left), at(*scenes::createLake(0, 9), right)})));
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake(0, 9);
    const osg::ref_ptr<osg::Group> both =
        scenes::together({harbour, at(*lake, left), at(*lake, right)});
    for (int frame = 0; frame < 3; ++frame)
        CHECK(countDifferent(view.render(both), *expected) == 0);
    const osg::ref_ptr<osg::Image> one =
        copyOf(view.render(scenes::together({harbour, at(*lake, left)})));
    CHECK(countDifferent(*one, *expected) > 100);
}

// Breaks where CaptureVisitor::cull takes the camera's view matrix for the eye's.
TEST_CASE("each eye of a stereo view shows what a view from there shows")
{
    const osg::ref_ptr<osg::Group> scene =
        scenes::together({scenes::createHarbour(), scenes::createLake()});
    osg::ref_ptr<osg::DisplaySettings> settings = new osg::DisplaySettings;
    settings->setStereo(true);
    settings->setStereoMode(osg::DisplaySettings::HORIZONTAL_SPLIT);
    settings->setSplitStereoAutoAdjustAspectRatio(false);
    settings->setSplitStereoHorizontalSeparation(0);
    settings->setEyeSeparation(0.4f); // [m] far apart, to tell
    settings->setScreenDistance(1.0f);

    HarbourView view;
    view.camera().setDisplaySettings(settings);
    view.viewer().setFusionDistance(osgUtil::SceneView::PROPORTIONAL_TO_SCREEN_DISTANCE, 1.0f);
    view.render(scene);
    const osg::ref_ptr<osg::Image> both = copyOf(view.render(scene));

    // As osg::DisplaySettings describes it: the eye moves by half the separation, and the image
    // shears so that what is at the screen's distance stays.
    for (int eye = 0; eye < 2; ++eye)
    {
        const double shift = eye == 0 ? 0.2 : -0.2;
        OffscreenView alone(WIDTH / 2, HEIGHT);
        alone.camera().setViewMatrix(
            osg::Matrixd::lookAt(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE, osg::Vec3d(0, 0, 1)) *
            osg::Matrixd::translate(shift, 0, 0));
        alone.camera().setProjectionMatrix(
            osg::Matrixd(1, 0, 0, 0, 0, 1, 0, 0, shift / 1.0, 0, 1, 0, 0, 0, 0, 1) *
            osg::Matrixd::perspective(46.0, double(WIDTH) / HEIGHT, 0.1, 1000.0));
        const osg::Image& expected = alone.render(scene);
        int different = 0;
        for (int y = 0; y < HEIGHT; ++y)
            for (int x = 0; x < WIDTH / 2; ++x)
                different +=
                    (pixel(*both, x + eye * WIDTH / 2, y) - pixel(expected, x, y)).length() > 0.02f;
        // The matrices are products in another order: a few edges round another way.
        CHECK(different <= 20);
    }
}

// Breaks where the visitors of two frames share a record (ViewRecord::of).
TEST_CASE("all threading models draw the same pictures")
{
    const osg::ref_ptr<osg::Group> scene =
        scenes::together({scenes::createHarbour(), scenes::createLake()});
    HarbourView alone;
    std::vector<osg::ref_ptr<osg::Image>> expected;
    const auto eyeOf = [](int frame)
    { return scenes::HARBOUR_EYE + osg::Vec3d(frame, 0, 0.2 * frame); };
    for (int frame = 0; frame < 4; ++frame)
    {
        alone.look(eyeOf(frame), scenes::HARBOUR_CENTRE);
        expected.push_back(copyOf(alone.render(scene)));
    }
    for (auto model : {osgViewer::ViewerBase::CullDrawThreadPerContext,
                       osgViewer::ViewerBase::DrawThreadPerContext,
                       osgViewer::ViewerBase::CullThreadPerCameraDrawThreadPerContext})
    {
        osgViewer::Viewer viewer;
        const osg::ref_ptr<osg::GraphicsContext> context =
            osgWaterReflect::createOffscreenContext(WIDTH, HEIGHT);
        SharedView view(*viewer.getCamera(), *context);
        viewer.setThreadingModel(model);
        viewer.setSceneData(scene);
        viewer.realize();
        for (int frame = 0; frame < 4; ++frame)
        {
            view.look(eyeOf(frame));
            // The picture may be a frame late: the same frame again, until it must be there.
            for (int again = 0; again < 3; ++again)
                viewer.frame(0.0);
            viewer.stopThreading();
            INFO("threading model " << model << ", frame " << frame);
            CHECK(countDifferent(*view.image, *expected[frame]) == 0);
            viewer.startThreading();
        }
        viewer.setDone(true);
        viewer.stopThreading();
    }
}

// Breaks where Capture::require makes the projection symmetric ((*projection)(2, 0) = 0).
TEST_CASE("the capture is the frame without water in orthographic and off-axis views, too")
{
    OffscreenView view(WIDTH, HEIGHT, OffscreenView::Format::RGBA32F);
    const osg::ref_ptr<CapturedImages> captured = CapturedImages::of(view.camera());
    view.look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
    SECTION("orthographic")
    {
        view.camera().setProjectionMatrixAsOrtho(-8, 8, -6, 6, 0.1, 100);
    }
    SECTION("off-axis")
    {
        view.camera().setProjectionMatrixAsFrustum(-0.02, 0.1, -0.06, 0.03, 0.1, 100);
    }
    const osg::ref_ptr<osg::Group> harbour = scenes::createHarbour();
    const osg::ref_ptr<osg::Image> frame = copyOf(view.render(harbour));
    view.render(scenes::together({harbour, scenes::createLake()}));
    CHECK(countDifferent(*captured->one().colour, *frame) == 0);
}

// Breaks where SheetPass::draw multiplies matrices of world space in single precision.
TEST_CASE("turned, scaled, mirrored, or at the earth's surface, a scene looks as at the origin")
{
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    const osg::ref_ptr<osg::Group> scene = scenes::together(
        {scenes::createBox(osg::Vec3(-3, 3, 1), osg::Vec3(2, 2, 4), osg::Vec4(0.9, 0.4, 0.2, 1)),
         scenes::createBox(osg::Vec3(2, 1, 1.5), osg::Vec3(3, 1, 1), osg::Vec4(0.2, 0.8, 0.4, 1)),
         scenes::createBox(osg::Vec3(4, 6, 1), osg::Vec3(1, 1, 5), osg::Vec4(0.3, 0.3, 0.9, 1)),
         lake});
    HarbourView view;
    const osg::ref_ptr<osg::Image> expected = copyOf(view.render(scene));

    osg::Matrixd worldFromScene;
    double scale = 1.0;
    SECTION("turned")
    {
        worldFromScene.makeRotate(1.1, osg::Vec3d(0.3, -0.5, 0.8));
    }
    SECTION("scaled")
    {
        scale = 7.5;
        worldFromScene.makeScale(scale, scale, scale);
    }
    SECTION("mirrored")
    {
        worldFromScene.makeScale(-1, 1, 1);
        scene->getOrCreateStateSet()->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    }
    SECTION("at the earth's surface")
    {
        worldFromScene.makeTranslate(4.1e6, -3.3e6, 3.6e6);
    }
    SECTION("upright on the earth's surface")
    {
        worldFromScene = osg::Matrixd::rotate(osg::Vec3d(0, 0, 1), osg::Vec3d(0.64, -0.52, 0.56)) *
                         osg::Matrixd::translate(4.1e6, -3.3e6, 3.6e6);
    }
    // Thickness is in world units; it grows with the scene.
    osgWaterReflect::ReflectionSettings settings = lake->getReflection();
    settings.thickness *= scale;
    REQUIRE(lake->setReflection(settings));

    const osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(worldFromScene);
    transform->addChild(scene);
    osg::Matrixd eyeFromScene =
        osg::Matrixd::lookAt(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE, osg::Vec3d(0, 0, 1));
    view.camera().setViewMatrix(osg::Matrixd::inverse(worldFromScene) * eyeFromScene *
                                osg::Matrixd::scale(scale, scale, scale));
    view.camera().setProjectionMatrixAsPerspective(46.0, double(WIDTH) / HEIGHT, 0.1 * scale,
                                                   1000.0 * scale);
    // A double at 6.4e6 m resolves 1e-9 m, and the drawn matrices are of single precision in eye
    // space: edges, of boxes and their reflections, may move by a pixel's fraction.
    CHECK(countDifferent(view.render(transform), *expected, 0.01) <= 40);
}

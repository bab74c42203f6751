// Cameras in the scene beside the water and above it: head-up displays, and those that render to a
// texture, with the state and the lights that they inherit.

#include "support/Catch.h"
#include "support/HarbourWindow.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

using osgWaterReflect::WaterSurface;

namespace
{

const int WIDTH = HarbourWindow::WIDTH;
const int HEIGHT = HarbourWindow::HEIGHT;
const osg::Vec3d& OTHER_EYE = HarbourWindow::OTHER_EYE;

class CountDraws : public osg::Camera::DrawCallback
{
public:
    void operator()(osg::RenderInfo&) const override { ++count; }
    mutable int count = 0;
};

osg::ref_ptr<osg::Image> lakePixels(HarbourWindow& view, osg::Group& root, osg::Node& lake)
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

} // namespace

// Breaks where CaptureVisitor::apply(Camera) culls every camera.
TEST_CASE("head-up displays and textures that the scene renders are drawn once, as without water")
{
    HarbourWindow view;
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
    HarbourWindow view;
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

// Breaks where ViewRecord::waterView keeps one view for all cameras.
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

    HarbourWindow view;
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
    HarbourWindow view;
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

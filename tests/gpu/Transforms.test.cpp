// The matrices between a scene and the window: several transforms above one water, other
// projections, and scenes that lie turned, scaled or far away.

#include "support/CapturedImages.h"
#include "support/Catch.h"
#include "support/HarbourWindow.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osg/MatrixTransform>

using osgWaterReflect::WaterSurface;

namespace
{

const int WIDTH = HarbourWindow::WIDTH;
const int HEIGHT = HarbourWindow::HEIGHT;

} // namespace

// Breaks where WaterView::drawFor does not ask for the serial number.
TEST_CASE("one water under two transforms is drawn at both places")
{
    HarbourWindow view;
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

// Breaks where CapturedScene::fitTo makes the projection symmetric ((*projection)(2, 0) = 0).
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
    view.render(scenes::together({harbour, scenes::withoutBand(scenes::createLake())}));
    CHECK(countDifferent(*captured->one().colour, *frame) == 0);
}

// Breaks where Capture::pixelExtent takes a pixel's extent from clipFromEye[0][0] alone, without
// its sign, or eyePointOf divides by it (Transforms.h).
TEST_CASE("a projection that turns the picture shows the same water, turned")
{
    const osg::ref_ptr<osg::Group> scene = scenes::together(
        {scenes::createBox(osg::Vec3(-3, 3, 1), osg::Vec3(2, 2, 4), osg::Vec4(0.9, 0.4, 0.2, 1)),
         scenes::createBox(osg::Vec3(2, 1, 1.5), osg::Vec3(3, 1, 1), osg::Vec4(0.2, 0.8, 0.4, 1)),
         scenes::createLake()});
    const int size = 120;
    OffscreenView view(size, size, OffscreenView::Format::RGBA32F);
    view.look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
    osg::Matrixd clipFromEye = view.camera().getProjectionMatrix();
    SECTION("orthographic")
    {
        clipFromEye.makeOrtho(-7, 7, -7, 7, 0.1, 100);
    }
    SECTION("perspective") {}

    view.camera().setProjectionMatrix(clipFromEye);
    const osg::ref_ptr<osg::Image> upright = copyOf(view.render(scene));
    const osg::Matrixd halfTurn = osg::Matrixd::scale(-1, -1, 1);
    view.camera().setProjectionMatrix(clipFromEye * halfTurn);
    const osg::ref_ptr<osg::Image> halfTurned = copyOf(view.render(scene));
    const osg::Matrixd quarterTurn(0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    view.camera().setProjectionMatrix(clipFromEye * quarterTurn);
    const osg::ref_ptr<osg::Image> quarterTurned = copyOf(view.render(scene));

    int halfDifferent = 0;
    int quarterDifferent = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
        {
            const osg::Vec4 expected = pixel(*upright, x, y);
            const osg::Vec4 half = pixel(*halfTurned, size - 1 - x, size - 1 - y);
            const osg::Vec4 quarter = pixel(*quarterTurned, size - 1 - y, x);
            halfDifferent += (half - expected).length() > 0.01;
            quarterDifferent += (quarter - expected).length() > 0.01;
        }
    // A point of an edge that lies on a pixel's centre may fall to its other side: a few pixels.
    CHECK(halfDifferent <= 5);
    CHECK(quarterDifferent <= 5);
}

// Breaks where normalMatrix (Transforms.h) returns the matrix itself.
TEST_CASE("unevenly scaled water is the water that its corners make")
{
    const osg::ref_ptr<osg::Group> boxes = scenes::together(
        {scenes::createBox(osg::Vec3(-3, 3, 1), osg::Vec3(2, 2, 4), osg::Vec4(0.9, 0.4, 0.2, 1)),
         scenes::createBox(osg::Vec3(2, 1, 1.5), osg::Vec3(3, 1, 1), osg::Vec4(0.2, 0.8, 0.4, 1))});
    const osg::Matrixd worldFromLocal =
        osg::Matrixd::scale(1.5, 0.8, 0.25) * osg::Matrixd::rotate(0.05, osg::Vec3d(0, 1, 0));
    const osg::Vec3 sides[] = {{30, 0, 0}, {0, 30, 9}};

    const osg::ref_ptr<osg::MatrixTransform> scaled = new osg::MatrixTransform(worldFromLocal);
    scaled->addChild(
        scenes::inView(WaterSurface::createRectangle(osg::Vec3(), sides[0], sides[1])));
    WaterSurface::Outline corners;
    for (const auto& [along, across] :
         {std::pair(-0.5f, -0.5f), {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}})
        corners.push_back((sides[0] * along + sides[1] * across) * worldFromLocal);

    HarbourWindow view;
    const osg::ref_ptr<WaterSurface> made = scenes::inView(WaterSurface::createPolygon(corners));
    const osg::ref_ptr<osg::Image> expected = copyOf(view.render(scenes::together({boxes, made})));
    const osg::ref_ptr<osg::Image> dry = copyOf(view.render(boxes));
    CHECK(countDifferent(*expected, *dry, 0.01) > 2000);
    CHECK(countDifferent(view.render(scenes::together({boxes, scaled})), *expected, 0.01) <= 20);
}

// Breaks where WaterDraw::prepare multiplies matrices of world space in single precision.
TEST_CASE("turned, scaled, mirrored, or at the earth's surface, a scene looks as at the origin")
{
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    const osg::ref_ptr<osg::Group> scene = scenes::together(
        {scenes::createBox(osg::Vec3(-3, 3, 1), osg::Vec3(2, 2, 4), osg::Vec4(0.9, 0.4, 0.2, 1)),
         scenes::createBox(osg::Vec3(2, 1, 1.5), osg::Vec3(3, 1, 1), osg::Vec4(0.2, 0.8, 0.4, 1)),
         scenes::createBox(osg::Vec3(4, 6, 1), osg::Vec3(1, 1, 5), osg::Vec4(0.3, 0.3, 0.9, 1)),
         lake});
    HarbourWindow view;
    const osg::ref_ptr<osg::Image> expected = copyOf(view.render(scene));

    osg::Matrixd worldFromScene;
    double scale = 1.0;
    SECTION("turned")
    {
        worldFromScene.makeRotate(1.1, osg::Vec3d(0.3, -0.5, 0.8));
    }
    SECTION("scaled")
    {
        scale = GENERATE(1e-3, 7.5, 1e6);
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
    INFO("scale " << scale);
    CHECK(countDifferent(view.render(transform), *expected, 0.01) <= 40);
}

// Water below cameras that draw into another's image (NESTED_RENDER) and see the scene their own
// way, beside water of that other view. What must be seen is what a view of its own shows.

#include "support/CapturedImages.h"
#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osgWaterReflect/TrochoidalWaves>

using namespace osgWaterReflect;

namespace
{

const int WIDTH = 160;
const int HEIGHT = 120;

osg::ref_ptr<WaterSurface> createPond(const osg::Vec3& centre, const osg::Vec2& size,
                                      CaptureKind capture, bool moving)
{
    const osg::ref_ptr<WaterSurface> pond =
        WaterSurface::createRectangle(centre, osg::Vec3(size.x(), 0, 0), osg::Vec3(0, size.y(), 0));
    ReflectionSettings settings;
    settings.capture = capture;
    REQUIRE(pond->setReflection(settings));
    if (moving) pond->setWaves(TrochoidalWaves::createBreeze(2.0, 0.05));
    pond->setDebugView(WaterSurface::DebugView::REFLECTION);
    return pond;
}

void setUp(OffscreenView& view)
{
    view.camera().setClearColor(osg::Vec4(0.5, 0.7, 0.9, 1));
    view.look(osg::Vec3d(0, -12, 3), osg::Vec3d(0, 10, 0.5));
}

} // namespace

// Breaks where WaterViews are told apart by the stage's camera alone (sceneCameraOf), or where
// CulledView takes the stage's view matrix for the nested camera's.
TEST_CASE("water below a nested camera reflects what that camera sees")
{
    const auto capture = GENERATE(CaptureKind::AUTOMATIC, CaptureKind::VIEW);
    const bool moving = GENERATE(false, true);
    const bool otherView = GENERATE(true, false);

    OffscreenView view(WIDTH, HEIGHT);
    setUp(view);
    osg::Matrixd viewMatrix = view.camera().getViewMatrix();
    osg::Matrixd projection = view.camera().getProjectionMatrix();
    if (otherView)
        viewMatrix = osg::Matrixd::lookAt(osg::Vec3d(40, -12, 5), osg::Vec3d(40, 10, -2),
                                          osg::Vec3d(0, 0, 1));
    else
        projection = osg::Matrixd::perspective(38, double(WIDTH) / HEIGHT, 0.1, 10000) *
                     osg::Matrixd::translate(-0.1, 0, 0);
    const float x = otherView ? 40.0f : 0.0f;

    const osg::ref_ptr<WaterSurface> inner =
        createPond(osg::Vec3(x + 5, 0, 0), osg::Vec2(10, 20), capture, moving);
    const osg::ref_ptr<osg::Group> objects =
        scenes::together({scenes::createBox(osg::Vec3(x + 4, 12, 2), osg::Vec3(2, 2, 6),
                                            osg::Vec4(0.9, 0.3, 0.2, 1)),
                          scenes::createBox(osg::Vec3(x + 7, 14, 2), osg::Vec3(2, 2, 6),
                                            osg::Vec4(0.9, 0.8, 0.2, 1))});
    const osg::ref_ptr<osg::Camera> nested = new osg::Camera;
    nested->setRenderOrder(osg::Camera::NESTED_RENDER);
    nested->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    nested->setClearMask(0);
    nested->setViewMatrix(viewMatrix);
    nested->setProjectionMatrix(projection);
    nested->addChild(objects);
    nested->addChild(inner);

    const osg::ref_ptr<osg::Group> around =
        scenes::together({scenes::createQuad(osg::Vec3(-30, 25, 0), osg::Vec3(30, 0, 0),
                                             osg::Vec3(0, 0, 6), osg::Vec4(0.2, 0.6, 0.3, 1)),
                          createPond(osg::Vec3(-15, 0, 0), osg::Vec2(30, 30), capture, moving)});
    const osg::ref_ptr<osg::Image> both = copyOf(view.render(scenes::together({around, nested})));

    // The same matrices in a view of its own.
    OffscreenView alone(WIDTH, HEIGHT);
    setUp(alone);
    alone.camera().setViewMatrix(viewMatrix);
    alone.camera().setProjectionMatrix(projection);
    const osg::ref_ptr<osg::Image> expected =
        copyOf(alone.render(scenes::together({objects, inner})));

    // Where both show the nested camera's water: a stand-in of a colour that nothing else has.
    const osg::Vec4 magenta(1, 0, 1, 1);
    const osg::ref_ptr<osg::Node> standIn =
        scenes::createQuad(osg::Vec3(x, -10, 0), osg::Vec3(10, 0, 0), osg::Vec3(0, 20, 0), magenta);
    nested->replaceChild(inner, standIn);
    const osg::ref_ptr<osg::Image> where = copyOf(view.render(scenes::together({around, nested})));
    int water = 0;
    int wrong = 0;
    for (int y = 0; y < HEIGHT; ++y)
        for (int px = 0; px < WIDTH; ++px)
        {
            if ((pixel(*where, px, y) - magenta).length() > 0.01) continue;
            ++water;
            wrong += (pixel(*both, px, y) - pixel(*expected, px, y)).length() > 0.05;
        }
    INFO("capture " << int(capture) << ", moving " << moving << ", other view " << otherView << ": "
                    << wrong << " of " << water << " pixels");
    CHECK(water > 1000);
    CHECK(wrong <= water / 100);
}

// Breaks where a nested camera that changes nothing is taken for a view of its own.
TEST_CASE("water below a nested camera without matrices of its own is its view's")
{
    OffscreenView view(WIDTH, HEIGHT);
    setUp(view);
    const osg::ref_ptr<CapturedImages> captured = CapturedImages::of(view.camera());
    const osg::ref_ptr<osg::Camera> nested = new osg::Camera;
    nested->setRenderOrder(osg::Camera::NESTED_RENDER);
    nested->setClearMask(0);
    nested->addChild(createPond(osg::Vec3(5, 0, 0), osg::Vec2(10, 20), CaptureKind::VIEW, false));
    const osg::ref_ptr<osg::Node> other =
        createPond(osg::Vec3(-5, 0, 0), osg::Vec2(10, 20), CaptureKind::VIEW, false);
    view.render(scenes::together({scenes::createHarbour(), nested, other}));
    CHECK(captured->images.size() == 1);
}

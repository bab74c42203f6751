// Several views of one water: of one scene, of two eyes, of frames that threads draw at once.

#include "support/Catch.h"
#include "support/HarbourWindow.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osgWaterReflect/offscreen/OffscreenContext.h>

#include <osgViewer/CompositeViewer>

namespace
{

const int WIDTH = HarbourWindow::WIDTH;
const int HEIGHT = HarbourWindow::HEIGHT;
const osg::Vec3d& OTHER_EYE = HarbourWindow::OTHER_EYE;

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

} // namespace

// Breaks where one capture a frame serves all views (ViewRecord::of, ViewRecord::waterView).
TEST_CASE("two views of one scene each show what they show alone")
{
    const osg::ref_ptr<osg::Group> scene =
        scenes::together({scenes::createHarbour(), scenes::createLake()});
    HarbourWindow alone;
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

    HarbourWindow view;
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
    HarbourWindow alone;
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

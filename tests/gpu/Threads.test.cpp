// Waters that change from frame to frame in viewers that cull and draw in several threads. Most is
// seen by ThreadSanitizer (tests/sanitize/run.sh).

#include "support/Catch.h"
#include "support/KeepPictures.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/offscreen/OffscreenContext.h>

#include <osg/MatrixTransform>
#include <osgViewer/Viewer>

#include <array>
#include <vector>

using namespace osgWaterReflect;

namespace
{

const int WIDTH = 96;
const int HEIGHT = 72;
const int FRAMES = 12;

using Pictures = std::vector<osg::ref_ptr<osg::Image>>;

// The harbour with a pond and a lake that two cameras see; all of it changes between frames, in the
// way that OSG asks for: what is drawn, and changes by itself, is DYNAMIC.
class ChangingWaters
{
public:
    ChangingWaters() :
        root(new osg::Group), _boat(new osg::MatrixTransform),
        _lake(WaterSurface::createRectangle(osg::Vec3(0, 15, 0), osg::Vec3(60, 0, 0),
                                            osg::Vec3(0, 30, 0))),
        _pond(WaterSurface::createRectangle(osg::Vec3(0, -15, -0.2), osg::Vec3(60, 0, 0),
                                            osg::Vec3(0, 30, 0)))
    {
        _boat->addChild(scenes::createBox(osg::Vec3(0, -5, 0.3), osg::Vec3(1.5, 0.7, 1.0),
                                          osg::Vec4(1, 1, 1, 1)));
        _boat->setDataVariance(osg::Object::DYNAMIC);
        // Where colours change while a thread draws the frame before, pictures differ.
        _sail = new osg::Vec4Array(osg::Array::BIND_OVERALL, 1);
        osg::ref_ptr<osg::Geometry> sail = osg::createTexturedQuadGeometry(
            osg::Vec3(-2, -2, 0.5), osg::Vec3(3, 0, 0), osg::Vec3(0, 0, 2));
        sail->setColorArray(_sail);
        sail->setDataVariance(osg::Object::DYNAMIC);
        sail->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
        _boat->addChild(sail);
        for (const osg::ref_ptr<osg::Node>& node :
             {osg::ref_ptr<osg::Node>(scenes::createHarbour()), osg::ref_ptr<osg::Node>(_boat),
              osg::ref_ptr<osg::Node>(_lake), osg::ref_ptr<osg::Node>(_pond)})
            root->addChild(node);
    }

    void change(int frame)
    {
        _boat->setMatrix(osg::Matrixd::translate(0.4 * frame - 2.0, 0, 0));
        (*_sail)[0] = osg::Vec4(frame % 2, 0.5 * (frame % 3), 0.25 * (frame % 5), 1);
        _sail->dirty();
        changeReflection(frame);
        _lake->setWaves(frame % 3 == 1 ? nullptr : TrochoidalWaves::createBreeze(2.0, 0.1));
        _pond->setWaves(frame % 4 < 2 ? nullptr : TrochoidalWaves::createBreeze(1.0, 0.2));
        if (frame == 5) root->removeChild(_pond);
        if (frame == 7) root->addChild(_pond);
    }

    const osg::ref_ptr<osg::Group> root;

private:
    void changeReflection(int frame)
    {
        const CaptureKind kinds[] = {CaptureKind::AUTOMATIC, CaptureKind::VIEW_AND_MIRROR,
                                     CaptureKind::FRAME, CaptureKind::VIEW, CaptureKind::MIRROR};
        ReflectionSettings settings;
        settings.search = frame % 2 ? Search::HIERARCHICAL : Search::SEQUENTIAL;
        settings.capture = kinds[frame % 5];
        settings.thickness = 0.3 + 0.1 * (frame % 4);
        REQUIRE(_lake->setReflection(settings));
        settings.capture = kinds[(frame + 2) % 5];
        REQUIRE(_pond->setReflection(settings));

        ViewSettings viewSettings;
        viewSettings.traceScale = frame % 3 ? 1.0 : 0.5;
        viewSettings.frameTimeTarget = 1e9; // [ms] never missed: nothing depends on the time
        REQUIRE(_lake->setViewSettings(viewSettings));
        viewSettings.guardBand = frame % 2 ? GuardBandKind::FIXED : GuardBandKind::ADAPTIVE;
        REQUIRE(_pond->setViewSettings(viewSettings));
    }

    osg::ref_ptr<osg::MatrixTransform> _boat;
    osg::ref_ptr<osg::Vec4Array> _sail;
    osg::ref_ptr<WaterSurface> _lake;
    osg::ref_ptr<WaterSurface> _pond;
};

// Two cameras that look at the waters from either side, each with a context of its own or both in
// one; what each has drawn, frame by frame.
std::array<Pictures, 2> draw(osgViewer::ViewerBase::ThreadingModel model, bool ownContexts)
{
    osgViewer::Viewer viewer;
    viewer.setThreadingModel(model);
    viewer.setKeyEventSetsDone(0);
    viewer.getCamera()->setViewMatrix(osg::Matrixd());
    viewer.getCamera()->setProjectionMatrixAsPerspective(46.0, double(WIDTH) / HEIGHT, 0.1, 1000.0);
    osg::ref_ptr<osg::GraphicsContext> context;
    std::array<osg::ref_ptr<KeepPictures>, 2> kept;
    for (int i = 0; i < 2; ++i)
    {
        if (ownContexts || !context) context = createOffscreenContext(WIDTH, HEIGHT);
        const osg::ref_ptr<osg::Camera> camera = new osg::Camera;
        camera->setGraphicsContext(context);
        camera->setViewport(0, 0, WIDTH, HEIGHT);
        camera->setDrawBuffer(GL_FRONT);
        camera->setReadBuffer(GL_FRONT);
        kept[i] = new KeepPictures(WIDTH, HEIGHT);
        camera->setFinalDrawCallback(kept[i]);
        const osg::Vec3d eye(i == 0 ? -5.0 : 6.0, -14.0, 3.5);
        viewer.addSlave(camera, osg::Matrixd(),
                        osg::Matrixd::lookAt(eye, scenes::HARBOUR_CENTRE, osg::Vec3d(0, 0, 1)));
    }
    ChangingWaters waters;
    viewer.setSceneData(waters.root);
    viewer.realize();
    for (int frame = 0; frame < FRAMES; ++frame)
    {
        waters.change(frame);
        viewer.getCamera()->setViewMatrix(osg::Matrixd::translate(0.2 * frame, 0, 0));
        viewer.frame(0.3 * frame);
    }
    viewer.setDone(true);
    viewer.stopThreading(); // all frames are drawn
    for (const auto& each : kept)
        CHECK(each->errors == 0);
    return {kept[0]->pictures, kept[1]->pictures};
}

} // namespace

// Breaks where a camera's frames share a record (ViewRecord::of); under ThreadSanitizer also where
// WaterSurface::remember does not lock.
TEST_CASE("waters that change in each frame are drawn the same by several threads")
{
    const bool ownContexts = GENERATE(false, true);
    const std::array<Pictures, 2> expected =
        draw(osgViewer::ViewerBase::SingleThreaded, ownContexts);
    for (const Pictures& pictures : expected)
    {
        REQUIRE(pictures.size() == FRAMES);
        for (int frame = 1; frame < FRAMES; ++frame) // something is there to compare
            CHECK(countDifferent(*pictures[frame], *pictures[frame - 1]) > WIDTH * HEIGHT / 100);
    }
    for (auto model : {osgViewer::ViewerBase::CullDrawThreadPerContext,
                       osgViewer::ViewerBase::DrawThreadPerContext,
                       osgViewer::ViewerBase::CullThreadPerCameraDrawThreadPerContext})
    {
        const std::array<Pictures, 2> drawn = draw(model, ownContexts);
        for (int camera = 0; camera < 2; ++camera)
        {
            INFO("threading model " << model << ", camera " << camera);
            REQUIRE(drawn[camera].size() == FRAMES);
            for (int frame = 0; frame < FRAMES; ++frame)
            {
                INFO("frame " << frame);
                CHECK(countDifferent(*drawn[camera][frame], *expected[camera][frame]) == 0);
            }
        }
    }
}

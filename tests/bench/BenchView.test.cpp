// What is read back from a frame, and when it was drawn.

#include "support/Catch.h"
#include "support/Scenes.h"

#include <osgWaterReflect/Transforms.h>
#include <osgWaterReflect/offscreen/OffscreenContext.h>

#include <osgwaterbench/experiments/Measurement.h>
#include <osgwaterbench/render/Readback.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

using namespace osgwaterbench;

namespace
{

const glm::ivec2 SIZE(160, 120);
const double WALL = 30.0; // [m] y of a wall across the whole view

// Calm water at z = 0 before a wall, both wider than the view; all of the wall is in the image.
BenchScene wallScene()
{
    BenchScene scene;
    scene.name = "wall";
    scene.scene = new osg::Group;
    scene.scene->addChild(scenes::createQuad(osg::Vec3(-200, WALL, -1), osg::Vec3(400, 0, 0),
                                             osg::Vec3(0, 0, 9), osg::Vec4(0.9, 0.5, 0.2, 1)));
    scene.water = osgWaterReflect::WaterSurface::createRectangle(
        osg::Vec3(0, 0, 0), osg::Vec3(400, 0, 0), osg::Vec3(0, 400, 0));
    scene.water->setSky(new osg::TextureCubeMap);
    scene.eye = osg::Vec3d(0, 0, 2);
    scene.centre = osg::Vec3d(0, 20, 1);
    scene.fovyDegrees = 50.0;
    return scene;
}

} // namespace

// Falls when points are read as normals, or windowZ by another matrix than it was taken with.
TEST_CASE("water that was drawn, and the places that it shows, are read back")
{
    const BenchScene scene = wallScene();
    BenchView view(scene, SIZE, BenchView::Purpose::MEASURE);
    const DrawnWater drawn = readDrawnWater(view);
    const Answers answers = readAnswers(view);
    const glm::dmat4 worldFromEye = glm::inverse(drawn.eyeFromWorld);

    int water = 0;
    int walls = 0;
    for (std::size_t i = 0; i < answers.size(); ++i)
    {
        if (!drawn.isWater[i]) continue;
        ++water;
        const glm::dvec3 point(worldFromEye * glm::dvec4(drawn.pointEye[i], 1.0));
        CHECK(std::abs(point.z) < 1e-4);
        CHECK(glm::length(drawn.normalEye[i] - drawn.stillNormalEye) < 1e-5);
        if (answers[i].sky) continue;
        // The mirrored eye sees the wall along a straight line through the point.
        const glm::dvec3 mirroredEye(0.0, 0.0, -2.0);
        const glm::dvec3 dir = point - mirroredEye;
        const glm::dvec3 place = mirroredEye + dir * (WALL / dir.y);
        // A pixel of the wall, 32 m away, is 0.25 m.
        CHECK(glm::length(answers[i].placeWorld - place) < 0.25);
        CHECK(answers[i].fetches > 1.0f);
        ++walls;
    }
    CHECK(water > 5000);
    CHECK(walls > 1000);
}

// Falls when the answers of one view go through the capture of another, or a replaced piece stays.
TEST_CASE("a scene that screen space shows wholly is measured as right")
{
    const BenchScene scene = wallScene();
    Measurement measurement(scene, nullptr, SIZE);
    const Accuracy own = measurement.measure(libraryMethod("default", searchOfView()));
    const Accuracy sky = measurement.measure(skyOnlyMethod());
    const Accuracy again = measurement.measure(libraryMethod("default", searchOfView()));

    // One of 34 rows lies between the wall's last pixels and its edge, where none shows it.
    CHECK(own.measures.of(TrueClass::VISIBLE).percent(Outcome::CORRECT).value() > 97.0);
    CHECK(own.measures.hitErrorPixels.value().median < 0.01);
    CHECK(own.search.value().disagreedPercent().value() < 0.5);
    CHECK(sky.measures.of(TrueClass::VISIBLE).percent(Outcome::MISSED).value() == 100.0);
    CHECK(!sky.search);
    CHECK(own.picture.rmse < 0.2 * sky.picture.rmse);
    CHECK(again.picture.rmse == own.picture.rmse);
}

// Falls when a stage is marked twice or not at all. The times are those of a software rasteriser,
// so only their order is certain.
TEST_CASE("the stages of a frame are timed")
{
    const BenchScene scene = wallScene();
    BenchView view(scene, SIZE, BenchView::Purpose::TIME);
    const FrameTime own = view.time();
    CHECK(own.image > 0.0);
    CHECK(own.trace > 0.0);
    CHECK(own.frame > own.image + own.trace);

    view.setWaters({});
    const FrameTime without = view.time();
    CHECK(without.image == 0.0);
    CHECK(without.frame > 0.0);
    CHECK(without.trace < own.trace);
}

// Falls when a query is read before it is begun, or in another unit. A software rasteriser may
// stamp all of a frame with its end, so stages may take no time here; but no more than the frame.
TEST_CASE("the stages of a frame are timed by queries, too")
{
    const osg::ref_ptr<StageClock> clock = new StageClock;
    clock->setWay(StageClock::Way::TIMESTAMPS);
    osgViewer::Viewer viewer;
    viewer.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    osg::Camera& camera = *viewer.getCamera();
    camera.setGraphicsContext(osgWaterReflect::createOffscreenContext(SIZE.x, SIZE.y));
    camera.setViewport(0, 0, SIZE.x, SIZE.y);
    camera.setDrawBuffer(GL_FRONT);
    camera.setReadBuffer(GL_FRONT);
    const BenchScene scene = wallScene();
    const osg::ref_ptr<osg::Group> marks = new osg::Group;
    marks->addCullCallback(new NotCaptured);
    marks->addChild(clock->createWaterMark());
    const osg::ref_ptr<osg::Group> root = new osg::Group;
    for (osg::Node* node : {scene.scene->asNode(), marks->asNode(), scene.water->asNode()})
        root->addChild(node);
    camera.setViewMatrixAsLookAt(scene.eye, scene.centre, osg::Vec3d(0, 0, 1));
    camera.setProjectionMatrixAsPerspective(scene.fovyDegrees, 4.0 / 3.0, 0.1, 1000.0);
    viewer.setSceneData(root);
    clock->watchFrame(camera);
    clock->watchImage(camera); // any camera's image may be watched
    viewer.frame();
    clock->start();
    viewer.frame();

    const FrameTime time = clock->read();
    CHECK(time.frame > 0.0);
    CHECK(time.image >= 0.0);
    CHECK(time.image <= time.frame);
    CHECK(time.trace >= 0.0);
    CHECK(time.trace <= time.frame);
}

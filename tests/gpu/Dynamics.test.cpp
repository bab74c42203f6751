// Moving water in viewers that cull and draw in several threads: all views of a frame draw the same
// waves, which are made once.

#include "support/Catch.h"
#include "support/KeepPictures.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"
#include "support/WrappedState.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/offscreen/OffscreenContext.h>

#include <osg/MatrixTransform>
#include <osgViewer/CompositeViewer>

#include <atomic>
#include <map>
#include <mutex>

using namespace osgWaterReflect;

namespace
{

const int WIDTH = 96;
const int HEIGHT = 72;
const int FRAMES = 8;

// A breeze that counts its states: made for each time, and alive.
class CountedWaves : public TrochoidalWaves
{
public:
    CountedWaves()
    {
        const osg::ref_ptr<TrochoidalWaves> breeze = createBreeze(2.0, 0.15);
        setWaves(breeze->getWaves());
    }

    osg::ref_ptr<const WaveState> createState(double time) const override
    {
        const std::lock_guard<std::mutex> lock(mutex);
        ++made[time];
        const osg::ref_ptr<const WaveState> state =
            new State(*TrochoidalWaves::createState(time), alive);
        mostAlive = std::max(mostAlive, alive.load());
        return state;
    }

    mutable std::mutex mutex;
    mutable std::map<double, int> made; // of each time [s]
    mutable std::atomic<int> alive{0};
    mutable int mostAlive = 0;

private:
    class State : public WrappedState
    {
    public:
        State(const WaveState& waves, std::atomic<int>& alive) : WrappedState(waves), _alive(alive)
        {
            ++_alive;
        }
        ~State() override { --_alive; }

    private:
        std::atomic<int>& _alive;
    };
};

// Frames of two views, each in a context of its own, of one scene. What happens between the update
// and the cull of each is left to a function.
template <typename BeforeCull>
std::vector<osg::ref_ptr<osg::Image>> draw(osgViewer::ViewerBase::ThreadingModel model,
                                           osg::Node& scene, const BeforeCull& beforeCull)
{
    osgViewer::CompositeViewer viewer;
    viewer.setThreadingModel(model);
    viewer.setUseConfigureAffinity(false);
    std::vector<osg::ref_ptr<KeepPictures>> kept;
    for (const osg::Vec3d& eye : {osg::Vec3d(-5, -14, 3.5), osg::Vec3d(6, -14, 2.5)})
    {
        const osg::ref_ptr<osgViewer::View> view = new osgViewer::View;
        osg::Camera& camera = *view->getCamera();
        camera.setGraphicsContext(createOffscreenContext(WIDTH, HEIGHT));
        camera.setViewport(0, 0, WIDTH, HEIGHT);
        camera.setDrawBuffer(GL_FRONT);
        camera.setReadBuffer(GL_FRONT);
        camera.setProjectionMatrixAsPerspective(46.0, double(WIDTH) / HEIGHT, 0.1, 1000.0);
        camera.setViewMatrixAsLookAt(eye, scenes::HARBOUR_CENTRE, osg::Vec3d(0, 0, 1));
        kept.push_back(new KeepPictures(WIDTH, HEIGHT));
        camera.setFinalDrawCallback(kept.back());
        view->setSceneData(&scene);
        viewer.addView(view);
    }
    viewer.realize();
    for (int frame = 0; frame < FRAMES; ++frame)
    {
        viewer.advance(0.3 * frame);
        viewer.eventTraversal();
        viewer.updateTraversal();
        beforeCull(0.3 * frame);
        viewer.renderingTraversals();
    }
    viewer.setDone(true);
    viewer.stopThreading(); // all frames are drawn
    std::vector<osg::ref_ptr<osg::Image>> pictures;
    for (const osg::ref_ptr<KeepPictures>& each : kept)
        pictures.insert(pictures.end(), each->pictures.begin(), each->pictures.end());
    return pictures;
}

} // namespace

// Breaks where WaterSurface::traverse does not advance in the update traversal, where
// WaterDynamics::advance makes a state each time that it is asked, and where a view keeps what it
// enrolled until its next cull.
TEST_CASE(
    "waves advance once for each frame, in its update, whatever the threads, views and parents")
{
    std::vector<osg::ref_ptr<osg::Image>> expected;
    for (const auto model :
         {osgViewer::ViewerBase::SingleThreaded, osgViewer::ViewerBase::CullDrawThreadPerContext,
          osgViewer::ViewerBase::DrawThreadPerContext,
          osgViewer::ViewerBase::CullThreadPerCameraDrawThreadPerContext})
    {
        INFO("threading model " << model);
        const osg::ref_ptr<CountedWaves> waves = new CountedWaves;
        std::vector<osg::ref_ptr<osg::Image>> pictures;
        {
            const osg::ref_ptr<WaterSurface> water = WaterSurface::createRectangle(
                osg::Vec3(0, 15, 0), osg::Vec3(60, 0, 0), osg::Vec3(0, 30, 0));
            water->setWaves(waves);
            const osg::ref_ptr<osg::MatrixTransform> nearer =
                new osg::MatrixTransform(osg::Matrixd::translate(0, -30, 0));
            nearer->addChild(water);
            const osg::ref_ptr<osg::Group> scene =
                scenes::together({scenes::createHarbour(), water, nearer});
            pictures = draw(model, *scene, [&](double time) { CHECK(waves->made[time] == 1); });
        }
        REQUIRE(waves->made.size() == FRAMES);
        for (const auto& made : waves->made)
            CHECK(made.second == 1);
        // The one that goes, while the next is made.
        CHECK(waves->mostAlive <= 2);
        CHECK(waves->alive == 0);

        REQUIRE(pictures.size() == 2 * FRAMES);
        if (expected.empty())
        {
            expected = pictures;
            for (int frame = 1; frame < FRAMES; ++frame) // they move
                CHECK(countDifferent(*pictures[frame], *pictures[frame - 1]) > WIDTH * HEIGHT / 50);
        }
        for (std::size_t i = 0; i < pictures.size(); ++i)
        {
            INFO("picture " << i);
            CHECK(countDifferent(*pictures[i], *expected[i]) == 0);
        }
    }
}

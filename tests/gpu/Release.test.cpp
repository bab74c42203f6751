#include "support/CapturedImages.h"
#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"
#include "support/WrappedState.h"

#include <osgWaterReflect/TrochoidalWaves>

#include <algorithm>
#include <memory>

using osgWaterReflect::TrochoidalWaves;
using osgWaterReflect::WaterSurface;

namespace
{

struct HarbourView : OffscreenView
{
    HarbourView() : OffscreenView(160, 120), captured(CapturedImages::of(camera()))
    {
        look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
    }

    osg::State& state() { return *camera().getGraphicsContext()->getState(); }
    osg::ref_ptr<CapturedImages> captured;
};

osg::ref_ptr<osg::TextureCubeMap> createSky()
{
    osg::ref_ptr<osg::TextureCubeMap> sky = new osg::TextureCubeMap;
    for (unsigned int face = 0; face < 6; ++face)
    {
        osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(1, 1, 1, GL_RGB, GL_UNSIGNED_BYTE);
        image->setColor(osg::Vec4(0.2 * face, 1, 0.5, 1), 0, 0);
        sky->setImage(face, image);
    }
    return sky;
}

osg::ref_ptr<TrochoidalWaves> createWaves()
{
    return new TrochoidalWaves;
}

// Calm waves that tell the state which is drawn with them.
class WatchedWaves : public TrochoidalWaves
{
public:
    explicit WatchedWaves(osg::observer_ptr<osg::StateSet>& drawn) : _drawn(drawn) {}

    osg::ref_ptr<const osgWaterReflect::WaveState> createState(double time) const override
    {
        return new State(*TrochoidalWaves::createState(time), _drawn);
    }

private:
    class State : public WrappedState
    {
    public:
        State(const WaveState& waves, osg::observer_ptr<osg::StateSet>& drawn) :
            WrappedState(waves), _drawn(drawn)
        {
        }
        void apply(osg::StateSet& stateSet, const osg::Vec2d& anchor) const override
        {
            WrappedState::apply(stateSet, anchor);
            _drawn = &stateSet;
        }

    private:
        osg::observer_ptr<osg::StateSet>& _drawn;
    };

    osg::observer_ptr<osg::StateSet>& _drawn;
};

// Whether OpenGL has an object for a texture now.
bool isCompiled(const osg::Texture& texture, const osg::State& state)
{
    return texture.getTextureObject(state.getContextID()) != nullptr;
}

} // namespace

// Breaks where WaterSurface::releaseGLObjects does not go through its records.
TEST_CASE("released water holds nothing of OpenGL's, and draws the same again")
{
    HarbourView view;
    const osg::ref_ptr<WaterSurface> calm = scenes::createLake();
    const osg::ref_ptr<WaterSurface> wavy = scenes::createLake(0.8, 6.0);
    calm->setSky(createSky());
    wavy->setWaves(createWaves());
    const osg::ref_ptr<osg::Group> root = scenes::together({scenes::createHarbour(), calm, wavy});
    const osg::ref_ptr<osg::Image> before = copyOf(view.render(root, 3.0));
    const std::vector<osg::ref_ptr<osg::Texture2D>> captured = view.captured->textures;
    REQUIRE(captured.size() == 2);

    SECTION("of every context")
    {
        root->releaseGLObjects(nullptr);
    }
    SECTION("of the view's context")
    {
        root->releaseGLObjects(&view.state());
    }
    for (const osg::ref_ptr<osg::Texture2D>& texture : captured)
        CHECK_FALSE(isCompiled(*texture, view.state()));
    CHECK_FALSE(isCompiled(*calm->getSky(), view.state()));

    CHECK(countDifferent(view.render(root, 3.0), *before) == 0);
    for (const osg::ref_ptr<osg::Texture2D>& texture : captured)
        CHECK(isCompiled(*texture, view.state()));
    CHECK(countDifferent(view.render(root, 3.0), *before) == 0);
}

// A paged tile that expires releases its water while other water is still drawn.
// Breaks where WaterView::release does not ask whether another water is in use.
TEST_CASE("releasing one water leaves the others the capture that they share")
{
    HarbourView view;
    const osg::ref_ptr<WaterSurface> kept = scenes::createLake();
    const osg::ref_ptr<WaterSurface> expired = scenes::createLake(0.8, 6.0);
    const osg::ref_ptr<osg::Group> root =
        scenes::together({scenes::createHarbour(), kept, expired});
    view.render(root);
    root->removeChild(expired);
    expired->releaseGLObjects(nullptr);
    for (const osg::ref_ptr<osg::Texture2D>& texture : view.captured->textures)
        CHECK(isCompiled(*texture, view.state()));
    kept->releaseGLObjects(nullptr);
    for (const osg::ref_ptr<osg::Texture2D>& texture : view.captured->textures)
        CHECK_FALSE(isCompiled(*texture, view.state()));
}

// Nothing breaks it yet that has been tried: OSG's lists grow by themselves when they must. It
// shows that resizing does no harm.
TEST_CASE("water draws the same after its buffers are resized for more contexts")
{
    HarbourView view;
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    lake->setWaves(createWaves());
    const osg::ref_ptr<osg::Group> root = scenes::together({scenes::createHarbour(), lake});
    const osg::ref_ptr<osg::Image> before = copyOf(view.render(root));
    root->resizeGLObjectBuffers(64);
    CHECK(countDifferent(view.render(root), *before) == 0);
}

// Breaks where ViewRecord::of keeps one record for all visitors.
TEST_CASE("a scene outlives its viewer, and draws the same in the next")
{
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    lake->setWaves(createWaves());
    const osg::ref_ptr<osg::Group> root = scenes::together({scenes::createHarbour(), lake});
    osg::ref_ptr<osg::Image> expected;
    std::vector<osg::observer_ptr<osg::Texture2D>> textures;
    for (int viewer = 0; viewer < 3; ++viewer)
    {
        auto view = std::make_unique<HarbourView>();
        const osg::ref_ptr<osg::Image> picture = copyOf(view->render(root));
        if (!expected) expected = picture;
        CHECK(countDifferent(*picture, *expected) == 0);
        for (const osg::ref_ptr<osg::Texture2D>& texture : view->captured->textures)
            textures.push_back(texture.get());
    }
    CHECK(textures.size() == 6);
    for (const osg::observer_ptr<osg::Texture2D>& texture : textures)
        CHECK_FALSE(texture.valid());
    root->releaseGLObjects(nullptr);
}

// Breaks where dropSheetsGone does not remove the passes of dead waters.
TEST_CASE("a viewer outlives its scenes, and holds none of their water")
{
    HarbourView view;
    std::vector<osg::observer_ptr<WaterSurface>> waters;
    for (int scene = 0; scene < 3; ++scene)
    {
        const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
        waters.push_back(lake.get());
        view.render(scenes::together({scenes::createHarbour(), lake}));
    }
    const osg::ref_ptr<WaterSurface> last = scenes::createLake();
    view.render(scenes::together({last}));
    for (const osg::observer_ptr<WaterSurface>& water : waters)
        CHECK_FALSE(water.valid());
    CHECK(view.record().numCaptures() == 1);
    CHECK(view.record().numDraws() == 1);
}

// Breaks where a WaveMesh holds the sheet that it has divided.
TEST_CASE("water whose waves change holds no more than at first")
{
    HarbourView view;
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    const osg::ref_ptr<osg::Group> scene = scenes::together({scenes::createHarbour(), lake});
    for (int i = 0; i < 10; ++i)
    {
        lake->setWaves(i % 3 ? TrochoidalWaves::createBreeze(2.0, 0.1) : nullptr);
        view.render(scene);
    }
    CHECK(view.record().numCaptures() == 1);
    CHECK(view.record().numDraws() == 1);
}

// Breaks where LowResTrace::begin only empties its graph, whose branches hold the sheets' state;
// and where it waits for the next water that is traced in a smaller image.
TEST_CASE("water traced in a smaller image leaves nothing behind when it goes")
{
    const double lastTraceScale = GENERATE(0.5, 1.0);
    HarbourView view;
    osg::observer_ptr<osg::StateSet> drawn; // the first water
    const osg::ref_ptr<osg::Group> scene = scenes::together({scenes::createHarbour()});
    for (int i = 0; i < 3; ++i)
    {
        const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
        osgWaterReflect::ViewSettings settings = lake->getViewSettings();
        settings.traceScale = i < 1 ? 0.5 : lastTraceScale;
        REQUIRE(lake->setViewSettings(settings));
        if (i == 0) lake->setWaves(new WatchedWaves(drawn));
        scene->removeChildren(1, 1);
        scene->addChild(lake);
        view.render(scene);
        if (i == 0) CHECK(drawn.valid());
    }
    CHECK_FALSE(drawn.valid());
}

// Breaks where waterView does not remove the views of dead cameras, or letGo the
// passes of dead waters.
TEST_CASE("nothing piles up where waters and cameras that render to textures come and go")
{
    OffscreenView view(32, 24);
    const osg::ref_ptr<WaterSurface> kept = scenes::createLake();
    const osg::ref_ptr<osg::Node> box =
        scenes::createBox(osg::Vec3(0, 0, 1), osg::Vec3(2, 2, 2), osg::Vec4(1, 1, 1, 1));
    std::size_t mostCaptures = 0;
    std::size_t mostPasses = 0;
    std::vector<osg::observer_ptr<osg::Camera>> cameras;
    std::vector<osg::observer_ptr<WaterSurface>> waters;
    std::vector<osg::ref_ptr<osg::Node>> lately;
    const osg::ref_ptr<osg::Group> root = scenes::together({box, kept});
    for (int frame = 0; frame < 200; ++frame)
    {
        const osg::ref_ptr<WaterSurface> passing = scenes::createLake(0.5, 4.0);
        const osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
        texture->setTextureSize(16, 16);
        texture->setInternalFormat(GL_RGBA8);
        const osg::ref_ptr<osg::Camera> camera = new osg::Camera;
        camera->setRenderOrder(osg::Camera::PRE_RENDER);
        camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
        camera->attach(osg::Camera::COLOR_BUFFER0, texture);
        camera->setViewport(0, 0, 16, 16);
        camera->addChild(kept);
        camera->addChild(box);
        root->addChild(passing);
        root->addChild(camera);
        cameras.push_back(camera.get());
        waters.push_back(passing.get());
        view.render(root);
        root->removeChildren(2, 2);
        // Some live a little longer, or all would follow each other at one address.
        lately.push_back(passing);
        lately.push_back(camera);
        if (lately.size() > 10) lately.erase(lately.begin(), lately.begin() + 2);

        mostCaptures = std::max(mostCaptures, view.record().numCaptures());
        mostPasses = std::max(mostPasses, view.record().numDraws());
    }
    // The view, and the cameras of five frames and of one that the view's render stage has held;
    // for each camera a pass of the lake's, and in the view those of as many passing waters.
    CHECK(mostCaptures <= 1 + 6);
    CHECK(mostPasses <= 7 + 6);
    lately.clear();
    for (int frame = 0; frame < 2; ++frame)
        view.render(scenes::together({box, kept}));
    for (const auto& camera : cameras)
        CHECK_FALSE(camera.valid());
    for (const auto& water : waters)
        CHECK_FALSE(water.valid());
    CHECK(view.record().numCaptures() == 1);
    CHECK(view.record().numDraws() == 1);
}

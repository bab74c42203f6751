// What the scene's own callbacks, and nodes that ask as they do, meet while the water looks at the
// scene.

#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osgWaterReflect/TrochoidalWaves>

#include <osg/OcclusionQueryNode>
#include <osgUtil/CullVisitor>

#include <set>
#include <string>
#include <tuple>

using namespace osgWaterReflect;

namespace
{

// All that callbacks commonly ask a camera, and the visitor or the draw that brings it: where one
// of them is null, a callback that was written for a view without water crashes.
using Answers =
    std::tuple<const osg::View*, const osg::View*, const osg::GraphicsContext*, const osg::State*,
               const osg::Viewport*, const osg::Referenced*, const osg::Referenced*>;

// What a camera answers in each cull that comes to its node.
class AskInCull : public osg::NodeCallback
{
public:
    void operator()(osg::Node* node, osg::NodeVisitor* visitor) override
    {
        osgUtil::CullVisitor& cull = *visitor->asCullVisitor();
        osg::Camera* const camera = cull.getCurrentCamera();
        REQUIRE(camera);
        answers.emplace(camera->getView(), cull.getRenderInfo().getView(),
                        camera->getGraphicsContext(), cull.getState(), camera->getViewport(),
                        camera->getRenderer(), camera->getUserData());
        ++count;
        traverse(node, visitor);
    }
    std::set<Answers> answers;
    int count = 0;
};

// The same where its drawable is drawn; a viewport and a renderer are the cull's alone.
class AskInDraw : public osg::Drawable::DrawCallback
{
public:
    void drawImplementation(osg::RenderInfo& renderInfo,
                            const osg::Drawable* drawable) const override
    {
        const osg::Camera* const camera = renderInfo.getCurrentCamera();
        REQUIRE(camera);
        answers.emplace(camera->getView(), renderInfo.getView(), camera->getGraphicsContext(),
                        renderInfo.getState(), nullptr, nullptr, nullptr);
        CHECK(camera->getViewport());
        drawable->drawImplementation(renderInfo);
    }
    mutable std::set<Answers> answers;
};

osg::ref_ptr<WaterSurface> createAnyLake(CaptureKind capture, bool waves, GuardBandKind band)
{
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    ReflectionSettings settings;
    settings.capture = capture;
    REQUIRE(lake->setReflection(settings));
    ViewSettings viewSettings;
    viewSettings.guardBand = band;
    REQUIRE(lake->setViewSettings(viewSettings));
    if (waves) lake->setWaves(TrochoidalWaves::createBreeze(2.0, 0.1));
    return lake;
}

osg::ref_ptr<WaterSurface> generateLake()
{
    const auto capture = GENERATE(CaptureKind::VIEW, CaptureKind::FRAME, CaptureKind::MIRROR,
                                  CaptureKind::VIEW_AND_MIRROR, CaptureKind::AUTOMATIC);
    const bool waves = GENERATE(false, true);
    const auto band = GENERATE(GuardBandKind::NONE, GuardBandKind::FIXED);
    const osg::ref_ptr<WaterSurface> lake = createAnyLake(capture, waves, band);
    lake->setName("capture " + std::to_string(static_cast<int>(capture)) + ", waves " +
                  std::to_string(waves) + ", band " + std::to_string(static_cast<int>(band)));
    return lake;
}

} // namespace

// Breaks where CaptureCamera::CullScope or CaptureCamera::BeginDraw leaves something out, and
// crashes where the capture's stage has no camera.
TEST_CASE("callbacks of the scene are answered by a capture's camera as by the view's")
{
    OffscreenView view(160, 120);
    view.look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
    view.camera().setUserData(new osg::Referenced);
    const osg::ref_ptr<osg::Node> box =
        scenes::createBox(osg::Vec3(0, 3, 2), osg::Vec3(4, 1, 5), osg::Vec4(1, 1, 1, 1));
    const osg::ref_ptr<AskInCull> inCull = new AskInCull;
    const osg::ref_ptr<AskInDraw> inDraw = new AskInDraw;
    box->setCullCallback(inCull);
    box->asGeode()->getDrawable(0)->setDrawCallback(inDraw);
    box->asGeode()->getDrawable(0)->setUseDisplayList(false);

    view.render(box);
    const std::set<Answers> inView = inCull->answers;
    const std::set<Answers> inViewsDraw = inDraw->answers;
    REQUIRE(inCull->count == 1);
    CHECK(inView.count(Answers(&view.viewer(), &view.viewer(), view.camera().getGraphicsContext(),
                               view.camera().getGraphicsContext()->getState(),
                               view.camera().getViewport(), view.camera().getRenderer(),
                               view.camera().getUserData())) == 1);

    const osg::ref_ptr<WaterSurface> lake = generateLake();
    INFO(lake->getName());
    const osg::ref_ptr<osg::Group> scene = scenes::together({box, lake});
    for (int frame = 0; frame < 3; ++frame)
        view.render(scene);
    // A frame without a band is copied without another cull.
    const bool copiedAsAWhole = lake->getReflection().capture == CaptureKind::FRAME &&
                                lake->getViewSettings().guardBand == GuardBandKind::NONE;
    CHECK((inCull->count > 4) == !copiedAsAWhole);
    CHECK(inCull->answers == inView);
    CHECK(inDraw->answers == inViewsDraw);
}

// A capture that is kept for the next frame keeps no window open. Breaks where
// CaptureCamera::CullScope does not let go at its end, or where CaptureCamera::EndDraw does not.
TEST_CASE("between frames nothing of the water holds the graphics context")
{
    OffscreenView view(160, 120);
    const osg::GraphicsContext& context = *view.camera().getGraphicsContext();
    view.render(scenes::createHarbour());
    const int holders = context.referenceCount();
    const osg::ref_ptr<WaterSurface> lake = generateLake();
    INFO(lake->getName());
    const osg::ref_ptr<osg::Group> scene = scenes::together({scenes::createHarbour(), lake});
    for (int frame = 0; frame < 2; ++frame)
        view.render(scene);
    CHECK(context.referenceCount() == holders);
}

// It asks the current camera for its projection, counts its pixels in a draw callback of that
// camera's, and leaves its children out where there were too few.
TEST_CASE("what is drawn only where an occlusion query has found it is reflected, too")
{
    const osg::ref_ptr<WaterSurface> lake = generateLake();
    INFO(lake->getName());
    const osg::ref_ptr<osg::OcclusionQueryNode> query = new osg::OcclusionQueryNode;
    query->setVisibilityThreshold(20);
    query->setQueryFrameCount(2);
    query->addChild(scenes::createHarbour());
    // The query's box would move near and far.
    OffscreenView plainView(160, 120);
    OffscreenView view(160, 120);
    for (OffscreenView* each : {&plainView, &view})
    {
        each->look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
        each->camera().setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    }
    const osg::Image& plain = plainView.render(scenes::together({scenes::createHarbour(), lake}));
    const osg::ref_ptr<osg::Group> scene = scenes::together({query, lake});
    for (int frame = 0; frame < 12; ++frame)
        CHECK(countDifferent(view.render(scene), plain) == 0);
}

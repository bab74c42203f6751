#include "support/CapturedImages.h"
#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osg/LightSource>
#include <osgShadow/LightSpacePerspectiveShadowMap>
#include <osgShadow/ShadowMap>
#include <osgShadow/ShadowedScene>
#include <osgShadow/ViewDependentShadowMap>

#include <cmath>

using osgWaterReflect::CaptureKind;
using osgWaterReflect::GuardBandKind;
using osgWaterReflect::WaterSurface;

namespace
{

const int CASTS = 0x1;
const int RECEIVES = 0x2;

osg::ref_ptr<osgShadow::ShadowTechnique> createTechnique(const std::string& name)
{
    if (name == "ShadowMap") return new osgShadow::ShadowMap;
    if (name == "LightSpacePerspectiveShadowMapVB")
        return new osgShadow::LightSpacePerspectiveShadowMapVB;
    return new osgShadow::ViewDependentShadowMap;
}

// A ball and a post over a light floor, under a light from above. Two units across, no more: the
// shadow maps are small for the tests' sake.
osg::ref_ptr<osg::Group> createSunlit()
{
    const auto lit = [](const osg::ref_ptr<osg::Node>& node)
    {
        node->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::ON);
        return node;
    };
    const osg::ref_ptr<osg::Group> sunlit = scenes::together(
        {lit(scenes::createBox(osg::Vec3(0, 6, -0.4), osg::Vec3(14, 5, 1), osg::Vec4(1, 1, 1, 1))),
         lit(scenes::createBox(osg::Vec3(-2, 5, 1.6), osg::Vec3(1, 1, 1), osg::Vec4(1, 0.5, 0, 1))),
         lit(scenes::createBox(osg::Vec3(2, 6, 1.3), osg::Vec3(0.5, 0.5, 2),
                               osg::Vec4(0, 0.8, 0.9, 1)))});
    osg::ref_ptr<osg::LightSource> sun = new osg::LightSource;
    sun->getLight()->setPosition(osg::Vec4(0.3, -0.4, 1, 0));
    sunlit->addChild(sun);
    return sunlit;
}

osg::ref_ptr<osgShadow::ShadowedScene> createShadowedScene(const std::string& technique)
{
    osg::ref_ptr<osgShadow::ShadowedScene> shadowed = new osgShadow::ShadowedScene;
    osgShadow::ShadowSettings* settings = shadowed->getShadowSettings();
    settings->setCastsShadowTraversalMask(CASTS);
    settings->setReceivesShadowTraversalMask(RECEIVES);
    settings->setTextureSize(osg::Vec2s(256, 256));
    settings->setNumShadowMapsPerLight(1);
    shadowed->setShadowTechnique(createTechnique(technique));
    return shadowed;
}

struct SunView : OffscreenView
{
    SunView() : OffscreenView(160, 120, Format::RGBA32F), captured(CapturedImages::of(camera()))
    {
        viewer().setLightingMode(osg::View::NO_LIGHT);
        camera().getOrCreateStateSet()->setMode(GL_LIGHT0, osg::StateAttribute::ON);
        look(osg::Vec3d(0, -10, 3), osg::Vec3d(0, 4, 0.5));
    }
    osg::ref_ptr<CapturedImages> captured;
};

// Counts the culls of a depth-only camera that come to a node.
class CountShadowVisits : public osg::NodeCallback
{
public:
    void operator()(osg::Node* node, osg::NodeVisitor* visitor) override
    {
        osgUtil::CullVisitor* view = visitor->asCullVisitor();
        const auto& attachments = view->getCurrentCamera()->getBufferAttachmentMap();
        if (attachments.size() == 1 && attachments.count(osg::Camera::DEPTH_BUFFER))
        {
            ++visits;
            const osgUtil::RenderStage& stage = *view->getCurrentRenderStage();
            traverse(node, visitor);
            captures += stage.getPreRenderList().size();
            leaves += stage.getRenderBinList().count(9); // the water's bin
            return;
        }
        traverse(node, visitor);
    }
    int visits = 0;
    int captures = 0;
    int leaves = 0;
};

} // namespace

// Breaks where CaptureVisitor::cull takes the traversal mask as it finds it, or apply(Camera) skips
// every camera.
TEST_CASE("a shadowed scene is captured with its shadows")
{
    const std::string name = GENERATE("ViewDependentShadowMap", "ShadowMap");
    INFO(name);
    SunView view;
    const osg::ref_ptr<osg::Group> sunlit = createSunlit();
    const osg::ref_ptr<osg::Image> unshadowed = copyOf(view.render(scenes::together({sunlit})));

    const osg::ref_ptr<osgShadow::ShadowedScene> shadowed = createShadowedScene(name);
    shadowed->addChild(sunlit);
    const osg::ref_ptr<osg::Group> root = scenes::together({shadowed});
    view.render(root);
    const osg::ref_ptr<osg::Image> frame = copyOf(view.render(root));
    REQUIRE(countDifferent(*frame, *unshadowed, 0.05) > 30); // there are shadows

    const osg::ref_ptr<WaterSurface> lake = scenes::withoutBand(scenes::createLake());
    SECTION("with water inside")
    {
        lake->setNodeMask(~0u & ~CASTS); // what may cast bounds the shadow map
        shadowed->addChild(lake);
    }
    SECTION("with water beside it")
    {
        root->addChild(lake);
    }
    SECTION("with water beside it, met first")
    {
        root->insertChild(0, lake);
    }
    for (int i = 0; i < 3; ++i)
    {
        view.render(root);
        // The map is fitted to near and far of the frame, of which the water is a part: a
        // texel's depth rounds another way, far less than a step of 8 bits.
        CHECK(countDifferent(*view.captured->one().colour, *frame, 0.001) == 0);
    }
}

// Breaks where ViewRecord::serves does not ask for the camera's attachments.
TEST_CASE("shadow maps show no water, and no capture is made for them")
{
    const std::string name =
        GENERATE("ViewDependentShadowMap", "ShadowMap", "LightSpacePerspectiveShadowMapVB");
    INFO(name);
    SunView view;
    const osg::ref_ptr<osgShadow::ShadowedScene> shadowed = createShadowedScene(name);
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    const osg::ref_ptr<CountShadowVisits> visits = new CountShadowVisits;
    lake->setCullCallback(visits);
    shadowed->addChild(createSunlit());
    shadowed->addChild(lake);
    view.render(shadowed);
    view.render(shadowed);
    CHECK(visits->visits > 0);
    CHECK(visits->captures == 0);
    CHECK(visits->leaves == 0);
    CHECK(view.captured->images.size() == 1);
}

// Breaks (hangs) where CapturedScene::cull culls with the view's own CullVisitor.
// A known limit: this technique fits its map to what it met in the view's cull, and meets the
// capture's in between. Its frame stays right where no water is; its capture has shadows that are
// a little off.
TEST_CASE("light space perspective shadow maps neither crash nor hang beside water")
{
    SunView view;
    const osg::ref_ptr<osg::Group> sunlit = createSunlit();
    const osg::ref_ptr<osgShadow::ShadowedScene> shadowed =
        createShadowedScene("LightSpacePerspectiveShadowMapVB");
    shadowed->addChild(sunlit);
    view.render(shadowed);
    const osg::ref_ptr<osg::Image> frame = copyOf(view.render(shadowed));
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    lake->setNodeMask(~0u & ~CASTS);
    shadowed->addChild(lake);
    for (int i = 0; i < 5; ++i)
        view.render(shadowed);
    const int different = countDifferent(*view.captured->one().colour, *frame, 0.01);
    INFO(different << " pixels of the capture differ");
    CHECK(different < 160 * 120 / 10);
}

// What a second cull does not give, the frame itself has. Breaks where unsteadyShadowsOf does not
// know the technique.
TEST_CASE("a frame with light space perspective shadow maps is reflected with its own shadows")
{
    SunView view;
    const osg::ref_ptr<osg::Group> sunlit = createSunlit();
    const osg::ref_ptr<osgShadow::ShadowedScene> shadowed =
        createShadowedScene("LightSpacePerspectiveShadowMapVB");
    shadowed->addChild(sunlit);
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    lake->setNodeMask(~0u & ~CASTS);
    osgWaterReflect::ReflectionSettings reflection; // automatic
    osgWaterReflect::ViewSettings viewSettings;
    SECTION("asked for")
    {
        reflection.capture = CaptureKind::FRAME;
        viewSettings.guardBand = GuardBandKind::NONE;
    }
    SECTION("by itself") {}
    REQUIRE(lake->setReflection(reflection));
    REQUIRE(lake->setViewSettings(viewSettings));
    const osg::ref_ptr<osg::Image> withStandIn =
        copyOf(view.render(scenes::together({sunlit, scenes::createStandIn()})));
    const osg::ref_ptr<osg::Group> root = scenes::together({shadowed});
    if (GENERATE(true, false))
        shadowed->addChild(lake);
    else
        root->insertChild(0, lake); // beside it, met first
    for (int i = 0; i < 3; ++i)
    {
        const osg::Image& frame = view.render(root);
        REQUIRE(view.captured->one().colour->t() == 120); // no band
        CHECK(scenes::countDifferentOutsideStandIn(*withStandIn, frame,
                                                   *view.captured->one().colour) == 0);
    }
}

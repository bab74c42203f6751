#include <osgWaterReflect/CompileShaders>

#include <osgWaterReflect/TrochoidalWaves>

#include "capture/FrameCopy.h"
#include "capture/MirroredCapture.h"
#include "images/DepthCells.h"
#include "images/SkyImage.h"
#include "view/AccuracySteps.h"
#include "view/AutomaticChoice.h"
#include "water/WaterProgram.h"

#include <osg/GraphicsContext>
#include <osg/NodeVisitor>
#include <osgUtil/SceneView>

#include <algorithm>
#include <cstring>

using namespace osgWaterReflect;

namespace
{

osg::ref_ptr<WaterSurface> createWater()
{
    return WaterSurface::createRectangle(osg::Vec3(), osg::Vec3(4, 0, 0), osg::Vec3(0, 4, 0));
}

osg::ref_ptr<osg::TextureCubeMap> createSky()
{
    const osg::ref_ptr<osg::TextureCubeMap> sky = new osg::TextureCubeMap;
    for (unsigned int face = 0; face < 6; ++face)
    {
        const osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(1, 1, 1, GL_RGB, GL_UNSIGNED_BYTE);
        sky->setImage(face, image);
    }
    return sky;
}

// The same water, but for its shape, with other settings.
osg::ref_ptr<WaterSurface> createLike(const WaterSurface& water, const WaterSettings& settings)
{
    const osg::ref_ptr<WaterSurface> small = new WaterSurface(water);
    small->setNodeMask(~0u);
    small->setUpdateCallback(nullptr);
    small->setCullCallback(nullptr);
    small->removeDrawables(0, small->getNumDrawables());
    small->addDrawable(createWater()->getDrawable(0));
    small->setReflection(settings);
    small->setViewSettings(settings);
    return small;
}

Images imagesFor(const WaterSettings& settings)
{
    return settings.capture == CaptureKind::VIEW_AND_MIRROR ? Images::TWO : Images::ONE;
}

// Of the programs that it is drawn with.
std::vector<ProgramKey> keysOf(const WaterSurface& water)
{
    const WaterSettings settings = settingsAskedFor(water);
    const Images images = imagesFor(settings);
    std::vector<ProgramKey> keys = {
        keyOf(WaterPass::SHADE, water, settings, images, effectsOf(water, EffectView()))};
    if (settings.traceScale < 1.0)
        keys.push_back(keyOf(WaterPass::TRACE, water, settings, images, {}));
    return keys;
}

// What making its captures and their images runs.
std::vector<osg::ref_ptr<osg::Program>> imageProgramsOf(const WaterSurface& water)
{
    const WaterSettings settings = settingsAskedFor(water);
    std::vector<osg::ref_ptr<osg::Program>> programs;
    if (settings.search == Search::HIERARCHICAL) programs = DepthCells::programs();
    if (settings.capture == CaptureKind::FRAME) programs.push_back(FrameCopy::program());
    if (settings.capture == CaptureKind::MIRROR || settings.capture == CaptureKind::VIEW_AND_MIRROR)
        programs.push_back(ImagePass::program(MirroredCapture::STRAIGHTEN));
    if (!water.getSky()) programs.push_back(SkyImage::program());
    return programs;
}

// The waters of a scene, and what decides in it what AUTOMATIC comes to.
class SceneWaters : public osg::NodeVisitor
{
public:
    SceneWaters() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) { setNodeMaskOverride(~0u); }

    void apply(osg::Node& node) override
    {
        _hasShadows = _hasShadows || std::strcmp(node.libraryName(), "osgShadow") == 0;
        if (auto* water = dynamic_cast<WaterSurface*>(&node)) _waters.push_back(water);
        traverse(node);
    }

    const std::vector<WaterSurface*>& waters() const { return _waters; }

    // All that the settings of a water may come to.
    std::vector<WaterSettings> outcomesOf(const WaterSurface& water) const
    {
        std::vector<WaterSettings> outcomes;
        for (const SceneFacts& facts : factsAbout(water))
        {
            const WaterSettings settled = settle(settingsAskedFor(water), facts);
            const auto steps = settled.frameTimeTarget > 0.0 ? accuracySteps(settled)
                                                             : std::vector<WaterSettings>{settled};
            for (const WaterSettings& step : steps)
                if (std::find(outcomes.begin(), outcomes.end(), step) == outcomes.end())
                    outcomes.push_back(step);
        }
        return outcomes;
    }

private:
    static bool isCalm(const WaterSurface& water)
    {
        return !water.getWaves() || water.getWaves()->getMaxSlope() == 0.0;
    }

    // Of all views that it may be in.
    std::vector<SceneFacts> factsAbout(const WaterSurface& water) const
    {
        const bool anyMoves =
            std::any_of(_waters.begin(), _waters.end(),
                        [](const WaterSurface* other) { return !isCalm(*other); });
        std::vector<SceneFacts> all;
        for (const bool calm : {true, false})
            for (const int planes : {1, 2})
                for (const bool bandServes : {true, false})
                    for (const bool redrawsAlike : {true, false})
                    {
                        const bool isPossible = (calm ? isCalm(water) : anyMoves) &&
                                                (planes == 1 || _waters.size() > 1) &&
                                                (redrawsAlike || _hasShadows);
                        if (isPossible) all.push_back({calm, planes, bandServes, redrawsAlike});
                    }
        return all;
    }

    std::vector<WaterSurface*> _waters;
    bool _hasShadows = false;
};

} // namespace

CompileShaders::CompileShaders(const std::vector<Search>& searches) :
    osg::GraphicsOperation("CompileShaders", false)
{
    const osg::ref_ptr<WaterSurface> water = createWater();
    const osg::ref_ptr<osg::TextureCubeMap> sky = createSky();
    const osg::ref_ptr<WaveModel> breeze = TrochoidalWaves::createBreeze(1.0, 0.1);
    for (const bool moving : {false, true})
        for (const bool mapped : {false, true})
            for (const CaptureKind capture : {CaptureKind::VIEW, CaptureKind::VIEW_AND_MIRROR})
                for (const Search search : searches)
                    for (const double traceScale : {1.0, 0.5})
                    {
                        WaterSettings settings;
                        settings.capture = capture;
                        settings.search = search;
                        settings.traceScale = traceScale;
                        water->setWaves(moving ? breeze.get() : nullptr);
                        water->setSky(mapped ? sky.get() : nullptr);
                        add(*createLike(*water, settle(settings, SceneFacts())));
                    }
    WaterSettings ofFrame;
    ofFrame.search = searches.front();
    ofFrame.capture = CaptureKind::FRAME;
    add(*createLike(*createWater(), settle(ofFrame, SceneFacts())));
}

CompileShaders::CompileShaders(osg::Node* scene) : osg::GraphicsOperation("CompileShaders", false)
{
    SceneWaters scenes;
    if (scene) scene->accept(scenes);
    for (const WaterSurface* water : scenes.waters())
        for (const WaterSettings& settings : scenes.outcomesOf(*water))
            add(*createLike(*water, settings));
}

// Unless water of the same programs and captures is there already.
void CompileShaders::add(WaterSurface& water)
{
    const osg::ref_ptr<WaterSurface> held = &water;
    const std::vector<ProgramKey> keys = keysOf(water);
    const CaptureKind capture = water.getReflection().capture;
    const bool known =
        std::any_of(_waters.begin(), _waters.end(),
                    [&](const osg::ref_ptr<WaterSurface>& other) {
                        return other->getReflection().capture == capture && keysOf(*other) == keys;
                    });
    if (known) return;
    _waters.push_back(held);
    for (const ProgramKey& key : keys)
        _programs.push_back(programOf(key));
    for (const osg::ref_ptr<osg::Program>& program : imageProgramsOf(water))
        _programs.push_back(program);
}

// Linking is only a part: drivers leave the rest to the first draw, for the formats and the state
// they meet there. So each water is drawn too, by a view of a few pixels. (Not of a power of two:
// software rasterisers compile code of its own for such textures.)
void CompileShaders::operator()(osg::GraphicsContext* context)
{
    const osg::ref_ptr<osgUtil::SceneView> view = new osgUtil::SceneView;
    view->setDefaults();
    view->setState(context->getState());
    view->setFrameStamp(new osg::FrameStamp);
    view->setViewport(0, 0, 5, 3);
    view->setProjectionMatrixAsPerspective(45.0, 1.0, 0.1, 100.0);
    view->setViewMatrixAsLookAt(osg::Vec3(0, -6, 2), osg::Vec3(), osg::Vec3(0, 0, 1));
    view->init();

    osg::State& state = *context->getState();
    std::vector<ProgramKey> linked;
    for (const osg::ref_ptr<WaterSurface>& water : _waters)
    {
        for (const ProgramKey& key : keysOf(*water))
        {
            if (std::find(linked.begin(), linked.end(), key) != linked.end()) continue;
            linked.push_back(key);
            const osg::ref_ptr<osg::Program> program = programOf(key);
            const osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
            stateSet->setAttributeAndModes(program);
            setVariant(*stateSet, key.images, key.trace, key.output);
            state.apply(stateSet);
            const auto* applied = state.getLastAppliedProgramObject();
            const bool succeeded = applied && applied->getProgram() == program;
            ++(succeeded ? _numCompiled : _numFailed);
        }
        water->getBound();
        view->setSceneData(water);
        view->cull();
        view->draw();
    }
}

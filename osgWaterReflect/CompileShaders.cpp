#include <osgWaterReflect/CompileShaders>

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/WaterSurface>

#include "choice/AutomaticChoice.h"
#include "pyramid/Pyramid.h"
#include "trace/WaterProgram.h"

#include <osg/GraphicsContext>
#include <osgUtil/SceneView>

using namespace osgWaterReflect;

CompileShaders::CompileShaders(const std::vector<Search>& searches) :
    osg::GraphicsOperation("CompileShaders", false)
{
    for (const Search search : searches)
    {
        ReflectionSettings asked;
        asked.search = search;
        _searches.push_back(settle(asked, ViewFacts()).search);
    }
    _waveModels = {nullptr, TrochoidalWaves::createBreeze(1.0, 0.1)};
    for (const osg::ref_ptr<WaveModel>& waves : _waveModels)
    {
        _programs.push_back(waterProgram(waves.get()));
        _programs.push_back(traceProgram(waves.get()));
    }
    for (const osg::ref_ptr<osg::Program>& program : Pyramid::programs())
        _programs.push_back(program);
    _programs.push_back(ImagePass::program(Capture::STRAIGHTEN));
    _programs.push_back(FrameCopy::program());
}

// Linking is only a part: drivers leave the rest to the first draw, for the formats and the state
// they meet there. So each variant is drawn too, as any water is, by a view of a few pixels. (Not
// of a power of two: software rasterisers compile code of its own for such textures.)
void CompileShaders::operator()(osg::GraphicsContext* context)
{
    const osg::ref_ptr<WaterSurface> water =
        WaterSurface::createRectangle(osg::Vec3(), osg::Vec3(4, 0, 0), osg::Vec3(0, 4, 0));
    const osg::ref_ptr<osg::TextureCubeMap> noSky;
    const osg::ref_ptr<osg::TextureCubeMap> sky = new osg::TextureCubeMap;
    for (unsigned int face = 0; face < 6; ++face)
    {
        const osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(1, 1, 1, GL_RGB, GL_UNSIGNED_BYTE);
        sky->setImage(face, image);
    }

    const osg::ref_ptr<osgUtil::SceneView> view = new osgUtil::SceneView;
    view->setDefaults();
    view->setState(context->getState());
    view->setSceneData(water);
    view->setFrameStamp(new osg::FrameStamp);
    view->setViewport(0, 0, 5, 3);
    view->setProjectionMatrixAsPerspective(45.0, 1.0, 0.1, 100.0);
    view->setViewMatrixAsLookAt(osg::Vec3(0, -6, 2), osg::Vec3(), osg::Vec3(0, 0, 1));
    view->init();

    osg::State& state = *context->getState();
    const auto link =
        [&](osg::Program* program, Search search, Images images, SkySource skySource, Trace trace)
    {
        const osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
        stateSet->setAttributeAndModes(program);
        setVariant(*stateSet, search, images, skySource, WaterSurface::DebugView::NONE, trace);
        state.apply(stateSet);
        const osg::Program::PerContextProgram* linked = state.getLastAppliedProgramObject();
        ++(linked && linked->isLinked() ? _numCompiled : _numFailed);
    };
    const auto draw = [&](const ReflectionSettings& settings, const osg::ref_ptr<WaveModel>& waves,
                          const osg::ref_ptr<osg::TextureCubeMap>& cubeMap)
    {
        water->setReflection(settings);
        water->setWaves(waves);
        water->setSky(cubeMap);
        water->getBound();
        view->cull();
        view->draw();
    };
    for (const osg::ref_ptr<WaveModel>& waves : _waveModels)
        for (CaptureKind capture : {CaptureKind::VIEW, CaptureKind::VIEW_AND_MIRROR})
        {
            const Images images = capture == CaptureKind::VIEW ? Images::ONE : Images::TWO;
            ReflectionSettings settings;
            settings.capture = capture;
            for (Search search : _searches)
            {
                settings.search = search;
                link(traceProgram(waves.get()), search, images, SkySource::CAPTURED, Trace::HERE);
                for (const osg::ref_ptr<osg::TextureCubeMap>& cubeMap : {noSky, sky})
                {
                    const SkySource skySource = cubeMap ? SkySource::CUBE_MAP : SkySource::CAPTURED;
                    link(waterProgram(waves.get()), search, images, skySource, Trace::HERE);
                    settings.traceScale = 1.0;
                    draw(settings, waves, cubeMap);
                    // What samples the small image is the same for all searches.
                    if (search == _searches.front())
                        link(waterProgram(waves.get()), search, images, skySource, Trace::SAMPLED);
                    settings.traceScale = 0.5;
                    draw(settings, waves, cubeMap);
                }
            }
        }

    ReflectionSettings ofFrame;
    ofFrame.search = _searches.front();
    ofFrame.capture = CaptureKind::FRAME;
    draw(ofFrame, nullptr, noSky);
}

#include <osgWaterReflect/CompileShaders>

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/WaterSurface>

#include "pyramid/Pyramid.h"
#include "trace/WaterProgram.h"

#include <osg/GraphicsContext>
#include <osgUtil/SceneView>

using namespace osgWaterReflect;

CompileShaders::CompileShaders() : osg::GraphicsOperation("CompileShaders", false)
{
    _waveModels = {nullptr, TrochoidalWaves::createBreeze(1.0, 0.1)};
    for (const osg::ref_ptr<WaveModel>& waves : _waveModels)
        _programs.push_back(waterProgram(waves.get()));
    for (const osg::ref_ptr<osg::Program>& program : Pyramid::programs())
        _programs.push_back(program);
    _programs.push_back(ImagePass::program(Capture::STRAIGHTEN));
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
    for (const osg::ref_ptr<WaveModel>& waves : _waveModels)
        for (Search search : {Search::SEQUENTIAL, Search::BINARY, Search::HIERARCHICAL})
            for (CaptureKind capture : {CaptureKind::VIEW, CaptureKind::VIEW_AND_MIRROR})
                for (const osg::ref_ptr<osg::TextureCubeMap>& cubeMap : {noSky, sky})
                    for (auto debugView :
                         {WaterSurface::DebugView::NONE, WaterSurface::DebugView::REASON,
                          WaterSurface::DebugView::REFLECTION})
                    {
                        const osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
                        stateSet->setAttributeAndModes(waterProgram(waves.get()));
                        setVariant(*stateSet, search,
                                   capture == CaptureKind::VIEW ? Images::ONE : Images::TWO,
                                   cubeMap ? SkySource::CUBE_MAP : SkySource::CAPTURED, debugView);
                        state.apply(stateSet);
                        const osg::Program::PerContextProgram* linked =
                            state.getLastAppliedProgramObject();
                        ++(linked && linked->isLinked() ? _numCompiled : _numFailed);

                        ReflectionSettings settings;
                        settings.search = search;
                        settings.capture = capture;
                        water->setReflection(settings);
                        water->setWaves(waves);
                        water->setSky(cubeMap);
                        water->setDebugView(debugView);
                        water->getBound();
                        view->cull();
                        view->draw();
                    }
}

#include <osgWaterReflect/CompileShaders>

#include <osgWaterReflect/TrochoidalWaves>

#include "trace/WaterProgram.h"

#include <osg/GraphicsContext>

using namespace osgWaterReflect;

CompileShaders::CompileShaders() : osg::GraphicsOperation("CompileShaders", false)
{
    const osg::ref_ptr<TrochoidalWaves> trochoidal = new TrochoidalWaves;
    for (const std::string& waves : {std::string(CALM_SHADER), trochoidal->getShaderName()})
        _programs.push_back(waterProgram(waves));
}

void CompileShaders::operator()(osg::GraphicsContext* context)
{
    osg::State& state = *context->getState();
    for (const osg::ref_ptr<osg::Program>& program : _programs)
        for (Search search : {Search::SEQUENTIAL, Search::BINARY})
            for (SkySource sky : {SkySource::CAPTURED, SkySource::CUBE_MAP})
                for (auto view : {WaterSurface::DebugView::NONE, WaterSurface::DebugView::REASON,
                                  WaterSurface::DebugView::REFLECTION})
                {
                    const osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
                    stateSet->setAttributeAndModes(program.get());
                    setVariant(*stateSet, search, sky, view);
                    state.apply(stateSet.get());
                    const osg::Program::PerContextProgram* compiled =
                        state.getLastAppliedProgramObject();
                    ++(compiled && compiled->isLinked() ? _numCompiled : _numFailed);
                }
    state.apply(new osg::StateSet); // leaves no program of ours in use
}

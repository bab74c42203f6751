#include "WaterProgram.h"

#include "../shaders/Bindings.h"
#include "../shaders/ShaderSource.h"
#include "../shaders/SharedProgram.h"

#include <osg/Notify>

#include <mutex>
#include <set>
#include <string>

using namespace osgWaterReflect;

namespace
{

// Once for each class of wave models.
void warnOfNoPiece(const WaveModel& waves)
{
    static std::mutex mutex;
    static std::set<std::string> warned;
    const std::lock_guard<std::mutex> lock(mutex);
    if (warned.insert(waves.getCompoundClassName()).second)
        OSG_WARN << "WaveModel::getShaderPiece: expected a piece, got null of "
                 << waves.getCompoundClassName() << std::endl;
}

ShaderSlots::Piece wavePiece(const WaterSurface& water)
{
    const WaveModel* waves = water.getWaves();
    if (!waves) return nullptr;
    const ShaderSlots::Piece piece = waves->getShaderPiece();
    if (!piece) warnOfNoPiece(*waves);
    return piece;
}

} // namespace

ShaderSlots::Piece osgWaterReflect::searchPiece(Search search)
{
    static const ShaderSlots::Piece sequential = libraryPiece("search_sequential.glsl");
    static const ShaderSlots::Piece binary = libraryPiece("search_binary.glsl");
    static const ShaderSlots::Piece hierarchical = libraryPiece("search_hierarchical.glsl");
    switch (search)
    {
    case Search::SEQUENTIAL:
        return sequential;
    case Search::BINARY:
        return binary;
    case Search::HIERARCHICAL:
    case Search::AUTOMATIC:
        break;
    }
    return hierarchical;
}

ProgramKey osgWaterReflect::keyOf(WaterPass pass, const WaterSurface& water,
                                  const WaterSettings& settings, Images images,
                                  const std::vector<const Effect*>& effects)
{
    const bool sampled = pass == WaterPass::SHADE && settings.traceScale < 1.0;
    ProgramKey key;
    key.pass = pass;
    key.images = images;
    key.trace = sampled ? Trace::SAMPLED : Trace::HERE;
    key.slots.waves = wavePiece(water);
    // What samples an image of traces searches for nothing: it is one program, not three.
    if (!sampled) key.slots.search = searchPiece(settings.search);
    if (pass == WaterPass::SHADE)
    {
        fillSlots(key.slots, effects);
        key.output = water.getDebugView();
    }
    else if (water.getDebugView() == WaterSurface::DebugView::HIT)
    {
        // It counts its fetches for those who look at them.
        key.output = water.getDebugView();
    }
    return key;
}

osg::ref_ptr<osg::Program> osgWaterReflect::programOf(const ProgramKey& key)
{
    return sharedProgram("water.vert", key.pass == WaterPass::SHADE ? "water.frag" : "trace.frag",
                         key.slots);
}

void osgWaterReflect::setVariant(osg::StateSet& stateSet, Images images, Trace trace,
                                 WaterSurface::DebugView output)
{
    const unsigned int on = osg::StateAttribute::ON | osg::StateAttribute::PROTECTED;
    const auto set = [&](const std::string& name, int value)
    { stateSet.setDefine(name, std::to_string(value), on); };
    set(bindings::DEFINE_IMAGES, static_cast<int>(images));
    set(bindings::DEFINE_TRACE, static_cast<int>(trace));
    set(bindings::DEFINE_OUTPUT, static_cast<int>(output));
}

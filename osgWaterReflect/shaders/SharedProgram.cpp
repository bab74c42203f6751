#include "SharedProgram.h"

#include "ShaderSource.h"

#include <osg/Notify>
#include <osg/State>
#include <osg/observer_ptr>

#include <mutex>
#include <set>
#include <stdexcept>

using namespace osgWaterReflect;

namespace
{

// Once for each name.
void warnOf(const ShaderPiece& waves, const std::string& message)
{
    static std::mutex mutex;
    static std::set<std::string> warned;
    const std::lock_guard<std::mutex> lock(mutex);
    if (warned.insert(waves.getName()).second)
        OSG_WARN << "WaveModel::getShaderPiece: expected a piece that the water's shaders compile "
                 << "with, got " << waves.getName() << ": " << message << std::endl;
}

// Where it does not link, the program of calm water is applied in its place.
class WaveProgram : public osg::Program
{
public:
    WaveProgram(const ShaderSlots::Piece& waves, osg::Program* calm) : _waves(waves), _calm(calm) {}

    void apply(osg::State& state) const override
    {
        osg::Program::apply(state);
        if (state.getLastAppliedProgramObject()) return;
        warnOf(*_waves, "the program does not link");
        _calm->apply(state);
    }

    void releaseGLObjects(osg::State* state) const override
    {
        osg::Program::releaseGLObjects(state);
        _calm->releaseGLObjects(state);
    }

    void resizeGLObjectBuffers(unsigned int maxSize) override
    {
        osg::Program::resizeGLObjectBuffers(maxSize);
        _calm->resizeGLObjectBuffers(maxSize);
    }

private:
    const ShaderSlots::Piece _waves;
    const osg::ref_ptr<osg::Program> _calm;
};

// What a program is made of.
struct Recipe
{
    const std::string& vertex;
    const std::string& fragment;
    const ShaderSlots& slots;
};

std::vector<ShaderSlots::Piece> piecesOf(const ShaderSlots& slots)
{
    std::vector<ShaderSlots::Piece> pieces;
    for (const char* slot : {"waves", "search", "sky", "body", "over"})
    {
        const std::vector<ShaderSlots::Piece> in = slots.in(slot);
        pieces.insert(pieces.end(), in.begin(), in.end());
    }
    return pieces;
}

void fill(osg::Program& program, const Recipe& recipe)
{
    program.addShader(
        new osg::Shader(osg::Shader::VERTEX, assembleShader(recipe.vertex, recipe.slots)));
    program.addShader(
        new osg::Shader(osg::Shader::FRAGMENT, assembleShader(recipe.fragment, recipe.slots)));
    std::string name = "osgWaterReflect " + recipe.fragment;
    for (const ShaderSlots::Piece& piece : piecesOf(recipe.slots))
        name += " " + piece->getName();
    program.setName(name);
}

// All programs that somebody holds.
class Programs
{
public:
    osg::ref_ptr<osg::Program> of(const Recipe& recipe)
    {
        std::string key = recipe.vertex + " " + recipe.fragment + " " + ShaderReplacement::all();
        for (const ShaderSlots::Piece& piece : piecesOf(recipe.slots))
            key += piece->getName() + " " + piece->getText();
        osg::ref_ptr<osg::Program> program;
        if (_programs[key].lock(program)) return program;

        const ShaderSlots::Piece& waves = recipe.slots.waves;
        const bool fromOutside = waves && embeddedShaders.count(waves->getName()) == 0;
        program = fromOutside ? createWithWaves(recipe) : create(recipe);
        _programs[key] = program;
        return program;
    }

    void forgetDropped()
    {
        for (auto it = _programs.begin(); it != _programs.end();)
            it = it->second.valid() ? std::next(it) : _programs.erase(it);
    }

private:
    static osg::ref_ptr<osg::Program> create(const Recipe& recipe)
    {
        const osg::ref_ptr<osg::Program> program = new osg::Program;
        fill(*program, recipe);
        return program;
    }

    // Of calm water, where the waves cannot be put together with it.
    osg::ref_ptr<osg::Program> createWithWaves(const Recipe& recipe)
    {
        ShaderSlots calmSlots = recipe.slots;
        calmSlots.waves = nullptr;
        const osg::ref_ptr<osg::Program> calm = of({recipe.vertex, recipe.fragment, calmSlots});
        const osg::ref_ptr<osg::Program> program = new WaveProgram(recipe.slots.waves, calm);
        try
        {
            fill(*program, recipe);
            return program;
        }
        catch (const std::runtime_error& error)
        {
            warnOf(*recipe.slots.waves, error.what());
            return calm;
        }
    }

    std::map<std::string, osg::observer_ptr<osg::Program>> _programs;
};

} // namespace

osg::ref_ptr<osg::Program> osgWaterReflect::sharedProgram(const std::string& vertex,
                                                          const std::string& fragment,
                                                          const ShaderSlots& slots)
{
    static std::mutex mutex;
    static Programs programs;
    const std::lock_guard<std::mutex> lock(mutex);
    programs.forgetDropped();
    return programs.of({vertex, fragment, slots});
}

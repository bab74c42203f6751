// Which effects a water calls for, and what they leave behind where it does not.

#include "support/Catch.h"
#include "support/ListedEffect.h"
#include "support/Refusals.h"
#include "support/WholeFile.h"
#include "support/mist/Mist.h"

#include <osgWaterReflect/shaders/ShaderSource.h>
#include <osgWaterReflect/water/WaterProgram.h>

#include <osg/Texture2D>

#include <algorithm>
#include <string>
#include <vector>

using namespace osgWaterReflect;

namespace
{

osg::ref_ptr<WaterSurface> createWater()
{
    return WaterSurface::createRectangle(osg::Vec3(), osg::Vec3(4, 0, 0), osg::Vec3(0, 4, 0));
}

std::vector<std::string> namesFor(const WaterSurface& water)
{
    std::vector<std::string> names;
    for (const Effect* effect : effectsOf(water, EffectView()))
        names.push_back(effect->getName());
    return names;
}

// Vertex and fragment shader.
std::string textFor(const WaterSurface& water)
{
    const ProgramKey key = keyOf(WaterPass::SHADE, water, settingsAskedFor(water), Images::ONE,
                                 effectsOf(water, EffectView()));
    return assembleShader("water.vert", key.slots) + assembleShader("water.frag", key.slots);
}

const char* whyNot(const char* name, const WaterSurface& water)
{
    for (const auto& effect : effectList())
        if (std::string(effect->getName()) == name)
            return effect->calledFor(water, EffectView()).whyNot;
    FAIL("no effect " << name);
    return nullptr;
}

// Takes the body's place.
class BlackWater : public Mist
{
public:
    CalledFor calledFor(const WaterSurface&, const EffectView&) const override { return {}; }
    const char* getName() const override { return "black water"; }
    Slot getSlot() const override { return Slot::BODY; }
};

} // namespace

// Falls when SkyCubeMap is called for without a cube map, or an earlier effect keeps its slot.
TEST_CASE("water calls for effects by what it is given, and what it does not it can tell why")
{
    const osg::ref_ptr<WaterSurface> water = createWater();
    CHECK(namesFor(*water) == std::vector<std::string>{"water colour"});
    CHECK(std::string(whyNot("sky cube map", *water)) == "the water is given no cube map");
    CHECK(whyNot("water colour", *water) == nullptr);

    water->setSky(new osg::TextureCubeMap);
    CHECK(namesFor(*water) == std::vector<std::string>{"water colour", "sky cube map"});
    CHECK(whyNot("sky cube map", *water) == nullptr);

    const ListedEffect<BlackWater> black;
    CHECK(namesFor(*water) == std::vector<std::string>{"sky cube map", "black water"});
    const ListedEffect<Mist> mist;
    water->setUserValue("mist", 0.5f);
    CHECK(namesFor(*water) == std::vector<std::string>{"sky cube map", "black water", "mist"});
}

// Falls when fillSlots() puts in pieces that are not called for.
TEST_CASE("an effect that is not called for leaves the program byte for byte as without it")
{
    const osg::ref_ptr<WaterSurface> water = createWater();
    const std::string without = textFor(*water);
    const ListedEffect<Mist> mist;
    CHECK(textFor(*water) == without);
    water->setUserValue("mist", 0.5f);
    CHECK(textFor(*water).find("mist(pixel, colour);") != std::string::npos);
    water->setUserValue("mist", 0.0f);
    CHECK(textFor(*water) == without);

    // As without the folder: what is not called for is nowhere in the text.
    CHECK(without.find("mist") == std::string::npos);
    CHECK(without.find("skyCubeMap") == std::string::npos);
    CHECK(without.find("sky_cube_map") == std::string::npos);
}

// Falls when update() keeps the state set of other effects.
TEST_CASE("an effect that is no longer called for leaves no uniform and no texture")
{
    const osg::ref_ptr<WaterSurface> water = createWater();
    const ListedEffect<Mist> mist;
    const auto numUniforms = [](const EffectState& state)
    { return state.stateSet()->getUniformList().size(); };
    EffectState state;
    state.update(effectsOf(*water, EffectView()), *water, EffectView());
    CHECK(numUniforms(state) == 1);
    CHECK(state.stateSet()->getTextureAttributeList().empty());

    water->setUserValue("mist", 0.5f);
    water->setSky(new osg::TextureCubeMap);
    state.update(effectsOf(*water, EffectView()), *water, EffectView());
    CHECK(numUniforms(state) == 4);
    CHECK(state.stateSet()->getUniform("osgwr_mistShare"));
    CHECK(state.stateSet()->getTextureAttribute(bindings::UNIT_EFFECTS,
                                                osg::StateAttribute::TEXTURE) == water->getSky());
    // In a frame with the same effects nothing is made anew.
    const osg::ref_ptr<osg::StateSet> before = state.stateSet();
    state.update(effectsOf(*water, EffectView()), *water, EffectView());
    CHECK(state.stateSet() == before);

    water->setUserValue("mist", 0.0f);
    water->setSky(nullptr);
    state.update(effectsOf(*water, EffectView()), *water, EffectView());
    CHECK(numUniforms(state) == 1);
    CHECK(state.stateSet()->getTextureAttributeList().empty());
}

// Falls when either is changed alone.
TEST_CASE("docs/extending.md has the effect word for word")
{
    const std::string header = wholeFile("tests/support/mist/Mist.h");
    const std::size_t first = header.find("#include <osgWaterReflect/effects/Effect.h>");
    const std::size_t last = header.rfind("};\n") + 3;
    REQUIRE(first < last);
    const std::string quoted = "```cpp\n" + header.substr(first, last - first) + "```\n";
    CHECK(wholeFile("docs/extending.md").find(quoted) != std::string::npos);
}

namespace
{

// More textures than there are units.
class ManyTextures : public Mist
{
public:
    void apply(EffectState& state, const WaterSurface&, const EffectView&) const override
    {
        for (int i = 0; i < 7; ++i)
            state.setTexture("osgwr_many" + std::to_string(i), new osg::Texture2D);
    }
};

} // namespace

// Breaks where takeUnits() always says yes.
TEST_CASE("an effect that asks for more texture units than there are is refused the rest, by name")
{
    const ManyTextures effect;
    const osg::ref_ptr<WaterSurface> water = createWater();
    EffectState state;
    Refusals refusals;
    for (int frame = 0; frame < 3; ++frame)
    {
        state.update({&effect}, *water, EffectView());
        CHECK((refusals.take().find("osgwr_many5") != std::string::npos) == (frame == 0));
    }
    const osg::StateSet& stateSet = *state.stateSet();
    for (unsigned int unit = 0; unit < 20; ++unit)
        CHECK((stateSet.getTextureAttribute(unit, osg::StateAttribute::TEXTURE) != nullptr) ==
              (unit >= 9 && unit < 14));
    CHECK(stateSet.getUniform("osgwr_many4"));
    CHECK_FALSE(stateSet.getUniform("osgwr_many5"));
}

#ifndef OSGWATERREFLECT_TESTS_SUPPORT_MIST_MIST_H
#define OSGWATERREFLECT_TESTS_SUPPORT_MIST_MIST_H

// The effect of docs/extending.md, which has it word for word from here on.
#include <osgWaterReflect/effects/Effect.h>

#include <osg/ValueObject>

/// White mist on the water: how much of it hides what is below, [0, 1], is the water's user value
/// "mist".
class Mist : public osgWaterReflect::Effect
{
public:
    const char* getName() const override { return "mist"; }

    osgWaterReflect::CalledFor calledFor(const osgWaterReflect::WaterSurface& water,
                                         const osgWaterReflect::EffectView&) const override
    {
        return {shareOf(water) > 0.0f ? nullptr : "the water has no mist"};
    }

    Slot getSlot() const override { return Slot::OVER; }

    const osgWaterReflect::ShaderPiece* getShaderPiece() const override
    {
        static const osg::ref_ptr<const osgWaterReflect::ShaderPiece> piece =
            new osgWaterReflect::ShaderPiece("mist.glsl", R"glsl(
uniform float osgwr_mistShare;

vec3 mist(WaterPixel pixel, vec3 colour)
{
    return mix(colour, vec3(1.0), osgwr_mistShare);
}
)glsl");
        return piece;
    }

    void apply(osgWaterReflect::EffectState& state, const osgWaterReflect::WaterSurface& water,
               const osgWaterReflect::EffectView&) const override
    {
        state.set("osgwr_mistShare", shareOf(water));
    }

private:
    static float shareOf(const osgWaterReflect::WaterSurface& water)
    {
        float share = 0.0f;
        water.getUserValue("mist", share);
        return share;
    }
};

#endif

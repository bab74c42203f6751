#ifndef OSGWATERREFLECT_TESTS_SUPPORT_GLASS_GLASS_H
#define OSGWATERREFLECT_TESTS_SUPPORT_GLASS_GLASS_H

#include <osgWaterReflect/effects/Effect.h>

#include <osg/ValueObject>

/// Water without a colour of its own, through which the scene is seen as through the air: where the
/// water's user value "glass" is true.
class Glass : public osgWaterReflect::Effect
{
public:
    const char* getName() const override { return "glass"; }

    osgWaterReflect::CalledFor calledFor(const osgWaterReflect::WaterSurface& water,
                                         const osgWaterReflect::EffectView&) const override
    {
        bool glass = false;
        water.getUserValue("glass", glass);
        return {glass ? nullptr : "the water is no glass"};
    }

    bool looksAtScene() const override { return true; }
    Slot getSlot() const override { return Slot::BODY; }

    const osgWaterReflect::ShaderPiece* getShaderPiece() const override
    {
        static const osg::ref_ptr<const osgWaterReflect::ShaderPiece> piece =
            new osgWaterReflect::ShaderPiece("glass.glsl", R"glsl(
uniform Capture osgwr_glassScene;

vec3 bodyColour(WaterPixel pixel)
{
    vec4 image = osgwr_glassScene.imageFromEye * vec4(pixel.point, 1.0);
    vec2 place = (0.5 * image.xy / image.w + 0.5) * osgwr_glassScene.size;
    return texelFetch(osgwr_glassScene.colour, ivec2(place), 0).rgb;
}
)glsl");
        return piece;
    }

    void apply(osgWaterReflect::EffectState& state, const osgWaterReflect::WaterSurface&,
               const osgWaterReflect::EffectView& view) const override
    {
        state.setCapture("osgwr_glassScene", *view.scene);
    }
};

#endif

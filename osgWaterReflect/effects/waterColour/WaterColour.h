#ifndef OSGWATERREFLECT_EFFECTS_WATERCOLOUR_WATERCOLOUR_H
#define OSGWATERREFLECT_EFFECTS_WATERCOLOUR_WATERCOLOUR_H

#include "../Effect.h"

namespace osgWaterReflect
{

/// What the water does not reflect has the colour of WaterOptics, wherever it is looked into
/// [LiLuo].
class WaterColour : public Effect
{
public:
    const char* getName() const override { return "water colour"; }
    CalledFor calledFor(const WaterSurface&, const EffectView&) const override { return {}; }
    Slot getSlot() const override { return Slot::BODY; }
    const ShaderPiece* getShaderPiece() const override;
    void apply(EffectState& state, const WaterSurface& water,
               const EffectView& view) const override;
};

} // namespace osgWaterReflect

#endif

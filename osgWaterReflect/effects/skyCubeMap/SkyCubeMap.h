#ifndef OSGWATERREFLECT_EFFECTS_SKYCUBEMAP_SKYCUBEMAP_H
#define OSGWATERREFLECT_EFFECTS_SKYCUBEMAP_SKYCUBEMAP_H

#include "../Effect.h"

namespace osgWaterReflect
{

/// Rays that meet nothing see the cube map that WaterSurface::setSky was given.
class SkyCubeMap : public Effect
{
public:
    const char* getName() const override { return "sky cube map"; }
    CalledFor calledFor(const WaterSurface& water, const EffectView& view) const override;
    Slot getSlot() const override { return Slot::SKY; }
    const ShaderPiece* getShaderPiece() const override;
    void apply(EffectState& state, const WaterSurface& water,
               const EffectView& view) const override;
};

} // namespace osgWaterReflect

#endif

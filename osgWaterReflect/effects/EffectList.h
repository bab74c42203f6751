#ifndef OSGWATERREFLECT_EFFECTS_EFFECTLIST_H
#define OSGWATERREFLECT_EFFECTS_EFFECTLIST_H

#include "Effect.h"

#include "../shaders/ShaderSlots.h"

#include <memory>
#include <vector>

namespace osgWaterReflect
{

/// All effects, in the order in which they are put into a slot. It is not to be changed while water
/// is drawn.
std::vector<std::shared_ptr<const Effect>>& effectList();

/// The effects that are seen of water in a view, in that order: what it calls for; but sky and body
/// are each the last one's alone.
std::vector<const Effect*> effectsOf(const WaterSurface& water, const EffectView& view);

/// Puts the pieces of effects into their slots.
void fillSlots(ShaderSlots& slots, const std::vector<const Effect*>& effects);

} // namespace osgWaterReflect

#endif

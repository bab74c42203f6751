#include "EffectList.h"

#include "skyCubeMap/SkyCubeMap.h"
#include "waterColour/WaterColour.h"

#include <algorithm>

using namespace osgWaterReflect;

std::vector<std::shared_ptr<const Effect>>& osgWaterReflect::effectList()
{
    static std::vector<std::shared_ptr<const Effect>> list = {
        std::make_shared<WaterColour>(),
        std::make_shared<SkyCubeMap>(),
    };
    return list;
}

std::vector<const Effect*> osgWaterReflect::effectsOf(const WaterSurface& water,
                                                      const EffectView& view)
{
    std::vector<const Effect*> effects;
    for (const std::shared_ptr<const Effect>& effect : effectList())
    {
        if (!effect->calledFor(water, view)) continue;
        const auto inItsPlace = [&](const Effect* earlier) {
            return effect->getSlot() != Effect::Slot::OVER &&
                   earlier->getSlot() == effect->getSlot();
        };
        effects.erase(std::remove_if(effects.begin(), effects.end(), inItsPlace), effects.end());
        effects.push_back(effect.get());
    }
    return effects;
}

void osgWaterReflect::fillSlots(ShaderSlots& slots, const std::vector<const Effect*>& effects)
{
    for (const Effect* effect : effects)
        switch (effect->getSlot())
        {
        case Effect::Slot::SKY:
            slots.sky = effect->getShaderPiece();
            break;
        case Effect::Slot::BODY:
            slots.body = effect->getShaderPiece();
            break;
        case Effect::Slot::OVER:
            slots.over.push_back(effect->getShaderPiece());
            break;
        }
}

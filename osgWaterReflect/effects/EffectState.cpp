#include "EffectState.h"

#include "Effect.h"

using namespace osgWaterReflect;

void EffectState::update(const std::vector<const Effect*>& effects, const WaterSurface& water,
                         const EffectView& view)
{
    if (effects != _effects)
    {
        _stateSet->clear();
        _captures.clear();
    }
    _effects = effects;
    _nextUnit = bindings::UNIT_EFFECTS;
    for (const Effect* effect : _effects)
        effect->apply(*this, water, view);
}

void EffectState::setTexture(const std::string& sampler, osg::Texture* texture)
{
    _stateSet->setTextureAttribute(_nextUnit, texture,
                                   osg::StateAttribute::ON | osg::StateAttribute::PROTECTED);
    set(sampler, static_cast<int>(_nextUnit));
    ++_nextUnit;
}

void EffectState::setCapture(const std::string& uniform, const Capture& capture)
{
    const auto binding = _captures.try_emplace(uniform, uniform, _nextUnit).first;
    binding->second.bind(*_stateSet, capture, nullptr, nullptr);
    _nextUnit += CaptureBinding::NUM_UNITS;
}

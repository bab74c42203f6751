#include "EffectState.h"

#include "Effect.h"

#include <osg/Notify>

#include <mutex>

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

bool EffectState::takeUnits(unsigned int count, const std::string& name, unsigned int& first)
{
    first = _nextUnit;
    if (first + count <= bindings::NUM_UNITS)
    {
        _nextUnit += count;
        return true;
    }
    static std::once_flag said;
    std::call_once(said,
                   [&]
                   {
                       OSG_WARN << "EffectState: expected effects to use at most "
                                << bindings::NUM_UNITS - bindings::UNIT_EFFECTS
                                << " texture units, got more for " << name << "; it is not set"
                                << std::endl;
                   });
    return false;
}

void EffectState::setTexture(const std::string& sampler, osg::Texture* texture)
{
    unsigned int unit = 0;
    if (!takeUnits(1, sampler, unit)) return;
    _stateSet->setTextureAttribute(unit, texture,
                                   osg::StateAttribute::ON | osg::StateAttribute::PROTECTED);
    set(sampler, static_cast<int>(unit));
}

void EffectState::setCapture(const std::string& uniform, const Capture& capture)
{
    unsigned int unit = 0;
    if (!takeUnits(CaptureBinding::NUM_UNITS, uniform, unit)) return;
    const auto binding = _captures.try_emplace(uniform, uniform, unit).first;
    binding->second.bind(*_stateSet, capture, nullptr, nullptr);
}

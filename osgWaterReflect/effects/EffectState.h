#ifndef OSGWATERREFLECT_EFFECTS_EFFECTSTATE_H
#define OSGWATERREFLECT_EFFECTS_EFFECTSTATE_H

#include "../images/CaptureBinding.h"
#include "../shaders/Bindings.h"

#include <osg/StateSet>
#include <osg/Texture>

#include <map>
#include <string>
#include <vector>

namespace osgWaterReflect
{

class Effect;
class WaterSurface;
struct EffectView;

/// The uniforms and textures of the effects that one sheet of water calls for in one view.
class EffectState
{
public:
    EffectState() : _stateSet(new osg::StateSet) {}

    /// Sets all that these effects ask for, and nothing else.
    void update(const std::vector<const Effect*>& effects, const WaterSurface& water,
                const EffectView& view);

    /// What the water is drawn with besides its own state: the same one for ever.
    osg::StateSet* stateSet() const { return _stateSet.get(); }

    template <typename Value>
    void set(const std::string& uniform, const Value& value)
    {
        bindings::set(*_stateSet, uniform, value);
    }

    /// In a texture unit of its own. Where none is left, OSG_WARN tells so, once, and it is not
    /// set.
    void setTexture(const std::string& sampler, osg::Texture* texture);

    /// The shader's struct Capture (shaders/shared/interface.glsl), without depth cells and sky; in
    /// units of its own, as a texture.
    void setCapture(const std::string& uniform, const Capture& capture);

private:
    bool takeUnits(unsigned int count, const std::string& name, unsigned int& first);

    const osg::ref_ptr<osg::StateSet> _stateSet;
    std::vector<const Effect*> _effects;
    std::map<std::string, CaptureBinding> _captures; // by uniform
    unsigned int _nextUnit = bindings::UNIT_EFFECTS; // in the middle of an update
};

} // namespace osgWaterReflect

#endif

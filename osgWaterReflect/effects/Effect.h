#ifndef OSGWATERREFLECT_EFFECTS_EFFECT_H
#define OSGWATERREFLECT_EFFECTS_EFFECT_H

#include "EffectState.h"

#include <osgWaterReflect/ShaderPiece>
#include <osgWaterReflect/WaterSurface>

#include <glm/mat4x4.hpp>

namespace osgWaterReflect
{

/// What effects may know of the view that water is drawn in.
struct EffectView
{
    glm::dmat4 eyeFromWorld{1.0};

    /// What the eye sees without water; null where no effect of the water looks at it, and before
    /// it is known which do.
    const Capture* scene = nullptr;
};

/// Whether an effect is called for: yes, or no and why.
struct CalledFor
{
    const char* whyNot = nullptr; ///< a few words; null: it is called for

    explicit operator bool() const { return !whyNot; }
};

/// Something that is seen in or on water, only where the scene calls for it: elsewhere it leaves no
/// line in the shader and no uniform, texture or pass.
///
/// It is one folder here with its piece of GLSL, and a line in EffectList.cpp. Effects hold nothing
/// of a water or a view; any thread may ask them.
class Effect
{
public:
    /// Where its piece stands in the shader (shaders/ShaderSlots.h).
    enum class Slot
    {
        SKY,
        BODY,
        OVER
    };

    virtual ~Effect() = default;

    /// What users call it, in a few words.
    virtual const char* getName() const = 0;

    virtual CalledFor calledFor(const WaterSurface& water, const EffectView& view) const = 0;

    /// Whether it looks at what the eye sees without water: EffectView::scene.
    virtual bool looksAtScene() const { return false; }

    virtual Slot getSlot() const = 0;

    /// The same in each call.
    virtual const ShaderPiece* getShaderPiece() const = 0;

    /// Sets the piece's uniforms and textures, for water that calls for it.
    virtual void apply(EffectState& state, const WaterSurface& water,
                       const EffectView& view) const = 0;
};

} // namespace osgWaterReflect

#endif

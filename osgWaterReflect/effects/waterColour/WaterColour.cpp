#include "WaterColour.h"

#include "../../shaders/ShaderSource.h"

using namespace osgWaterReflect;

const ShaderPiece* WaterColour::getShaderPiece() const
{
    static const osg::ref_ptr<const ShaderPiece> piece = libraryPiece("water_colour.glsl");
    return piece;
}

void WaterColour::apply(EffectState& state, const WaterSurface& water, const EffectView&) const
{
    state.set("osgwr_waterColour", water.getOptics().waterColour);
}

#include "SkyCubeMap.h"

#include "../../Transforms.h"
#include "../../shaders/ShaderSource.h"

#include <glm/matrix.hpp>

using namespace osgWaterReflect;

CalledFor SkyCubeMap::calledFor(const WaterSurface& water, const EffectView&) const
{
    return {water.getSky() ? nullptr : "the water is given no cube map"};
}

const ShaderPiece* SkyCubeMap::getShaderPiece() const
{
    static const osg::ref_ptr<const ShaderPiece> piece = libraryPiece("sky_cube_map.glsl");
    return piece;
}

void SkyCubeMap::apply(EffectState& state, const WaterSurface& water, const EffectView& view) const
{
    state.setTexture("osgwr_skyCubeMap", const_cast<osg::TextureCubeMap*>(water.getSky()));
    state.set("osgwr_worldFromEye", toOsgFloat(glm::dmat3(glm::inverse(view.eyeFromWorld))));
}

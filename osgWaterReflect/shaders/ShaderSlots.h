#ifndef OSGWATERREFLECT_SHADERS_SHADERSLOTS_H
#define OSGWATERREFLECT_SHADERS_SHADERSLOTS_H

#include <osgWaterReflect/ShaderPiece>

#include <osg/ref_ptr>

#include <string>
#include <vector>

namespace osgWaterReflect
{

/// What a water's shaders are put together from: the pieces that stand for `#include "waves"` and
/// the like, lines that name a slot and no file. Null stands for the slot's default.
///
/// | slot   | gives                              | default                                   |
/// |--------|------------------------------------|-------------------------------------------|
/// | waves  | the water's height and slope       | waves_calm.glsl                           |
/// | search | where a ray meets what is captured | search_hierarchical.glsl                  |
/// | sky    | what a ray sees that meets nothing | sky_captured.glsl                         |
/// | body   | the light that is not reflected    | water_colour.glsl (effects/waterColour)   |
/// | over   | what is added on top, in order     | nothing, and then no line for it          |
struct ShaderSlots
{
    using Piece = osg::ref_ptr<const ShaderPiece>;

    Piece waves;
    Piece search;
    Piece sky;
    Piece body;
    std::vector<Piece> over;

    bool operator==(const ShaderSlots& rhs) const
    {
        return waves == rhs.waves && search == rhs.search && sky == rhs.sky && body == rhs.body &&
               over == rhs.over;
    }

    /// The pieces in a slot, the default where none is given. Throws std::runtime_error where there
    /// is no such slot.
    std::vector<Piece> in(const std::string& slot) const;
};

} // namespace osgWaterReflect

#endif

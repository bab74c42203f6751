#ifndef OSGWATERREFLECT_SHADERS_SHADERSOURCE_H
#define OSGWATERREFLECT_SHADERS_SHADERSOURCE_H

#include "ShaderSlots.h"

#include <map>
#include <stdexcept>
#include <string>

namespace osgWaterReflect
{

/// The shader files of this folder and of the effects', compiled into the library: text by file
/// name.
extern const std::map<std::string, std::string> embeddedShaders;

/// Such a file as a piece, the same each time. Throws std::runtime_error where there is none.
const ShaderPiece* libraryPiece(const std::string& file);

/// The text of a shader, put together by what its lines ask for:
///
///     #include "name.glsl"             that file
///     #include "slot"                  the pieces in that slot, in their order
///     #each "over" c = over(c, d);     that statement for each piece in the slot, `over` being the
///                                      function that has the piece's name: of sun_glint.glsl,
///                                      sunGlint
///
/// A line for a slot that holds nothing is left empty. Others carry #line directives whose
/// source-string number is explained by a comment at the top.
/// Throws std::runtime_error, naming the piece and the includer, where one is missing or includes
/// itself.
std::string assembleShader(const std::string& name, const ShaderSlots& slots = {});

/// Another text for a piece, or a piece more, while it lives: so that tests can break a shader on
/// purpose, and measurements set other methods in the place of the library's.
///
/// Water takes it up at its next cull, images that are made of a capture when they are made next.
/// One piece has one replacement at a time.
class ShaderReplacement
{
public:
    ShaderReplacement(const std::string& name, const std::string& text);
    ~ShaderReplacement();
    ShaderReplacement(const ShaderReplacement&) = delete;
    ShaderReplacement& operator=(const ShaderReplacement&) = delete;

    /// Names and texts of all that live, in one string; empty where none does.
    static std::string all();

    /// Changes whenever one comes or goes.
    static unsigned int generation();

private:
    std::string _name;
};

} // namespace osgWaterReflect

#endif

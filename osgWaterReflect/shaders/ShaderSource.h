#ifndef OSGWATERREFLECT_SHADERS_SHADERSOURCE_H
#define OSGWATERREFLECT_SHADERS_SHADERSOURCE_H

#include <map>
#include <stdexcept>
#include <string>

namespace osgWaterReflect
{

/// The files of this folder, compiled into the library: text by file name.
extern const std::map<std::string, std::string> embeddedShaders;

/// The text of a shader with every `#include "name"` replaced by that piece, each with #line
/// directives whose source-string number is explained by a comment at the top.
///   waves  the piece that `#include "waves"` stands for
/// Throws std::runtime_error, naming the piece and the includer, where one is missing or includes
/// itself.
std::string assembleShader(const std::string& name, const std::string& waves);

/// Another text for a piece, or a piece more, while it lives: so that tests can break a shader on
/// purpose, and measurements set other methods in the place of the library's.
///
/// Water takes it up at its next cull. One piece has one replacement at a time.
class ShaderReplacement
{
public:
    ShaderReplacement(const std::string& name, const std::string& text);
    ~ShaderReplacement();
    ShaderReplacement(const ShaderReplacement&) = delete;
    ShaderReplacement& operator=(const ShaderReplacement&) = delete;

    /// Names and texts of all that live, in one string; empty where none does.
    static std::string all();

private:
    std::string _name;
};

} // namespace osgWaterReflect

#endif

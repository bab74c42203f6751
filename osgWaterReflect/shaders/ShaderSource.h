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

} // namespace osgWaterReflect

#endif

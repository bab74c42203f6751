#ifndef OSGWATERREFLECT_SHADERS_SHAREDPROGRAM_H
#define OSGWATERREFLECT_SHADERS_SHAREDPROGRAM_H

#include "ShaderSlots.h"

#include <osg/Program>

#include <string>

namespace osgWaterReflect
{

/// The program of two files of this folder. All who ask for the same get the same, as long as
/// somebody holds it. Looking it up takes a lock and puts strings together: not for every frame.
///
/// Where waves from outside the library cannot be put together or compiled with the rest, OSG_WARN
/// names them once and the program is that of calm water.
osg::ref_ptr<osg::Program> sharedProgram(const std::string& vertex, const std::string& fragment,
                                         const ShaderSlots& slots = {});

} // namespace osgWaterReflect

#endif

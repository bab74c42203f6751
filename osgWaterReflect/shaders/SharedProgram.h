#ifndef OSGWATERREFLECT_SHADERS_SHAREDPROGRAM_H
#define OSGWATERREFLECT_SHADERS_SHAREDPROGRAM_H

#include <osg/Program>

#include <string>

namespace osgWaterReflect
{

/// The program of two files of this folder. All who ask for the same get the same, as long as
/// somebody holds it.
///   waves  the piece that `#include "waves"` stands for; empty where there is none
osg::ref_ptr<osg::Program> sharedProgram(const std::string& vertex, const std::string& fragment,
                                         const std::string& waves = "");

} // namespace osgWaterReflect

#endif

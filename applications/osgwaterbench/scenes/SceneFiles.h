#ifndef OSGWATERBENCH_SCENEFILES_H
#define OSGWATERBENCH_SCENEFILES_H

#include "Scenes.h"

#include <osg/TextureCubeMap>

namespace osgwaterbench
{

/// A scene of the data directory with its water taken out and its sky; without what writes no depth
/// but that sky, and without a view. None, with a message, where data is missing or its water is
/// not at one level.
std::optional<BenchScene> readDemoScene(const char* file);

/// The demo scenes' sky, for water. Null, with a message, where data is missing.
osg::ref_ptr<osg::TextureCubeMap> readDemoSky();

/// A group without light that draws nothing but the demo scenes' sky. Null, with a message, where
/// data is missing.
osg::ref_ptr<osg::Group> createUnderSky();

} // namespace osgwaterbench

#endif

#ifndef OSGWATERBENCH_BOXES_H
#define OSGWATERBENCH_BOXES_H

#include "HarnessWaves.h"

#include <osg/Geode>
#include <osg/Vec3d>

#include <optional>
#include <string>
#include <vector>

namespace osgwaterbench
{

/// A box along the axes [m].
struct Box
{
    osg::Vec3d lowest;
    osg::Vec3d highest;
    osg::Vec3 colour;
};

/// What data/bench/boxes.json holds: boxes over water at z = 0, how they are looked at, and waves.
struct BoxesFile
{
    osg::Vec3d eye;           ///< [m]; it looks along +y
    double pitch = 0.0;       ///< [rad] down
    double fovyDegrees = 0.0; ///< vertical
    std::vector<HarnessWave> waves;
    std::vector<Box> boxes;
    Box branch; ///< ahead of the eye

    /// The file of the data directory. None, with a message, where it is missing or broken.
    static std::optional<BoxesFile> read();
};

/// Chequered boxes.
osg::ref_ptr<osg::Geode> createBoxes(const std::vector<Box>& boxes);

} // namespace osgwaterbench

#endif

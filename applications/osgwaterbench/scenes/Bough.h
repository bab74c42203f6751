#ifndef OSGWATERBENCH_BOUGH_H
#define OSGWATERBENCH_BOUGH_H

#include <osg/Geode>
#include <osg/Vec3d>

namespace osgwaterbench
{

/// A leafy birch bough that hangs in from the left, 3 to 7 m away from an eye that looks along +y.
/// It covers much of what lies above the eye's line of sight, with holes of every size. Opaque,
/// without light; the same for every run.
///   eye  [m]
osg::ref_ptr<osg::Geode> createBough(const osg::Vec3d& eye);

} // namespace osgwaterbench

#endif

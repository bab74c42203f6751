#ifndef OSGWATERVIEWER_WATERGEODES_H
#define OSGWATERVIEWER_WATERGEODES_H

#include <osg/Group>

#include <osgWaterReflect/WaterSurface>

#include <vector>

namespace osgwaterviewer
{

using Waters = std::vector<osg::ref_ptr<osgWaterReflect::WaterSurface>>;

/// Replaces every osg::Geode named "water" below a group by a WaterSurface with the same drawables
/// under the same parents. Returns these.
Waters replaceWaterGeodes(osg::Group& root);

} // namespace osgwaterviewer

#endif

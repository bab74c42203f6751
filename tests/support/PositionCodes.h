#ifndef OSGWATERREFLECT_TESTS_SUPPORT_POSITIONCODES_H
#define OSGWATERREFLECT_TESTS_SUPPORT_POSITIONCODES_H

#include <osg/Node>

/// Paints everything below a node with its own place: red, green and blue are the world x, y and z
/// in world units, alpha is 1. For frames in RGBA32F. The node's coordinates must be the world's.
///
/// What lies under a height z is not drawn at all, so that a view from the mirrored eye under the
/// water sees what the water reflects.
void paintPositions(osg::Node& node, double lowestZ = -1e30);

#endif

#ifndef OSGWATERREFLECT_TESTS_SUPPORT_POSITIONCODES_H
#define OSGWATERREFLECT_TESTS_SUPPORT_POSITIONCODES_H

#include <osg/Image>
#include <osg/Node>
#include <osg/Plane>

/// A picture whose colours are places: red, green and blue are the world x, y and z of what is
/// seen, moved by OFFSET so that they are above 0 (a capture's colours are never below). For
/// frames in RGBA32F, cleared to black.
namespace positionCodes
{

/// [world units] Places within this distance of the origin have a code.
constexpr double OFFSET = 500.0;

/// Paints everything below a node, whose coordinates must be the world's. What lies under the
/// plane is not drawn at all: a view from the eye mirrored in the water then sees what the water
/// reflects.
void paint(osg::Node& node, const osg::Plane& ground = osg::Plane(0, 0, 1, 1e9));

/// Whether a colour is the code of a place, and not background, sky or a debug colour.
bool isPlace(const osg::Vec4& colour);
osg::Vec3d place(const osg::Vec4& colour);

} // namespace positionCodes

#endif

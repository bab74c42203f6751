#ifndef OSGWATERREFLECT_CAPTURE_UNSTEADYSHADOWS_H
#define OSGWATERREFLECT_CAPTURE_UNSTEADYSHADOWS_H

#include <osg/Group>

#include <string>

namespace osgWaterReflect
{

/// The shadow technique of a group, by its class, if that fits its shadows to each cull: a scene
/// drawn once more has others then. Empty where the group has no such technique.
std::string unsteadyShadowsOf(const osg::Group& group);

/// The same of any group in a scene, visible or not; empty where none has.
std::string unsteadyShadowsBelow(osg::Node& scene);

} // namespace osgWaterReflect

#endif

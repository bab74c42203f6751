#ifndef OSGWATERBENCH_CULLSCENE_H
#define OSGWATERBENCH_CULLSCENE_H

#include <osg/Group>

#include <osgWaterReflect/WaterSurface>

#include <vector>

namespace osgwaterbench
{

/// How waters lie in a field of boxes, in front of its eye.
enum class WaterLayout
{
    ONE,          ///< a rectangle as large as the field
    IN_ONE_PLANE, ///< 64 small rectangles side by side
    ON_LEVELS     ///< the same, each 5 cm above the one before
};

enum class BoxStates
{
    SHARED, ///< one of eight StateSets each
    OWN     ///< a StateSet each
};

/// For measuring culls: small boxes in rows on the ground, z = 0 [m], each a drawable below a
/// transform of its own. fieldEye() sees three in five of them.
osg::ref_ptr<osg::Group> createBoxField(std::size_t drawables, BoxStates states);

/// Calm waters, all of which fieldEye() sees.
std::vector<osg::ref_ptr<osgWaterReflect::WaterSurface>> createFieldWaters(WaterLayout layout);

/// Where a field is seen from [m]; up is z.
struct FieldEye
{
    osg::Vec3d eye;
    osg::Vec3d centre;
    double fovyDegrees = 0.0; ///< vertical, for a picture of 4 by 3
};

/// Where the eye is after so many steps of a walk back and forth, on which it turns, too.
FieldEye fieldEye(int steps);

} // namespace osgwaterbench

#endif

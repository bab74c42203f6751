#ifndef OSGWATERREFLECT_CAPTURE_SEENPYRAMID_H
#define OSGWATERREFLECT_CAPTURE_SEENPYRAMID_H

#include "../band/NdcExtent.h"

#include <osg/Matrixd>
#include <osg/Vec3d>

namespace osgWaterReflect
{

/// A sphere in eye space that holds all of one in local space.
struct EyeSphere
{
    EyeSphere(const osg::Vec3d& centreLocal, double radiusLocal, const osg::Matrixd& eyeFromLocal);

    osg::Vec3d centre;
    double radius;
};

/// The pyramid of what an eye sees within an extent, without near and far: tells at little cost,
/// and for most of a scene, that all of a thing lies in it, or none, by a sphere around the thing.
class SeenPyramid
{
public:
    SeenPyramid(const NdcExtent& extent, const glm::dmat4& clipFromEye);

    bool holdsAllOf(const EyeSphere& sphere) const;
    bool holdsNoneOf(const EyeSphere& sphere) const;

private:
    void addSide(const glm::dvec4& plane, double place);
    double height(int side, const EyeSphere& sphere) const;

    glm::dvec4 _sides[5];
    int _numSides = 0;
};

} // namespace osgWaterReflect

#endif

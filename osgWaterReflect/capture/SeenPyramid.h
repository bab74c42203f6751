#ifndef OSGWATERREFLECT_CAPTURE_SEENPYRAMID_H
#define OSGWATERREFLECT_CAPTURE_SEENPYRAMID_H

#include "../band/NdcExtent.h"

#include <osg/Matrixd>
#include <osg/Vec3d>

#include <algorithm>
#include <cmath>

namespace osgWaterReflect
{

/// A sphere in eye space that holds all of one in local space.
struct EyeSphere
{
    EyeSphere(const osg::Vec3d& centreLocal, double radiusLocal, const osg::Matrixd& eyeFromLocal);

    osg::Vec3d centre;
    double radius;
};

// The squared stretch is the largest eigenvalue of the axes' products: at most the largest sum of
// magnitudes of a row, and just that where the axes are perpendicular.
inline EyeSphere::EyeSphere(const osg::Vec3d& centreLocal, double radiusLocal,
                            const osg::Matrixd& eyeFromLocal) :
    centre(centreLocal * eyeFromLocal)
{
    const osg::Matrixd& m = eyeFromLocal;
    const auto product = [&](int a, int b)
    { return m(a, 0) * m(b, 0) + m(a, 1) * m(b, 1) + m(a, 2) * m(b, 2); };
    const double xy = std::abs(product(0, 1));
    const double yz = std::abs(product(1, 2));
    const double zx = std::abs(product(2, 0));
    const double squaredStretch =
        std::max({product(0, 0) + xy + zx, product(1, 1) + xy + yz, product(2, 2) + zx + yz});
    radius = radiusLocal * std::sqrt(squaredStretch) * (1.0 + 1e-6);
}

/// The pyramid of what an eye sees within an extent, without near and far: tells at little cost,
/// and for most of a scene, that all of a thing lies in it, or none, by a sphere around the thing.
class SeenPyramid
{
public:
    SeenPyramid(const NdcExtent& extent, const glm::dmat4& clipFromEye);

    bool holdsAllOf(const EyeSphere& sphere) const
    {
        for (int i = 0; i < _numSides; ++i)
            if (!(height(i, sphere) >= sphere.radius)) return false;
        return true;
    }

    bool holdsNoneOf(const EyeSphere& sphere) const
    {
        for (int i = 0; i < _numSides; ++i)
            if (height(i, sphere) < -sphere.radius) return true;
        return false;
    }

private:
    void addSide(const glm::dvec4& plane, double place);

    double height(int side, const EyeSphere& sphere) const
    {
        const glm::dvec4& plane = _sides[side];
        return plane.x * sphere.centre.x() + plane.y * sphere.centre.y() +
               plane.z * sphere.centre.z() + plane.w;
    }

    glm::dvec4 _sides[5];
    int _numSides = 0;
};

} // namespace osgWaterReflect

#endif

#include "SeenPyramid.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

using namespace osgWaterReflect;

// The squared stretch is the largest eigenvalue of the axes' products: at most the largest sum of
// magnitudes of a row, and just that where the axes are perpendicular.
EyeSphere::EyeSphere(const osg::Vec3d& centreLocal, double radiusLocal,
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

SeenPyramid::SeenPyramid(const NdcExtent& extent, const glm::dmat4& clipFromEye)
{
    const glm::dmat4 rows = glm::transpose(clipFromEye);
    addSide(rows[0] - extent.left * rows[3], extent.left);
    addSide(extent.right * rows[3] - rows[0], extent.right);
    addSide(rows[1] - extent.bottom * rows[3], extent.bottom);
    addSide(extent.top * rows[3] - rows[1], extent.top);
    addSide(rows[3], 0.0); // before the eye
}

// A side at infinity is none.
void SeenPyramid::addSide(const glm::dvec4& plane, double place)
{
    if (!std::isfinite(place)) return;
    const double length = glm::length(glm::dvec3(plane));
    if (length > 0.0) _sides[_numSides++] = plane / length;
}

bool SeenPyramid::holdsAllOf(const EyeSphere& sphere) const
{
    for (int i = 0; i < _numSides; ++i)
        if (!(height(i, sphere) >= sphere.radius)) return false;
    return true;
}

bool SeenPyramid::holdsNoneOf(const EyeSphere& sphere) const
{
    for (int i = 0; i < _numSides; ++i)
        if (height(i, sphere) < -sphere.radius) return true;
    return false;
}

double SeenPyramid::height(int side, const EyeSphere& sphere) const
{
    const glm::dvec4& plane = _sides[side];
    return plane.x * sphere.centre.x() + plane.y * sphere.centre.y() + plane.z * sphere.centre.z() +
           plane.w;
}

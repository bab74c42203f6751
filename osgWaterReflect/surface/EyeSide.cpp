#include "EyeSide.h"

#include "../Transforms.h"

#include <glm/matrix.hpp>

using namespace osgWaterReflect;

double osgWaterReflect::sideOfEye(const glm::dmat4& eyeFromSurface, const glm::dmat4& clipFromEye,
                                  const WaveModel* waves, double time)
{
    const glm::dvec4 eye = glm::inverse(eyeFromSurface) * eyePointOf(clipFromEye);
    double height = eye.z;
    if (waves && eye.w != 0.0) height -= waves->getHeight(osg::Vec2d(eye.x, eye.y), time);
    return height < 0.0 ? -1.0 : 1.0;
}

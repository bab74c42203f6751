#include "EyeSide.h"

#include "../Transforms.h"

#include <glm/matrix.hpp>

#include <cmath>

using namespace osgWaterReflect;

bool osgWaterReflect::isEyeAbove(const glm::dmat4& eyeFromSurface, const glm::dmat4& clipFromEye,
                                 const WaveState* waves, double amplitude)
{
    const glm::dvec4 eyePoint = glm::inverse(eyeFromSurface) * eyePointOf(clipFromEye);
    if (!waves || eyePoint.w == 0.0 || std::abs(eyePoint.z) > amplitude) return eyePoint.z >= 0.0;
    return eyePoint.z >= waves->getHeight(osg::Vec2d(eyePoint.x, eyePoint.y));
}

#include "EyeHeight.h"

#include "../Transforms.h"

#include <glm/matrix.hpp>

using namespace osgWaterReflect;

double osgWaterReflect::heightOfEye(const glm::dmat4& eyeFromSurface, const glm::dmat4& clipFromEye,
                                    const WaveModel* waves, double time)
{
    const glm::dvec4 eyePoint = glm::inverse(eyeFromSurface) * eyePointOf(clipFromEye);
    if (!waves || eyePoint.w == 0.0) return eyePoint.z;
    return eyePoint.z - waves->getHeight(osg::Vec2d(eyePoint.x, eyePoint.y), time);
}

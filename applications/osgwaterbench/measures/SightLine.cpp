#include "SightLine.h"

#include <osgWaterReflect/Transforms.h>

#include <glm/geometric.hpp>

#include <algorithm>

using namespace osgwaterbench;

glm::dvec3 osgwaterbench::sightDirEye(const DrawnWater& drawn, const glm::dvec3& pointEye)
{
    const glm::dvec4 eyePoint = osgWaterReflect::eyePointOf(drawn.view.clipFromEye);
    return glm::normalize(eyePoint.w * pointEye - glm::dvec3(eyePoint));
}

glm::dvec3 osgwaterbench::reflectedDirEye(const DrawnWater& drawn, const glm::dvec3& pointEye,
                                          const glm::dvec3& normalEye)
{
    const glm::dvec3 once = glm::reflect(sightDirEye(drawn, pointEye), normalEye);
    const double up = glm::dot(once, drawn.stillNormalEye);
    return once - 2.0 * std::min(up, 0.0) * drawn.stillNormalEye;
}

#include "Truth.h"

#include "Fresnel.h"
#include "Parallel.h"
#include "SightLine.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

using namespace osgwaterbench;

Truth osgwaterbench::findTruth(const DrawnWater& drawn, const TrueWorld& world, int everyNth)
{
    const std::vector<std::size_t> pixels = waterPixels(drawn, everyNth);
    const ReflectionTracer tracer(drawn, world.scene);
    const osg::Vec3& colour = world.optics.waterColour;
    const glm::dvec3 waterColour(colour.x(), colour.y(), colour.z());

    Truth truth(pixels.size());
    const auto findPixel = [&](std::size_t i)
    {
        const glm::dvec3& pointEye = drawn.pointEye[pixels[i]];
        const glm::dvec3& normalEye = drawn.normalEye[pixels[i]];
        TruePixel& result = truth[i];
        result.pixel = pixels[i];
        result.reflected = tracer.trace(pointEye, normalEye);
        result.reflectedColour = result.reflected.trueClass == TrueClass::SKY
                                     ? world.sky.colour(result.reflected.dirWorld)
                                     : result.reflected.colour;
        const double cosIncident =
            glm::clamp(-glm::dot(sightDirEye(drawn, pointEye), normalEye), 0.0, 1.0);
        result.shadedColour = glm::mix(waterColour, result.reflectedColour,
                                       reflectance(cosIncident, world.optics.refractiveIndex));
    };
    inParallel(pixels.size(), findPixel);
    return truth;
}

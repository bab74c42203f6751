#include "ImageTruth.h"

#include "Parallel.h"
#include "SightLine.h"

#include <glm/matrix.hpp>

using namespace osgwaterbench;
using osgWaterReflect::reference::ImageHit;

ImageTruth osgwaterbench::findImageTruth(const DrawnWater& drawn, double thickness, int everyNth)
{
    const std::vector<std::size_t> pixels = waterPixels(drawn, everyNth);
    const osgWaterReflect::reference::ImageTracer tracer(drawn.capture, thickness);
    const glm::dmat4 worldFromEye = glm::inverse(drawn.eyeFromWorld);

    ImageTruth truth(pixels.size());
    const auto findPixel = [&](std::size_t i)
    {
        const glm::dvec3& pointEye = drawn.pointEye[pixels[i]];
        const glm::dvec3 dirEye = reflectedDirEye(drawn, pointEye, drawn.normalEye[pixels[i]]);
        const ImageHit hit = tracer.trace(pointEye, dirEye);
        truth[i] = {pixels[i], hit.reason,
                    glm::dvec3(worldFromEye * glm::dvec4(pointEye + hit.t * dirEye, 1.0))};
    };
    inParallel(pixels.size(), findPixel);
    return truth;
}

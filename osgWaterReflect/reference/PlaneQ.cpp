#include "PlaneQ.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

using namespace osgWaterReflect::reference;

namespace
{

// A point of the image plane, homogeneous [pixels]; directions (w = 0) and points behind the eye
// too.
glm::dvec3 imagePoint(const ImageGeometry& image, const glm::dvec4& pointEye)
{
    const glm::dvec4 clip = image.clipFromEye * pointEye;
    return glm::dvec3(0.5 * image.size * (glm::dvec2(clip) + clip.w), clip.w);
}

} // namespace

double PlaneQ::intersect(const glm::dvec3& originEye, const glm::dvec3& dirEye) const
{
    return glm::dot(normalEye, pointEye - originEye) / glm::dot(normalEye, dirEye);
}

glm::dvec3 ImageGeometry::windowFromEye(const glm::dvec3& pointEye) const
{
    const glm::dvec4 clip = clipFromEye * glm::dvec4(pointEye, 1.0);
    return (glm::dvec3(clip) / clip.w + 1.0) * 0.5 * glm::dvec3(size, 1.0);
}

glm::dvec3 ImageGeometry::eyeFromWindow(const glm::dvec3& window) const
{
    const glm::dvec3 ndc = window / glm::dvec3(size, 1.0) * 2.0 - 1.0;
    const glm::dvec4 eye = glm::inverse(clipFromEye) * glm::dvec4(ndc, 1.0);
    return glm::dvec3(eye) / eye.w;
}

double osgWaterReflect::reference::crossingOnLine(const ImageGeometry& image,
                                                  const glm::dvec3& originEye,
                                                  const glm::dvec3& dirEye, ImageLines lines,
                                                  double line)
{
    // The image line through the ray's origin and its vanishing point.
    const glm::dvec3 imageLine = glm::cross(imagePoint(image, glm::dvec4(originEye, 1.0)),
                                            imagePoint(image, glm::dvec4(dirEye, 0.0)));
    const int along = static_cast<int>(lines);
    return -(imageLine[along] * line + imageLine.z) / imageLine[1 - along];
}

PlaneQ osgWaterReflect::reference::planeOnLine(const ImageGeometry& image, ImageLines lines,
                                               double line, double crossing,
                                               const glm::dvec2& windowZ)
{
    // Pixel centres lie at halves.
    const double first = std::floor(crossing - 0.5) + 0.5;
    const auto pixel = [&](double other, double z) {
        return lines == ImageLines::COLUMNS ? glm::dvec3(line, other, z)
                                            : glm::dvec3(other, line, z);
    };
    const glm::dvec3 a = image.eyeFromWindow(pixel(first, windowZ[0]));
    const glm::dvec3 b = image.eyeFromWindow(pixel(first + 1.0, windowZ[1]));

    // The first pixel's line of sight: where it is seen nearest, and where it is seen now.
    const glm::dvec3 sight = a - image.eyeFromWindow(pixel(first, -1.0));
    return {glm::cross(b - a, sight), a};
}

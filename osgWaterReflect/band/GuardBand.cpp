#include "GuardBand.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

using namespace osgWaterReflect;

namespace
{

// [pixels] Less than this beyond a side is rounding: single precision in the matrices that the
// view was given moves a place in an image of 10,000 pixels by no more.
const double ROUNDING = 0.01;

// By what factor the bands of both axes are cut down for (size.x + f band.x) (size.y + f band.y) to
// be the limit.
double cutFactor(const glm::dvec2& size, const glm::dvec2& band, double limit)
{
    const double a = band.x * band.y;
    const double b = band.x * size.y + band.y * size.x;
    const double c = limit - size.x * size.y;
    // Rounded down, lest a whole pixel be a rounding error too many.
    return (1.0 - 1e-12) * 2.0 * c / (b + std::sqrt(b * b + 4.0 * a * c));
}

// How many whole pixels an extent reaches beyond the left, right, lower and upper side of the view.
glm::dvec4 pixelsBeyond(const NdcExtent& extent, const glm::ivec2& viewSize)
{
    const glm::dvec4 beyond(-1.0 - extent.left, extent.right - 1.0, -1.0 - extent.bottom,
                            extent.top - 1.0);
    const glm::dvec4 sizes(viewSize.x, viewSize.x, viewSize.y, viewSize.y);
    return glm::max(glm::ceil(0.5 * beyond * sizes - ROUNDING), 0.0);
}

} // namespace

GuardBand osgWaterReflect::bandFor(const NdcExtent& needed, const glm::ivec2& viewSize,
                                   double maxExtraPixels)
{
    const glm::dvec2 size(viewSize);
    const glm::dvec4 sizes(size.x, size.x, size.y, size.y);
    glm::dvec4 band = pixelsBeyond(needed, viewSize);

    const double limit = (1.0 + maxExtraPixels) * size.x * size.y;
    if ((size.x + band[0] + band[1]) * (size.y + band[2] + band[3]) > limit)
    {
        band = glm::min(band, maxExtraPixels * sizes);
        const double factor = cutFactor(size, {band[0] + band[1], band[2] + band[3]}, limit);
        band = glm::floor(std::min(1.0, factor) * band); // in the order that makes 1 of 0 / 0
    }
    const glm::ivec4 whole(band);
    return {whole[0], whole[1], whole[2], whole[3]};
}

bool osgWaterReflect::reaches(const GuardBand& band, const NdcExtent& needed,
                              const glm::ivec2& viewSize)
{
    const glm::dvec4 beyond = pixelsBeyond(needed, viewSize);
    return band.left >= beyond[0] && band.right >= beyond[1] && band.bottom >= beyond[2] &&
           band.top >= beyond[3];
}

glm::ivec2 osgWaterReflect::widened(const glm::ivec2& viewSize, const GuardBand& band)
{
    return viewSize + glm::ivec2(band.left + band.right, band.bottom + band.top);
}

glm::dmat4 osgWaterReflect::widened(const glm::dmat4& clipFromEye, const glm::ivec2& viewSize,
                                    const GuardBand& band)
{
    const glm::dvec2 wideSize(widened(viewSize, band));
    const glm::dvec2 scale = glm::dvec2(viewSize) / wideSize;
    const glm::dvec2 shift = glm::dvec2(band.left - band.right, band.bottom - band.top) / wideSize;
    glm::dmat4 wide = clipFromEye;
    for (int column = 0; column < 4; ++column)
        for (int axis = 0; axis < 2; ++axis)
            wide[column][axis] =
                scale[axis] * clipFromEye[column][axis] + shift[axis] * clipFromEye[column].w;
    return wide;
}

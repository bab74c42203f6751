#ifndef OSGWATERREFLECT_BAND_GUARDBAND_H
#define OSGWATERREFLECT_BAND_GUARDBAND_H

#include "NdcExtent.h"

namespace osgWaterReflect
{

/// Whole pixels that a captured image reaches beyond each side of the view's, so that the grids of
/// both coincide.
struct GuardBand
{
    int left = 0;
    int right = 0;
    int bottom = 0;
    int top = 0;
};

/// The band that reaches as far as an extent. Where the widened image would have more than
/// (1 + maxExtraPixels) times the view's pixels, all sides are cut down by one factor, infinite
/// ones as if each asked for all the extra pixels alone.
///   viewSize        [pixels] > 0
///   maxExtraPixels  [1] of the view's, finite, >= 0
GuardBand bandFor(const NdcExtent& needed, const glm::ivec2& viewSize, double maxExtraPixels);

/// Whether a band reaches as far as an extent.
bool reaches(const GuardBand& band, const NdcExtent& needed, const glm::ivec2& viewSize);

/// Size of the view's image with its band [pixels].
glm::ivec2 widened(const glm::ivec2& viewSize, const GuardBand& band);

/// The view's projection with its band: what the view sees at pixel (x, y) is seen at (x + left,
/// y + bottom), at the same windowZ.
glm::dmat4 widened(const glm::dmat4& clipFromEye, const glm::ivec2& viewSize,
                   const GuardBand& band);

} // namespace osgWaterReflect

#endif

#ifndef OSGWATERBENCH_PICTUREERROR_H
#define OSGWATERBENCH_PICTUREERROR_H

#include "Picture.h"

#include <cstdint>
#include <optional>

namespace osgwaterbench
{

/// How two pictures differ at the water pixels. Nothing else is looked at.
struct PictureError
{
    double rmse = 0.0; ///< [steps of 8 bits] root of the mean square over pixels and channels

    /// [dB] 20 log10(255 / rmse); none where that is infinite, the pictures being the same.
    std::optional<double> psnr;

    /// Mean structural similarity of the luma, [-1, 1], 1 for the same pictures [Wang04].
    ///
    /// Windows of 11 x 11 pixels, Gaussian of 1.5 pixels, K1 = 0.01, K2 = 0.03, about each water
    /// pixel. Of a window that reaches over the water's or the image's border only its water pixels
    /// count, their weights scaled so that they sum to 1. Luma is that of [BT601]; the pictures are
    /// not made smaller first.
    double ssim = 1.0;
};

/// None where there is no water. Runs on all cores.
///   a, b     of one size
///   isWater  0 or 1, an element for each of their pixels
std::optional<PictureError> comparePictures(const Picture& a, const Picture& b,
                                            const std::vector<std::uint8_t>& isWater);

} // namespace osgwaterbench

#endif

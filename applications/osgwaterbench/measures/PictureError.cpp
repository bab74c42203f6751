#include "PictureError.h"

#include "Parallel.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace osgwaterbench;

namespace
{

const double LARGEST = 255.0; // of 8 bits

// [Wang04]: the window, and constants against division by next to nothing.
const int RADIUS = 5;
const double SIGMA = 1.5; // [pixels]
const double C1 = 0.01 * LARGEST * 0.01 * LARGEST;
const double C2 = 0.03 * LARGEST * 0.03 * LARGEST;

const glm::dvec3 LUMA(0.299, 0.587, 0.114); // [BT601]

std::vector<double> lumaOf(const Picture& picture)
{
    std::vector<double> luma(picture.colours.size());
    std::transform(picture.colours.begin(), picture.colours.end(), luma.begin(),
                   [](const glm::dvec3& colour) { return LARGEST * glm::dot(LUMA, colour); });
    return luma;
}

// The structural similarity of two pictures about one pixel of water.
class Similarity
{
public:
    Similarity(const Picture& a, const Picture& b, const std::vector<std::uint8_t>& isWater) :
        _width(a.width), _height(a.height), _a(lumaOf(a)), _b(lumaOf(b)), _isWater(isWater)
    {
        for (int i = 0; i <= 2 * RADIUS; ++i)
            _gaussian[i] = std::exp(-0.5 * (i - RADIUS) * (i - RADIUS) / (SIGMA * SIGMA));
    }

    double at(std::size_t pixel) const
    {
        const int px = static_cast<int>(pixel % _width);
        const int py = static_cast<int>(pixel / _width);
        double weights = 0.0;
        double a = 0.0, b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0; // weighted sums
        for (int y = std::max(0, py - RADIUS); y <= std::min(_height - 1, py + RADIUS); ++y)
            for (int x = std::max(0, px - RADIUS); x <= std::min(_width - 1, px + RADIUS); ++x)
            {
                const std::size_t other = static_cast<std::size_t>(y) * _width + x;
                if (!_isWater[other]) continue;
                const double weight = _gaussian[x - px + RADIUS] * _gaussian[y - py + RADIUS];
                weights += weight;
                a += weight * _a[other];
                b += weight * _b[other];
                aa += weight * _a[other] * _a[other];
                bb += weight * _b[other] * _b[other];
                ab += weight * _a[other] * _b[other];
            }
        const double meanA = a / weights;
        const double meanB = b / weights;
        const double varianceA = aa / weights - meanA * meanA;
        const double varianceB = bb / weights - meanB * meanB;
        const double covariance = ab / weights - meanA * meanB;
        return (2.0 * meanA * meanB + C1) * (2.0 * covariance + C2) /
               ((meanA * meanA + meanB * meanB + C1) * (varianceA + varianceB + C2));
    }

private:
    int _width;
    int _height;
    std::vector<double> _a; // luma [steps of 8 bits]
    std::vector<double> _b;
    const std::vector<std::uint8_t>& _isWater;
    std::array<double, 2 * RADIUS + 1> _gaussian{};
};

} // namespace

std::optional<PictureError> osgwaterbench::comparePictures(const Picture& a, const Picture& b,
                                                           const std::vector<std::uint8_t>& isWater)
{
    std::vector<std::size_t> pixels;
    for (std::size_t pixel = 0; pixel < isWater.size(); ++pixel)
        if (isWater[pixel]) pixels.push_back(pixel);
    if (pixels.empty()) return std::nullopt;

    const Similarity similarity(a, b, isWater);
    std::vector<double> similarities(pixels.size());
    inParallel(pixels.size(), [&](std::size_t i) { similarities[i] = similarity.at(pixels[i]); });

    PictureError error;
    double squares = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < pixels.size(); ++i)
    {
        const glm::dvec3 steps = LARGEST * (a.colours.at(pixels[i]) - b.colours.at(pixels[i]));
        squares += glm::dot(steps, steps);
        sum += similarities[i];
    }
    const double count = static_cast<double>(pixels.size());
    error.rmse = std::sqrt(squares / (3.0 * count));
    if (error.rmse > 0.0) error.psnr = 20.0 * std::log10(LARGEST / error.rmse);
    error.ssim = sum / count;
    return error;
}

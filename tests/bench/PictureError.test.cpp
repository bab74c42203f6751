// How the benchmark says that two pictures differ.

#include "support/Catch.h"

#include <osgwaterbench/measures/PictureError.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

using namespace osgwaterbench;

namespace
{

const int WIDTH = 31;
const int HEIGHT = 23;

Picture noise(unsigned int seed)
{
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> channel(0.2, 0.8);
    Picture picture = {WIDTH, HEIGHT, {}};
    for (int i = 0; i < WIDTH * HEIGHT; ++i)
        picture.colours.emplace_back(channel(generator), channel(generator), channel(generator));
    return picture;
}

Picture plain(double grey)
{
    return {WIDTH, HEIGHT, std::vector<glm::dvec3>(WIDTH * HEIGHT, glm::dvec3(grey))};
}

std::vector<std::uint8_t> waterEverywhere()
{
    return std::vector<std::uint8_t>(WIDTH * HEIGHT, 1);
}

// Below a slanting shore.
std::vector<std::uint8_t> waterBelow()
{
    std::vector<std::uint8_t> isWater(WIDTH * HEIGHT);
    for (int i = 0; i < WIDTH * HEIGHT; ++i)
        isWater[i] = i / WIDTH < 8 + (i % WIDTH) / 4;
    return isWater;
}

// Structural similarity about one pixel, by the definitions of [Wang04] with weights
// that are made for each window.
double similarityAt(const Picture& a, const Picture& b, const std::vector<std::uint8_t>& isWater,
                    int px, int py)
{
    struct Sample
    {
        double weight, a, b;
    };
    std::vector<Sample> window;
    double weights = 0.0;
    for (int i = 0; i < WIDTH * HEIGHT; ++i)
    {
        const int dx = i % WIDTH - px;
        const int dy = i / WIDTH - py;
        if (std::abs(dx) > 5 || std::abs(dy) > 5 || !isWater[i]) continue;
        const auto luma = [i](const Picture& picture)
        {
            const glm::dvec3& colour = picture.colours[i];
            return 255.0 * (0.299 * colour.r + 0.587 * colour.g + 0.114 * colour.b);
        };
        window.push_back({std::exp(-(dx * dx + dy * dy) / (2.0 * 1.5 * 1.5)), luma(a), luma(b)});
        weights += window.back().weight;
    }
    double meanA = 0.0, meanB = 0.0;
    for (const Sample& sample : window)
    {
        meanA += sample.weight / weights * sample.a;
        meanB += sample.weight / weights * sample.b;
    }
    double varianceA = 0.0, varianceB = 0.0, covariance = 0.0;
    for (const Sample& sample : window)
    {
        varianceA += sample.weight / weights * std::pow(sample.a - meanA, 2.0);
        varianceB += sample.weight / weights * std::pow(sample.b - meanB, 2.0);
        covariance += sample.weight / weights * (sample.a - meanA) * (sample.b - meanB);
    }
    const double c1 = 2.55 * 2.55;
    const double c2 = 7.65 * 7.65;
    return (2.0 * meanA * meanB + c1) / (meanA * meanA + meanB * meanB + c1) *
           (2.0 * covariance + c2) / (varianceA + varianceB + c2);
}

} // namespace

TEST_CASE("picture error: of a picture and itself")
{
    const PictureError error = *comparePictures(noise(1), noise(1), waterBelow());
    CHECK(error.rmse == 0.0);
    CHECK_FALSE(error.psnr); // infinite
    CHECK(error.ssim == 1.0);
}

TEST_CASE("picture error: without water there is none")
{
    CHECK_FALSE(comparePictures(noise(1), noise(2), std::vector<std::uint8_t>(WIDTH * HEIGHT, 0)));
}

// Falls when the mean is taken over pixels only, not channels, and when 256 stands for 255.
TEST_CASE("picture error: a constant offset")
{
    const Picture a = noise(1);
    Picture b = a;
    for (glm::dvec3& colour : b.colours)
        colour += 10.0 / 255.0;
    const PictureError grey = *comparePictures(a, b, waterBelow());
    CHECK(grey.rmse == Approx(10.0));
    CHECK(*grey.psnr == Approx(28.1308036087)); // 20 log10(25.5)
    CHECK(grey.ssim < 1.0);

    b = a;
    for (glm::dvec3& colour : b.colours)
        colour.g -= 10.0 / 255.0;
    CHECK(comparePictures(a, b, waterBelow())->rmse == Approx(10.0 / std::sqrt(3.0)));
}

// Falls when the weights of a window over a border are not scaled.
TEST_CASE("picture error: the structural similarity of plain pictures is that of their means")
{
    const double a = 255.0 * 0.2;
    const double b = 255.0 * 0.6;
    const double c1 = 2.55 * 2.55;
    const double expected = (2.0 * a * b + c1) / (a * a + b * b + c1);
    CHECK(comparePictures(plain(0.2), plain(0.6), waterEverywhere())->ssim == Approx(expected));
    CHECK(comparePictures(plain(0.2), plain(0.6), waterBelow())->ssim == Approx(expected));
}

// Falls when the window is 9 pixels wide, when its Gaussian is of 1.4 pixels, when K2 is 0.01, and
// when luma is the channels' mean.
TEST_CASE("picture error: structural similarity by its definition")
{
    const Picture a = noise(1);
    Picture b = noise(2);
    for (int i = 0; i < WIDTH * HEIGHT; ++i)
        b.colours[i] = 0.3 * b.colours[i] + 0.7 * a.colours[i];
    for (const auto& isWater : {waterEverywhere(), waterBelow()})
    {
        double sum = 0.0;
        int count = 0;
        for (int i = 0; i < WIDTH * HEIGHT; ++i)
        {
            if (!isWater[i]) continue;
            sum += similarityAt(a, b, isWater, i % WIDTH, i / WIDTH);
            ++count;
        }
        CHECK(comparePictures(a, b, isWater)->ssim == Approx(sum / count).epsilon(1e-9));
        CHECK(sum / count < 0.95);
    }
}

// Falls when windows count what is no water.
TEST_CASE("picture error: only water pixels count")
{
    const Picture a = noise(1);
    const Picture b = noise(2);
    Picture other = b;
    const std::vector<std::uint8_t> isWater = waterBelow();
    for (int i = 0; i < WIDTH * HEIGHT; ++i)
        if (!isWater[i]) other.colours[i] = glm::dvec3(1.0, 0.0, 1.0);
    const PictureError error = *comparePictures(a, b, isWater);
    const PictureError otherError = *comparePictures(a, other, isWater);
    CHECK(error.rmse == otherError.rmse);
    CHECK(error.ssim == otherError.ssim);
}

TEST_CASE("picture error: pictures of images and of the truth")
{
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(2, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    for (unsigned int i = 0; i < 4; ++i)
        image->setColor(osg::Vec4(51 * i / 255.0f, 0, 1, 1), i % 2, i / 2);
    const Picture picture = pictureOf(*image);
    REQUIRE(picture.colours.size() == 4);
    for (int i = 0; i < 4; ++i)
        CHECK(glm::distance(picture.colours[i], glm::dvec3(0.2 * i, 0, 1)) < 1e-6);

    TruePixel own;
    own.pixel = 2;
    own.shadedColour = glm::dvec3(0.1, 0.2, 1.5); // brighter than a picture shows
    const Picture truth = withTruth(picture, {own});
    CHECK(glm::distance(truth.colours[2], glm::dvec3(0.1, 0.2, 1.0)) < 1e-12);
    CHECK(truth.colours[1] == picture.colours[1]);
}

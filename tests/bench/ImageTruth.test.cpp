// A search's own error: against an exhaustive search of the same image.

#include "WallCase.h"
#include "support/Catch.h"

#include <osgwaterbench/measures/SearchError.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

using namespace osgwaterbench;
using osgWaterReflect::reference::CapturedImage;
using osgWaterReflect::reference::ImageReason;

namespace
{

// The wall as an image of another size shows it, wider than the view by a guard band.
//   band  share of the view's size that is added on every side
CapturedImage captureWall(const WallCase& wall, double band, const glm::ivec2& size)
{
    CapturedImage capture;
    const double wider = 1.0 + 2.0 * band;
    capture.geometry.clipFromEye =
        glm::scale(glm::dmat4(1.0), glm::dvec3(1.0 / wider, 1.0 / wider, 1.0)) *
        wall.drawn.view.clipFromEye;
    capture.geometry.size = size;
    for (int i = 0; i < size.x * size.y; ++i)
    {
        const glm::dvec2 share = glm::dvec2(i % size.x + 0.5, i / size.x + 0.5) / glm::dvec2(size);
        const glm::dvec2 window = ((share - 0.5) * wider + 0.5) * wall.drawn.view.size;
        const glm::dvec3 way = placeAtWindow(wall.drawn, window, 1.0) - wall.view.eye;
        const glm::dvec3 place = wall.view.eye + way * (wall.distance / way.y);
        const bool seen = wall.onWall(place) && place.z >= 0.0;
        const glm::dvec3 placeEye(wall.drawn.eyeFromWorld * glm::dvec4(place, 1.0));
        capture.windowZ.push_back(
            seen ? static_cast<float>(capture.geometry.windowFromEye(placeEye).z) : 1.0f);
    }
    return capture;
}

Answers answersOf(const WallCase& wall, const ImageTruth& truth)
{
    Answers answers(wall.drawn.isWater.size());
    for (const ImagePixel& own : truth)
        answers[own.pixel] = {!own.found(), own.placeWorld, 0.0f};
    return answers;
}

} // namespace

// Falls when hits are taken for pixels of the view in a capture of another size.
TEST_CASE("image truth: what an image shows is found in it, whatever its size and guard band")
{
    WallCase wall;
    for (double band : {0.0, 0.25})
        for (const glm::ivec2& size : {glm::ivec2(160, 120), glm::ivec2(320, 240)})
        {
            INFO("band " << band << ", " << size.x << " x " << size.y);
            wall.drawn.capture = captureWall(wall, band, size);
            const ImageTruth truth = findImageTruth(wall.drawn, wall.thickness);
            REQUIRE(truth.size() == wall.truth.size());
            const SearchError error = compareSearch(wall.drawn, truth, wall.rightAnswers());
            CHECK(error.waterPixels == truth.size());
            REQUIRE(error.errorPixels);
            CHECK(error.errorPixels->count > 1000);
            // windowZ is in single precision: 6e-8 are 2.4e-4 m of 20 m, seen at 1 : 10.
            CHECK(error.errorPixels->median < 0.01);
            CHECK(error.errorPixels->p90 < 0.01);
            // At the wall's edges an image's pixel is all wall or none of it.
            CHECK(*error.disagreedPercent() < 4.0);
        }
}

// Falls when misses agree with places.
TEST_CASE("image truth: a search that does otherwise")
{
    WallCase wall;
    wall.drawn.capture = captureWall(wall, 0.0, {160, 120});
    const ImageTruth truth = findImageTruth(wall.drawn, wall.thickness);
    const Answers same = answersOf(wall, truth);
    std::size_t found = 0;
    for (const ImagePixel& own : truth)
        found += own.found();

    const SearchError none = compareSearch(wall.drawn, truth, same);
    CHECK(none.disagreedPercent() == 0.0);
    CHECK(none.errorPixels->p99 == 0.0);
    CHECK(none.errorPixels->count == found);

    Answers beside = same;
    Answers sky = same;
    Answers places = same;
    for (const ImagePixel& own : truth)
    {
        beside[own.pixel].placeWorld = wall.beside(own.placeWorld, {2.0, 0.0});
        sky[own.pixel].sky = true;
        places[own.pixel].sky = false;
    }
    const SearchError shifted = compareSearch(wall.drawn, truth, beside);
    CHECK(shifted.agreed == truth.size() - found);
    CHECK(shifted.errorPixels->median == Approx(2.0));
    const SearchError missed = compareSearch(wall.drawn, truth, sky);
    CHECK(missed.agreed == truth.size() - found);
    CHECK_FALSE(missed.errorPixels);
    const SearchError hit = compareSearch(wall.drawn, truth, places);
    CHECK(hit.agreed == found);
    CHECK(*hit.disagreedPercent() == Approx(100.0 * (truth.size() - found) / truth.size()));
    CHECK_FALSE(compareSearch(wall.drawn, {}, same).disagreedPercent());
}

TEST_CASE("image truth: answers where the exhaustive search ended behind something")
{
    const WallCase wall;
    const std::size_t pixel = wall.truth.front().pixel;
    const ImageTruth behind = {{pixel, ImageReason::BEHIND, glm::dvec3(0.0)}};
    Answers answers(wall.drawn.isWater.size());
    CHECK(compareSearch(wall.drawn, behind, answers).agreed == 1);
    CHECK(compareSearch(wall.drawn, behind, answers).answeredBehind == 0);
    answers[pixel].sky = false;
    CHECK(compareSearch(wall.drawn, behind, answers).agreed == 0);
    CHECK(compareSearch(wall.drawn, behind, answers).answeredBehind == 1);
}

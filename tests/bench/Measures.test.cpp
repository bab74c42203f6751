// What the benchmark counts, in cases where that is known.

#include "WallCase.h"
#include "support/Catch.h"

#include <osgwaterbench/measures/Measures.h>

#include <osg/Group>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace osgwaterbench;

namespace
{

Measures measureWall(const WallCase& wall, const Answers& answers)
{
    return measure(wall.drawn, wall.truth, answers, wall.thickness);
}

// The right answers, the places seen a number of pixels beside themselves.
Answers shifted(const WallCase& wall, const glm::dvec2& pixels)
{
    Answers answers = wall.rightAnswers();
    for (Answer& answer : answers)
        if (!answer.sky) answer.placeWorld = wall.beside(answer.placeWorld, pixels);
    return answers;
}

// Truth and answer at one pixel of water, made up.
struct OnePixel
{
    OnePixel() : drawn(drawStillWater(ViewAhead(), [](const glm::dvec3&) { return true; })) {}

    Outcome outcome(TrueClass trueClass, const glm::dvec3& truePlace, const glm::dvec3& shown) const
    {
        TruePixel own;
        own.pixel = 80;
        own.reflected.trueClass = trueClass;
        own.reflected.placeWorld = truePlace;
        Answers answers(drawn.isWater.size());
        answers[80] = {false, shown, 0.0f};
        const Measures measures = measure(drawn, {own}, answers, 0.5);
        const Tally& tally = measures.of(trueClass);
        REQUIRE(tally.total() == 1);
        const auto found = std::find(tally.counts.begin(), tally.counts.end(), 1);
        return static_cast<Outcome>(found - tally.counts.begin());
    }

    DrawnWater drawn;
};

} // namespace

TEST_CASE("percentiles are values that at least so many percent do not exceed")
{
    CHECK_FALSE(percentilesOf({}));
    const Percentiles one = *percentilesOf({7.0});
    CHECK((one.count == 1 && one.median == 7.0 && one.p90 == 7.0 && one.p99 == 7.0));

    std::vector<double> values(200);
    for (int i = 0; i < 200; ++i)
        values[i] = i + 1.0;
    std::shuffle(values.begin(), values.end(), std::mt19937(1));
    const Percentiles percentiles = *percentilesOf(values);
    CHECK(percentiles.count == 200);
    CHECK(percentiles.median == 100.0);
    CHECK(percentiles.p90 == 180.0);
    CHECK(percentiles.p99 == 198.0);
    CHECK(percentilesOf({3.0, 1.0, 2.0})->median == 2.0); // rank 1.5, rounded up
    CHECK(percentilesOf({3.0, 1.0, 2.0, 4.0})->median == 2.0);
    CHECK(percentilesOf({3.0, 1.0, 2.0, 4.0, 7.0, 5.0, 6.0})->p90 == 7.0); // rank 6.3
    CHECK(std::isinf(percentilesOf({1.0, std::numeric_limits<double>::infinity()})->p99));
}

TEST_CASE("measures: answers that are right everywhere")
{
    const WallCase wall;
    const Measures measures = measureWall(wall, wall.rightAnswers());
    CHECK(measures.of(TrueClass::VISIBLE).total() > 1000);
    CHECK(measures.of(TrueClass::SKY).total() > 1000);
    CHECK(measures.all().total() == wall.truth.size());
    CHECK(measures.all().percent(Outcome::CORRECT) == 100.0);
    CHECK(measures.of(TrueClass::VISIBLE).percent(Outcome::CORRECT) == 100.0);
    CHECK(measures.hitErrorPixels->count == measures.of(TrueClass::VISIBLE).total());
    CHECK(measures.hitErrorPixels->p99 < 1e-9);
    CHECK(measures.meanFetches == 8.0);

    // There are no pixels of other classes: their percentages are absent.
    for (TrueClass none : {TrueClass::HIDDEN, TrueClass::OUTSIDE_TOP, TrueClass::OUTSIDE_SIDES})
    {
        CHECK(measures.of(none).total() == 0);
        CHECK_FALSE(measures.of(none).percent(Outcome::CORRECT));
        CHECK(measures.percentOfWater(none, Outcome::CORRECT) == 0.0);
    }
}

// Falls when MATCH_PIXELS is 2.5 or 0.5, and when errors are given in the image's halves (as ndc).
TEST_CASE("measures: answers beside the true places")
{
    const WallCase wall;
    const struct
    {
        glm::dvec2 pixels;
        Outcome expected;
    } cases[] = {
        {{1, 0}, Outcome::CORRECT},         {{0, -1}, Outcome::CORRECT},
        {{1.06, 1.06}, Outcome::CORRECT},   // 1.499 px
        {{1.07, 1.07}, Outcome::MISPLACED}, // 1.513 px
        {{2, 0}, Outcome::MISPLACED},       {{0, 2}, Outcome::MISPLACED},
        {{-40, 0}, Outcome::MISPLACED},
    };
    for (const auto& item : cases)
    {
        INFO("by " << item.pixels.x << ", " << item.pixels.y);
        const Measures measures = measureWall(wall, shifted(wall, item.pixels));
        CHECK(measures.of(TrueClass::VISIBLE).percent(item.expected) == 100.0);
        CHECK(measures.of(TrueClass::SKY).percent(Outcome::CORRECT) == 100.0);
        const double error = glm::length(item.pixels);
        CHECK(measures.hitErrorPixels->median == Approx(error));
        CHECK(measures.hitErrorPixels->p99 == Approx(error));
    }
}

// Falls when a miss counts as misplaced, when false hits are counted among the errors of hits, and
// when fetches are averaged over all pixels of the view.
TEST_CASE("measures: some answers are turned into sky, some of the sky into places")
{
    const WallCase wall;
    Answers answers = wall.rightAnswers();
    std::size_t missed = 0;
    std::size_t falseHits = 0;
    std::size_t visible = 0;
    for (std::size_t i = 0; i < wall.truth.size(); ++i)
    {
        Answer& answer = answers[wall.truth[i].pixel];
        answer.fetches = i % 2 == 0 ? 10.0f : 20.0f;
        visible += !answer.sky;
        if (i % 4 == 0 && !answer.sky)
        {
            answer.sky = true;
            ++missed;
        }
        else if (i % 10 == 1 && answer.sky)
        {
            answer = {false, glm::dvec3(0.0, 20.0, 1.0), answer.fetches};
            ++falseHits;
        }
    }
    REQUIRE((missed > 100 && falseHits > 100));

    const Measures measures = measureWall(wall, answers);
    const std::size_t water = wall.truth.size();
    CHECK(measures.of(TrueClass::VISIBLE).count(Outcome::MISSED) == missed);
    CHECK(measures.of(TrueClass::VISIBLE).count(Outcome::CORRECT) == visible - missed);
    CHECK(measures.of(TrueClass::SKY).count(Outcome::FALSE_HIT) == falseHits);
    CHECK(*measures.of(TrueClass::SKY).percent(Outcome::FALSE_HIT) ==
          Approx(100.0 * falseHits / (water - visible)));
    CHECK(*measures.percentOfWater(TrueClass::VISIBLE, Outcome::MISSED) ==
          Approx(100.0 * missed / water));
    CHECK(measures.hitErrorPixels->count == visible - missed);
    CHECK(measures.hitErrorPixels->p99 < 1e-9);
    CHECK(*measures.meanFetches == Approx(15.0).margin(5.0 / water));
}

TEST_CASE("measures: over an empty scene every place is a false hit")
{
    WallCase wall;
    const osg::ref_ptr<osg::Node> nothing = new osg::Group;
    const osgWaterReflect::reference::SceneTracer scene(*nothing);
    const Truth truth = findTruth(wall.drawn, {scene, wall.sky, {}});
    const Answers answers = wall.rightAnswers();
    std::size_t places = 0;
    for (const Answer& answer : answers)
        places += !answer.sky;
    REQUIRE(places > 1000);
    const Measures measures = measure(wall.drawn, truth, answers, wall.thickness);
    CHECK(measures.of(TrueClass::SKY).count(Outcome::FALSE_HIT) == places);
    CHECK(measures.of(TrueClass::SKY).count(Outcome::CORRECT) == truth.size() - places);
    CHECK_FALSE(measures.of(TrueClass::VISIBLE).percent(Outcome::MISSED));
    CHECK_FALSE(measures.hitErrorPixels);
}

TEST_CASE("measures: without water nothing is measured")
{
    const WallCase wall;
    const Measures measures = measure(wall.drawn, {}, wall.rightAnswers(), wall.thickness);
    CHECK_FALSE(measures.all().percent(Outcome::CORRECT));
    CHECK_FALSE(measures.percentOfWater(TrueClass::SKY, Outcome::CORRECT));
    CHECK_FALSE(measures.hitErrorPixels);
    CHECK_FALSE(measures.meanFetches);
}

// Falls when showsPlace() looks at the window alone.
TEST_CASE("measures: what hides a place is not that place, though it is seen there")
{
    const OnePixel one;
    const glm::dvec2 window(90.0, 70.0);
    const auto at = [&](double depth) { return placeAtWindow(one.drawn, window, depth); };
    const glm::dvec3 place = at(20.0);
    for (TrueClass lost : {TrueClass::HIDDEN, TrueClass::OUTSIDE_TOP, TrueClass::OUTSIDE_SIDES})
    {
        CHECK(one.outcome(lost, place, place) == Outcome::CORRECT);
        CHECK(one.outcome(lost, place, at(10.0)) == Outcome::MISPLACED);
        CHECK(one.outcome(lost, place, at(40.0)) == Outcome::MISPLACED);
        // Within 0.5 m it may be the same thing's surface; 6 pixels' sides are 0.85 m there.
        CHECK(one.outcome(lost, place, at(19.6)) == Outcome::CORRECT);
        CHECK(one.outcome(lost, place, at(19.2)) == Outcome::CORRECT);
        CHECK(one.outcome(lost, place, at(19.1)) == Outcome::MISPLACED);
    }
    // Near by the thickness is what counts.
    CHECK(one.outcome(TrueClass::HIDDEN, at(2.0), at(2.4)) == Outcome::CORRECT);
    CHECK(one.outcome(TrueClass::HIDDEN, at(2.0), at(2.7)) == Outcome::MISPLACED);
    // What is visible is what the image shows there.
    CHECK(one.outcome(TrueClass::VISIBLE, place, at(10.0)) == Outcome::CORRECT);
}

// Falls when places behind the eye are projected like others.
TEST_CASE("measures: far out of the image an angle tells how far places are apart")
{
    const OnePixel one;
    const glm::dvec3 eye(0.0, 0.0, 2.0);
    // A pixel's angle about the view's axis: 2 tan(23 degrees) / 120.
    const double pixel = 2.0 * std::tan(glm::radians(23.0)) / 120.0;
    const auto behind = [&](double pixels)
    {
        const double angle = pixels * pixel;
        return eye + 10.0 * glm::dvec3(std::sin(angle), -std::cos(angle), 0.3);
    };
    const ViewPixels pixels(one.drawn);
    const double across = 1.0 / std::sqrt(1.0 + 0.3 * 0.3); // of a turn about the vertical
    CHECK(pixels.distance(behind(0.0), behind(4.0)) == Approx(4.0 * across).epsilon(1e-4));
    CHECK(one.outcome(TrueClass::OUTSIDE_SIDES, behind(0.0), behind(1.4 / across)) ==
          Outcome::CORRECT);
    CHECK(one.outcome(TrueClass::OUTSIDE_SIDES, behind(0.0), behind(1.6 / across)) ==
          Outcome::MISPLACED);
    // The opposite direction projects to the same place of the window.
    CHECK(pixels.distance(behind(0.0), 2.0 * eye - behind(0.0)) == Approx(std::acos(-1.0) / pixel));
    // Beside the image a little, pixels are those of the window.
    const auto at = [&](double x) { return placeAtWindow(one.drawn, {x, 60.0}, 10.0); };
    CHECK(pixels.distance(at(159.0), at(166.0)) == Approx(7.0));
    CHECK(pixels.distance(at(-70.0), at(220.0)) == Approx(290.0));
    CHECK(pixels.distance(at(80.0), at(80.0 + 1e6)) < 0.5 * std::acos(-1.0) / pixel);
    const double notANumber = std::numeric_limits<double>::quiet_NaN();
    CHECK(std::isinf(pixels.distance(at(80.0), glm::dvec3(notANumber))));
    CHECK(one.outcome(TrueClass::VISIBLE, at(80.0), glm::dvec3(notANumber)) == Outcome::MISPLACED);
    CHECK(pixels.pixelSide(eye + glm::dvec3(0.0, 3.0, 4.0)) == Approx(5.0 * pixel));
}

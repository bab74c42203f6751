// The water's own shader is made worse on purpose: every measure that is meant to has to tell.

#include "support/Catch.h"

#include <osgwaterbench/experiments/Measurement.h>

#include <osgWaterReflect/shaders/ShaderSource.h>

#include <map>

using namespace osgwaterbench;

namespace
{

// In which fetches are one for each column.
Method sequentialMethod()
{
    osgWaterReflect::WaterSettings settings;
    settings.capture = osgWaterReflect::CaptureKind::VIEW;
    settings.search = osgWaterReflect::Search::SEQUENTIAL;
    return libraryMethod("sequential", settings);
}

// The same with one line of a shader piece changed.
Method worsened(const std::string& piece, const std::string& line, const std::string& worse)
{
    Method method = sequentialMethod();
    std::string text = osgWaterReflect::embeddedShaders.at(piece);
    const std::size_t at = text.find(line);
    INFO("a line of " << piece << ": " << line);
    REQUIRE(at != std::string::npos);
    method.pieces[piece] = text.replace(at, line.size(), worse);
    return method;
}

// Of sighting.glsl.
const std::string FOUND = "sighting.result = searchImage(capture, sighting.ray);";

double percent(const Accuracy& accuracy, TrueClass trueClass, Outcome outcome)
{
    return accuracy.measures.of(trueClass).percent(outcome).value();
}

} // namespace

// Falls when a measure looks at something else than what the frame drew: at the settings, at the
// last method's frame, or at a picture without water.
TEST_CASE("a search that is made worse is caught by every measure meant to catch it")
{
    const std::optional<BenchScene> scene = createScene("boxes");
    REQUIRE(scene);
    const osg::ref_ptr<osgWaterReflect::WaveModel> waves = createWaves("boxes", 0.05);
    Measurement measurement(*scene, waves, glm::ivec2(160, 120));
    const Accuracy own = measurement.measure(sequentialMethod());
    const double ownRight = percent(own, TrueClass::VISIBLE, Outcome::CORRECT);
    const double ownDisagreed = own.search.value().disagreedPercent().value();
    REQUIRE(ownRight > 97.0);
    REQUIRE(percent(own, TrueClass::SKY, Outcome::FALSE_HIT) < 1.0);
    REQUIRE(own.measures.hitErrorPixels.value().median < 0.01);
    REQUIRE(ownDisagreed < 2.0);

    SECTION("hits are 3 px beside the place")
    {
        const Accuracy worse = measurement.measure(
            worsened("sighting.glsl", FOUND,
                     FOUND + " sighting.result.window.x = "
                             "min(sighting.result.window.x + 3.0, capture.size.x - 0.5);"));
        CHECK(percent(worse, TrueClass::VISIBLE, Outcome::MISPLACED) > 80.0);
        CHECK(worse.measures.hitErrorPixels.value().median == Approx(3.0).margin(0.1));
        CHECK(worse.search.value().disagreedPercent().value() > ownDisagreed + 20.0);
        CHECK(worse.picture.rmse > 1.1 * own.picture.rmse);
        CHECK(worse.picture.ssim < own.picture.ssim - 0.01);
        CHECK(worse.measures.meanFetches == own.measures.meanFetches);
    }
    SECTION("nothing is found")
    {
        const Accuracy worse = measurement.measure(
            worsened("sighting.glsl", FOUND, FOUND + " sighting.result.reason = REASON_SKY;"));
        CHECK(percent(worse, TrueClass::VISIBLE, Outcome::MISSED) == 100.0);
        CHECK(percent(worse, TrueClass::SKY, Outcome::CORRECT) == 100.0);
        CHECK(!worse.measures.hitErrorPixels);
        CHECK(worse.search.value().disagreedPercent().value() > ownDisagreed + 20.0);
        CHECK(worse.picture.psnr.value() < own.picture.psnr.value() - 3.0);
    }
    SECTION("whatever the ray passes behind is hit, without a thickness")
    {
        const std::optional<BenchScene> branched = createScene("boxes-branch");
        REQUIRE(branched);
        Measurement behind(*branched, waves, glm::ivec2(160, 120));
        const Accuracy thin = behind.measure(sequentialMethod());
        const Accuracy worse = behind.measure(
            worsened("search.glsl", "meeting.hit = behind <=", "meeting.hit = true || behind <="));
        CHECK(percent(thin, TrueClass::SKY, Outcome::FALSE_HIT) < 1.0);
        CHECK(percent(worse, TrueClass::SKY, Outcome::FALSE_HIT) > 50.0);
        // Colours are mixed of pixels as deep as the hit, so edges of the branch show what is
        // beside.
        CHECK(worse.picture.rmse > 1.05 * thin.picture.rmse);
    }
    SECTION("colours are darker, places the same")
    {
        const Accuracy worse = measurement.measure(
            worsened("reflection.glsl", "struct Reflection\n",
                     "#define finiteColour(c) (0.8 * finiteColour(c))\nstruct Reflection\n"));
        CHECK(percent(worse, TrueClass::VISIBLE, Outcome::CORRECT) == ownRight);
        CHECK(worse.picture.rmse > 1.1 * own.picture.rmse);
    }
    SECTION("depths are fetched twice")
    {
        const Accuracy worse = measurement.measure(
            worsened("search.glsl", "    COUNT_FETCH\n", "    COUNT_FETCH COUNT_FETCH\n"));
        CHECK(worse.measures.meanFetches.value() == Approx(2.0 * own.measures.meanFetches.value()));
        CHECK(worse.picture.rmse == own.picture.rmse);
    }
}

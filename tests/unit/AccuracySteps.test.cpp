// The cases fall when a step that changes nothing is kept, when a min() becomes an assignment, and
// when narrowBand() does not ask for the kind of band.

#include "support/Catch.h"

#include <osgWaterReflect/view/AccuracySteps.h>

using namespace osgWaterReflect;

namespace
{

WaterSettings most()
{
    WaterSettings settings;
    settings.capture = CaptureKind::VIEW_AND_MIRROR;
    settings.maxExtraPixels = 3.0;
    return settings;
}

// Pixels of a band over the view's, as far as the settings bound them.
double bandOf(const WaterSettings& settings)
{
    if (settings.guardBand == GuardBandKind::NONE || settings.capture == CaptureKind::MIRROR)
        return 0.0;
    return settings.guardBand == GuardBandKind::FIXED ? 100.0 : settings.maxExtraPixels;
}

bool isNoDearer(const WaterSettings& step, const WaterSettings& before)
{
    const bool capture =
        step.capture == before.capture ||
        (before.capture == CaptureKind::VIEW_AND_MIRROR && step.capture == CaptureKind::VIEW) ||
        (before.capture == CaptureKind::VIEW && step.capture == CaptureKind::FRAME);
    // A band comes with the copy that a mirrored image leaves its place to.
    if (before.capture == CaptureKind::MIRROR && step.capture == CaptureKind::FRAME)
        return step.captureScale <= before.captureScale && step.traceScale <= before.traceScale;
    return capture && step.captureScale <= before.captureScale &&
           step.traceScale <= before.traceScale && bandOf(step) <= bandOf(before);
}

} // namespace

TEST_CASE("accuracy is given up in a stated order")
{
    const std::vector<WaterSettings> steps = accuracySteps(most());
    REQUIRE(steps.size() == 7);
    WaterSettings expected = most();
    CHECK(steps[0] == expected);
    expected.capture = CaptureKind::VIEW;
    CHECK(steps[1] == expected);
    expected.capture = CaptureKind::FRAME;
    CHECK(steps[2] == expected);
    expected.traceScale = 0.5;
    CHECK(steps[3] == expected);
    expected.maxExtraPixels = 0.25;
    CHECK(steps[4] == expected);
    expected.captureScale = 0.5;
    CHECK(steps[5] == expected);
    expected.traceScale = 0.25;
    expected.guardBand = GuardBandKind::NONE;
    CHECK(steps[6] == expected);
}

TEST_CASE("each step of accuracy gives something up, and none asks for more, whatever was asked")
{
    WaterSettings asked;
    asked.search = Search::SEQUENTIAL;
    asked.thickness = 2.0;
    asked.stride = 3;
    asked.frameTimeTarget = 20.0;
    for (const CaptureKind capture : {CaptureKind::AUTOMATIC, CaptureKind::VIEW, CaptureKind::FRAME,
                                      CaptureKind::MIRROR, CaptureKind::VIEW_AND_MIRROR})
        for (const GuardBandKind band :
             {GuardBandKind::NONE, GuardBandKind::ADAPTIVE, GuardBandKind::FIXED})
            for (const double extra : {0.0, 0.1, 0.25, 1.0, 3.0})
                for (const double captureScale : {0.1, 0.5, 0.75, 1.0})
                    for (const double traceScale : {0.1, 0.25, 0.4, 0.5, 1.0})
                    {
                        asked.capture = capture;
                        asked.guardBand = band;
                        asked.maxExtraPixels = extra;
                        asked.captureScale = captureScale;
                        asked.traceScale = traceScale;
                        const std::vector<WaterSettings> steps = accuracySteps(asked);
                        REQUIRE(steps.front() == asked);
                        for (std::size_t i = 1; i < steps.size(); ++i)
                        {
                            REQUIRE(isNoDearer(steps[i], steps[i - 1]));
                            REQUIRE_FALSE(isNoDearer(steps[i - 1], steps[i]));
                            REQUIRE(steps[i].search == asked.search);
                            REQUIRE(steps[i].thickness == asked.thickness);
                            REQUIRE(steps[i].stride == asked.stride);
                            REQUIRE(steps[i].frameTimeTarget == asked.frameTimeTarget);
                        }
                    }
}

// Falls when bands are asked for with a mirrored capture alone.
TEST_CASE("a mirrored capture alone has no band to give up, and leaves its place to a copy late")
{
    WaterSettings asked;
    asked.capture = CaptureKind::MIRROR;
    asked.guardBand = GuardBandKind::NONE;
    const std::vector<WaterSettings> steps = accuracySteps(asked);
    REQUIRE(steps.size() ==
            5); // half the trace, half the capture, the copy, a quarter of the trace
    CHECK(steps[2].capture == CaptureKind::MIRROR);
    CHECK(steps[2].maxExtraPixels == asked.maxExtraPixels);
    CHECK(steps[3].capture == CaptureKind::FRAME);
}

TEST_CASE("where nothing can be given up there is one step of accuracy")
{
    WaterSettings asked;
    asked.capture = CaptureKind::FRAME;
    asked.guardBand = GuardBandKind::NONE;
    asked.captureScale = 0.5;
    asked.traceScale = 0.25;
    CHECK(accuracySteps(asked).size() == 1);
    asked.guardBand = GuardBandKind::ADAPTIVE;
    asked.maxExtraPixels = 0.0;
    CHECK(accuracySteps(asked).size() == 1);
}

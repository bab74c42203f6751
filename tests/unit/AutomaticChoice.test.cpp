// Each case falls with the rule that it names.

#include "support/Catch.h"

#include <osgWaterReflect/view/AutomaticChoice.h>

using namespace osgWaterReflect;

namespace
{

CaptureKind captureFor(bool calm, int planes, bool bandServes)
{
    SceneFacts facts;
    facts.calm = calm;
    facts.planes = planes;
    facts.bandServes = bandServes;
    return settle(WaterSettings(), facts).capture;
}

} // namespace

TEST_CASE("what is automatic is settled by calm, planes and band")
{
    for (const bool bandServes : {false, true})
    {
        CHECK(captureFor(true, 1, bandServes) == CaptureKind::MIRROR);
        for (const bool calm : {false, true})
            for (const int planes : {2, 3, 100})
                CHECK(captureFor(calm, planes, bandServes) == CaptureKind::VIEW);
    }
    CHECK(captureFor(false, 1, true) == CaptureKind::VIEW);
    CHECK(captureFor(false, 1, false) == CaptureKind::VIEW_AND_MIRROR);
    CHECK(settle(WaterSettings(), SceneFacts()).search == Search::HIERARCHICAL);
}

TEST_CASE("a scene that would be drawn with other shadows is copied from its frame, calm or not")
{
    SceneFacts facts;
    facts.redrawsAlike = false;
    for (const bool calm : {false, true})
        for (const int planes : {1, 2})
            for (const bool bandServes : {false, true})
            {
                facts.calm = calm;
                facts.planes = planes;
                facts.bandServes = bandServes;
                const WaterSettings settled = settle(WaterSettings(), facts);
                CHECK(settled.capture == CaptureKind::FRAME);
                CHECK(settled.guardBand == GuardBandKind::NONE);
            }
}

TEST_CASE("what was asked for is left alone, whatever is in view")
{
    WaterSettings asked;
    asked.thickness = 0.125;
    asked.captureScale = 0.75;
    asked.guardBand = GuardBandKind::FIXED;
    asked.frameTimeTarget = 12.0;
    for (const Search search : {Search::SEQUENTIAL, Search::BINARY, Search::HIERARCHICAL})
        for (const CaptureKind capture : {CaptureKind::VIEW, CaptureKind::FRAME,
                                          CaptureKind::MIRROR, CaptureKind::VIEW_AND_MIRROR})
            for (const bool calm : {false, true})
                for (const int planes : {0, 1, 2})
                    for (const bool bandServes : {false, true})
                        for (const bool redrawsAlike : {false, true})
                        {
                            asked.search = search;
                            asked.capture = capture;
                            SceneFacts facts;
                            facts.calm = calm;
                            facts.planes = planes;
                            facts.bandServes = bandServes;
                            facts.redrawsAlike = redrawsAlike;
                            REQUIRE(settle(asked, facts) == asked);
                        }
    asked.capture = CaptureKind::AUTOMATIC;
    WaterSettings expected = asked;
    expected.capture = CaptureKind::MIRROR;
    CHECK(settle(asked, SceneFacts()) == expected);
}

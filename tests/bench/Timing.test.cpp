#include "support/Catch.h"

#include <osgwaterbench/experiments/Timing.h>

using namespace osgwaterbench;

namespace
{

// Frames of known times: the warm-up's, which does not count, and then 3, 1, 2, 5, 4 times a unit.
TimedCase knownCase(const std::string& name, double unit, int& prepared)
{
    return {name, [&prepared] { ++prepared; },
            [unit, call = 0]() mutable
            {
                const double times[] = {1000.0, 3.0, 1.0, 2.0, 5.0, 4.0};
                const double time = unit * times[call++];
                return FrameTime{10.0 * time, time, 100.0 * time};
            }};
}

} // namespace

// Falls when the first frame counts, when one case's times go to another, when an image's time
// stands for the trace's, and when a median is a mean.
TEST_CASE("medians and quartiles of cases timed side by side are theirs")
{
    int prepared[] = {0, 0};
    const std::vector<CaseTime> times =
        timeSideBySide({knownCase("a", 1.0, prepared[0]), knownCase("b", 1000.0, prepared[1])}, 5);
    REQUIRE(times.size() == 2);
    const double units[] = {1.0, 1000.0};
    for (int i = 0; i < 2; ++i)
    {
        CHECK(prepared[i] == 6);
        CHECK(times[i].trace.median == Approx(3.0 * units[i]));
        CHECK(times[i].trace.lowerQuartile == Approx(2.0 * units[i]));
        CHECK(times[i].trace.upperQuartile == Approx(4.0 * units[i]));
        CHECK(times[i].image.median == Approx(30.0 * units[i]));
        CHECK(times[i].frame.median == Approx(300.0 * units[i]));
    }
}

#ifndef OSGWATERBENCH_TIMING_H
#define OSGWATERBENCH_TIMING_H

#include "../render/StageClock.h"

#include <functional>
#include <string>
#include <vector>

namespace osgwaterbench
{

/// One of several things whose times are compared.
struct TimedCase
{
    std::string name;
    std::function<void()> prepare;    ///< before each frame; its time does not count
    std::function<FrameTime()> frame; ///< renders one
};

/// [ms] of the frames of one case.
struct Spread
{
    double median = 0.0;
    double lowerQuartile = 0.0;
    double upperQuartile = 0.0;
};

struct CaseTime
{
    Spread image; ///< as in FrameTime
    Spread pyramid;
    Spread trace;
    Spread frame;
};

/// Times cases side by side, in one run and in random order, by Google Benchmark: what else the
/// machine does meanwhile falls on all of them alike. Each is rendered once before it counts.
///   frames  >= 1; of each case
/// Progress is shown on standard error.
std::vector<CaseTime> timeSideBySide(const std::vector<TimedCase>& cases, int frames);

} // namespace osgwaterbench

#endif

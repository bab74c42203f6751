#include "Timing.h"

#include "Progress.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

using namespace osgwaterbench;

namespace
{

const char* const LOWER_QUARTILE = "p25";
const char* const UPPER_QUARTILE = "p75";
const char* const IMAGE = "image";
const char* const PYRAMID = "pyramid";
const char* const FRAME = "frame";

// The value at a share of a sorted list, straight between its two neighbours.
double quantile(std::vector<double> values, double share)
{
    std::sort(values.begin(), values.end());
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - std::floor(place)) * (values[above] - values[below]);
}

double lowerQuartile(const std::vector<double>& values)
{
    return quantile(values, 0.25);
}

double upperQuartile(const std::vector<double>& values)
{
    return quantile(values, 0.75);
}

double* valueOf(Spread& spread, const std::string& aggregate)
{
    if (aggregate == "median") return &spread.median;
    if (aggregate == LOWER_QUARTILE) return &spread.lowerQuartile;
    if (aggregate == UPPER_QUARTILE) return &spread.upperQuartile;
    return nullptr;
}

// Takes Google Benchmark's statistics; its benchmarks are named by the index of their case.
class Collector : public benchmark::BenchmarkReporter
{
public:
    explicit Collector(std::size_t count) : times(count) {}
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override
    {
        for (const Run& run : runs)
        {
            if (run.run_type != Run::RT_Aggregate) continue;
            CaseTime& time = times[std::stoul(run.run_name.function_name)];
            double* const trace = valueOf(time.trace, run.aggregate_name);
            if (!trace) continue;
            *trace = run.GetAdjustedRealTime();
            *valueOf(time.image, run.aggregate_name) = run.counters.at(IMAGE);
            *valueOf(time.pyramid, run.aggregate_name) = run.counters.at(PYRAMID);
            *valueOf(time.frame, run.aggregate_name) = run.counters.at(FRAME);
        }
    }

    std::vector<CaseTime> times;
};

void setFlags()
{
    std::string program = "osgwaterbench";
    std::string interleaved = "--benchmark_enable_random_interleaving=true";
    char* arguments[] = {program.data(), interleaved.data()};
    int count = 2;
    benchmark::Initialize(&count, arguments);
}

} // namespace

std::vector<CaseTime> osgwaterbench::timeSideBySide(const std::vector<TimedCase>& cases, int frames)
{
    setFlags();
    benchmark::ClearRegisteredBenchmarks();
    Progress progress("timing", cases.size() * (frames + 1));
    for (const TimedCase& timed : cases)
    {
        progress.step(timed.name);
        timed.prepare();
        timed.frame();
    }
    for (std::size_t i = 0; i < cases.size(); ++i)
    {
        const auto run = [&timed = cases[i], &progress](benchmark::State& state)
        {
            progress.step(timed.name);
            timed.prepare();
            for ([[maybe_unused]] auto iteration : state)
            {
                const FrameTime time = timed.frame();
                state.SetIterationTime(1e-3 * time.trace);
                state.counters[IMAGE] = time.image;
                state.counters[PYRAMID] = time.pyramid;
                state.counters[FRAME] = time.frame;
            }
        };
        // One repetition gives no statistics: at least two.
        benchmark::RegisterBenchmark(std::to_string(i).c_str(), run)
            ->Iterations(1)
            ->Repetitions(std::max(frames, 2))
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond)
            ->ComputeStatistics(LOWER_QUARTILE, lowerQuartile)
            ->ComputeStatistics(UPPER_QUARTILE, upperQuartile);
    }
    Collector collector(cases.size());
    benchmark::RunSpecifiedBenchmarks(&collector, ".*");
    benchmark::ClearRegisteredBenchmarks();
    return collector.times;
}

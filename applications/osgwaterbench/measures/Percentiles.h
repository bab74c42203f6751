#ifndef OSGWATERBENCH_PERCENTILES_H
#define OSGWATERBENCH_PERCENTILES_H

#include <cstddef>
#include <optional>
#include <vector>

namespace osgwaterbench
{

/// How an error is spread, in its own unit. The percentile p is the smallest of the values that at
/// least p % of them do not exceed: always one of them [Hyndman96, definition 1].
struct Percentiles
{
    std::size_t count = 0;
    double median = 0.0;
    double p90 = 0.0;
    double p99 = 0.0;
};

/// None of no values. They may be infinite but not NaN.
std::optional<Percentiles> percentilesOf(std::vector<double> values);

} // namespace osgwaterbench

#endif

#include "Percentiles.h"

#include <algorithm>

namespace
{

double percentile(std::vector<double>& values, std::size_t percent)
{
    // The rank from 1 is percent * count / 100, rounded up; in whole numbers, so exactly.
    const std::size_t rank = (percent * values.size() + 99) / 100;
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

} // namespace

std::optional<osgwaterbench::Percentiles> osgwaterbench::percentilesOf(std::vector<double> values)
{
    if (values.empty()) return std::nullopt;
    return Percentiles{values.size(), percentile(values, 50), percentile(values, 90),
                       percentile(values, 99)};
}

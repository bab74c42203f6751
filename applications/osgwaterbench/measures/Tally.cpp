#include "Tally.h"

#include <numeric>

using namespace osgwaterbench;

std::optional<double> osgwaterbench::percentOf(std::size_t part, std::size_t whole)
{
    if (whole == 0) return std::nullopt;
    return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::size_t Tally::total() const
{
    return std::accumulate(counts.begin(), counts.end(), std::size_t(0));
}

std::optional<double> Tally::percent(Outcome outcome) const
{
    return percentOf(count(outcome), total());
}

Tally& Tally::operator+=(const Tally& other)
{
    for (int i = 0; i < OUTCOME_COUNT; ++i)
        counts[i] += other.counts[i];
    return *this;
}

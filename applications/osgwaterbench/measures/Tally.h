#ifndef OSGWATERBENCH_TALLY_H
#define OSGWATERBENCH_TALLY_H

#include <array>
#include <cstddef>
#include <optional>

namespace osgwaterbench
{

/// How an answer stands to the truth.
enum class Outcome
{
    CORRECT,   ///< the true place, or the sky for the sky
    MISPLACED, ///< another place of the scene
    MISSED,    ///< the sky in place of the scene
    FALSE_HIT  ///< the scene in place of the sky
};

const int OUTCOME_COUNT = 4;

/// 100 part / whole; none of nothing.
std::optional<double> percentOf(std::size_t part, std::size_t whole);

/// How often each outcome came about.
struct Tally
{
    std::array<std::size_t, OUTCOME_COUNT> counts{};

    std::size_t count(Outcome outcome) const { return counts[static_cast<int>(outcome)]; }
    std::size_t total() const;
    std::optional<double> percent(Outcome outcome) const; ///< of the total; none where that is 0

    Tally& operator+=(const Tally& other);
};

} // namespace osgwaterbench

#endif

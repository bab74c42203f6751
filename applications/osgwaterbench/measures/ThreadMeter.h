#ifndef OSGWATERBENCH_THREADMETER_H
#define OSGWATERBENCH_THREADMETER_H

#include "Allocations.h"
#include "InstructionCounter.h"

#include <optional>

namespace osgwaterbench
{

/// What a thread spends on something.
struct ThreadCost
{
    double cpuMicroseconds = 0.0; ///< while it runs: not what others on the machine take from it
    Allocations allocations;
    std::optional<double> instructions; ///< none where they cannot be counted
};

/// Measures what the thread that made it does between two moments.
class ThreadMeter
{
public:
    ThreadMeter();

    void start();

    /// Since the start, without what reading the clock takes.
    ThreadCost read() const;

private:
    InstructionCounter _instructions;
    std::optional<std::uint64_t> _instructionsBefore;
    Allocations _allocationsBefore;
    double _cpuBefore = 0.0; // [us]
    double _clockCost = 0.0; // [us]
};

} // namespace osgwaterbench

#endif

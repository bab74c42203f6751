#include "ThreadMeter.h"

#include "Percentiles.h"

#include <ctime>
#include <vector>

using namespace osgwaterbench;

namespace
{

const int EMPTY_READINGS = 101; // an odd number, for their median

double cpuMicroseconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

} // namespace

ThreadMeter::ThreadMeter()
{
    std::vector<double> costs;
    for (int i = 0; i < EMPTY_READINGS; ++i)
    {
        start();
        costs.push_back(read().cpuMicroseconds);
    }
    _clockCost = percentilesOf(costs)->median;
}

// The clock is the last to be read before, and the first after.
void ThreadMeter::start()
{
    _instructionsBefore = _instructions.read();
    _allocationsBefore = allocationsOfThread();
    _cpuBefore = cpuMicroseconds();
}

ThreadCost ThreadMeter::read() const
{
    ThreadCost cost;
    cost.cpuMicroseconds = cpuMicroseconds() - _cpuBefore - _clockCost;
    const Allocations allocations = allocationsOfThread();
    cost.allocations.count = allocations.count - _allocationsBefore.count;
    cost.allocations.bytes = allocations.bytes - _allocationsBefore.bytes;
    const std::optional<std::uint64_t> instructions = _instructions.read();
    if (instructions && _instructionsBefore)
        cost.instructions = static_cast<double>(*instructions - *_instructionsBefore);
    return cost;
}

#ifndef OSGWATERBENCH_ALLOCATIONS_H
#define OSGWATERBENCH_ALLOCATIONS_H

#include <cstdint>

namespace osgwaterbench
{

/// What operator new was asked for.
struct Allocations
{
    std::uint64_t count = 0;
    std::uint64_t bytes = 0;
};

/// Of the thread that asks, since it began, OSG's own allocations included. A program that calls it
/// has operator new replaced by one that counts.
Allocations allocationsOfThread();

} // namespace osgwaterbench

#endif

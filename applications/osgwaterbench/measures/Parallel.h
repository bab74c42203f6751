#ifndef OSGWATERBENCH_PARALLEL_H
#define OSGWATERBENCH_PARALLEL_H

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace osgwaterbench
{

/// Calls work(i) once for each i in [0, count), on all cores and in no order. What is written to an
/// element of the i's own does not depend on how many cores there are.
template <class Work>
void inParallel(std::size_t count, const Work& work)
{
    const std::size_t block = 256; // microseconds of work, so that handing it out costs nothing
    std::atomic<std::size_t> next{0};
    const auto workThrough = [&]
    {
        for (std::size_t first = next.fetch_add(block); first < count;
             first = next.fetch_add(block))
            for (std::size_t i = first; i < std::min(first + block, count); ++i)
                work(i);
    };
    std::vector<std::future<void>> others;
    for (unsigned int i = 1; i < std::thread::hardware_concurrency(); ++i)
        others.push_back(std::async(std::launch::async, workThrough));
    workThrough();
    for (std::future<void>& other : others)
        other.get();
}

} // namespace osgwaterbench

#endif

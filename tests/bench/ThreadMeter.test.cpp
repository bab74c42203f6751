#include "support/Catch.h"

#include <osgwaterbench/measures/ThreadMeter.h>

#include <osg/Group>

#include <chrono>
#include <new>
#include <thread>

using namespace osgwaterbench;

namespace
{

// By the functions themselves: compilers may leave out what new and delete expressions allocate.
void allocate(std::size_t bytes)
{
    ::operator delete(::operator new(bytes));
}

} // namespace

// Falls when a call is not counted, when its size is not, and when what was before the start is.
TEST_CASE("allocations between start and read are counted with their sizes")
{
    ThreadMeter meter;
    allocate(1000);
    meter.start();
    allocate(100);
    allocate(20);
    ::operator delete(::operator new(64, std::align_val_t(64)), std::align_val_t(64));
    const ThreadCost cost = meter.read();
    CHECK(cost.allocations.count == 3);
    CHECK(cost.allocations.bytes == 184);
}

// Falls when only the program's own operator new is replaced: a Group's list of children grows
// within OSG's library.
TEST_CASE("allocations within OSG's libraries are counted")
{
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    const osg::ref_ptr<osg::Group> child = new osg::Group;
    ThreadMeter meter;
    meter.start();
    group->addChild(child);
    CHECK(meter.read().allocations.count >= 1);
}

// Falls when counts are the process's.
TEST_CASE("what other threads allocate is not counted")
{
    ThreadMeter meter;
    std::thread idle([] {});
    idle.join();
    meter.start();
    std::thread idler([] {});
    idler.join();
    const Allocations ofThread = meter.read().allocations;
    meter.start();
    std::thread busy(
        []
        {
            for (int i = 0; i < 100; ++i)
                allocate(1000);
        });
    busy.join();
    CHECK(meter.read().allocations.count == ofThread.count);
}

// Falls when time is the wall's, and when it is in another unit: a thread that waits for 50 ms
// spends a small part of it, one that works until its processor's time is 5 ms on at least that.
TEST_CASE("a thread's time passes while it works")
{
    ThreadMeter meter;
    meter.start();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    CHECK(meter.read().cpuMicroseconds < 10000.0);

    const std::clock_t begin = std::clock();
    meter.start();
    while (std::clock() - begin < 5 * CLOCKS_PER_SEC / 1000)
    {
    }
    const double spent = meter.read().cpuMicroseconds;
    CHECK(spent > 2500.0);
    CHECK(spent < 50000.0);
}

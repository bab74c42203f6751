#include "InstructionCounter.h"

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

using namespace osgwaterbench;

namespace
{

// perf_event_open(2), which the C library does not wrap.
int openInstructions()
{
    perf_event_attr attributes{};
    attributes.size = sizeof attributes;
    attributes.type = PERF_TYPE_HARDWARE;
    attributes.config = PERF_COUNT_HW_INSTRUCTIONS;
    attributes.exclude_kernel = 1;
    attributes.exclude_hv = 1;
    const pid_t thisThread = 0;
    const int anyProcessor = -1, noGroup = -1;
    return static_cast<int>(syscall(SYS_perf_event_open, &attributes, thisThread, anyProcessor,
                                    noGroup, PERF_FLAG_FD_CLOEXEC));
}

} // namespace

InstructionCounter::InstructionCounter() : _event(openInstructions()) {}

InstructionCounter::~InstructionCounter()
{
    if (_event >= 0) close(_event);
}

std::optional<std::uint64_t> InstructionCounter::read() const
{
    std::uint64_t count = 0;
    if (_event < 0 || ::read(_event, &count, sizeof count) != sizeof count) return std::nullopt;
    return count;
}

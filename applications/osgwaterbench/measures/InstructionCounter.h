#ifndef OSGWATERBENCH_INSTRUCTIONCOUNTER_H
#define OSGWATERBENCH_INSTRUCTIONCOUNTER_H

#include <cstdint>
#include <optional>

namespace osgwaterbench
{

/// Counts the instructions that the thread which made it retires outside the kernel.
class InstructionCounter
{
public:
    InstructionCounter();
    ~InstructionCounter();
    InstructionCounter(const InstructionCounter&) = delete;
    InstructionCounter& operator=(const InstructionCounter&) = delete;

    /// So far. None where the machine has no such counter or the kernel does not lend it, as in
    /// many virtual machines.
    std::optional<std::uint64_t> read() const;

private:
    int _event; // a file descriptor, or -1
};

} // namespace osgwaterbench

#endif

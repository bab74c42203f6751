#include "Allocations.h"

#include <cstdlib>
#include <new>

namespace
{

thread_local osgwaterbench::Allocations ofThread;

void* counted(void* memory, std::size_t size)
{
    if (!memory) throw std::bad_alloc();
    ++ofThread.count;
    ofThread.bytes += size;
    return memory;
}

} // namespace

// The standard's other forms, of arrays and those that do not throw, call these.

void* operator new(std::size_t size)
{
    return counted(std::malloc(size), size);
}

void* operator new(std::size_t size, std::align_val_t alignment)
{
    // aligned_alloc asks for a multiple.
    const auto unit = static_cast<std::size_t>(alignment);
    return counted(std::aligned_alloc(unit, (size + unit - 1) / unit * unit), size);
}

void operator delete(void* memory) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
    std::free(memory);
}

osgwaterbench::Allocations osgwaterbench::allocationsOfThread()
{
    return ofThread;
}

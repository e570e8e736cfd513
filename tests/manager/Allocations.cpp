#include "Allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<std::size_t> allocationCount = 0;
} // namespace

namespace Lixel::Tests {

std::size_t allocations() {
    return allocationCount;
}

bool countsAllocations() {
#ifdef __SANITIZE_ADDRESS__
    return false;
#else
    return true;
#endif
}

} // namespace Lixel::Tests

#ifndef __SANITIZE_ADDRESS__

// Found before the standard library's, by all libraries.
__attribute__((visibility("default"))) void* operator new(std::size_t size) {
    ++allocationCount;
    if (void* const memory = std::malloc(size != 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}

__attribute__((visibility("default"))) void operator delete(void* memory) noexcept {
    std::free(memory);
}

__attribute__((visibility("default"))) void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

#endif

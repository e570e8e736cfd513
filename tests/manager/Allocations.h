#pragma once

#include <cstddef>

namespace Lixel::Tests {

/// Whether this build counts allocations: not with the address sanitizer, which has its own.
bool countsAllocations();

/// By `new`, of all libraries, so far.
std::size_t allocations();

} // namespace Lixel::Tests

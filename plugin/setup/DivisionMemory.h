#pragma once

#include "fit/parts/LightPartition.h"

namespace Lixel {

/** What dividing a light into several maps remembers, for each light and viewer, and its scratch
    space. A setup that remembers more derives its own. */
struct DivisionMemory {
    DivisionMemory() = default;
    DivisionMemory(const DivisionMemory&) = delete;
    DivisionMemory& operator=(const DivisionMemory&) = delete;
    virtual ~DivisionMemory() = default;

    AimScratch aim;
};

} // namespace Lixel

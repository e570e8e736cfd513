#pragma once

#include "fit/parts/CascadeMemory.h"
#include "fit/parts/LightPartition.h"

namespace Lixel {

/// What a division of a light into several maps remembers, for each light and viewer.
struct DivisionMemory {
    AimScratch aim;
    CascadeMemory cascades;
    std::vector<double> vsSplits;
};

} // namespace Lixel

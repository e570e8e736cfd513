#pragma once

#include "fit/parts/LightPartition.h"
#include "scene/Fingerprint.h"

#include <optional>

namespace Lixel {

/** What dividing a light into several maps remembers, for each light and viewer, and its scratch
    space. A setup that remembers more derives its own. */
struct DivisionMemory {
    DivisionMemory() = default;
    DivisionMemory(const DivisionMemory&) = delete;
    DivisionMemory& operator=(const DivisionMemory&) = delete;
    virtual ~DivisionMemory() = default;

    /// Adds all that may have the next frame's parts be others.
    virtual void addMemory(Fingerprint&) const {}

    AimScratch aim;
    /// Where the last map's cone was aimed at that serves a part of its light. @see widestSpot
    std::optional<Vec3> wsAimAxis;
};

} // namespace Lixel

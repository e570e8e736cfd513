#pragma once

#include "fit/parts/CascadeMemory.h"
#include "fit/parts/LightPartition.h"

#include <span>
#include <string>
#include <vector>

/// How a light is shared among maps, in all the ways that setups do.
namespace Lixel::Test {

/// What a division keeps from frame to frame, and room for its work.
struct DivisionRoom {
    CascadeMemory memory;
    CascadeScratch cascades;
    std::vector<double> vsSplits;
    AimScratch aiming;
    FocusScratch focusing;
    FocusRegion region;
};

struct Division {
    const char* name;
    /// Whether it is for point lights, and not for those that a problem comes with.
    bool point;
    LightPartition (*divide)(const ShadowProblem& problem, DivisionRoom& room);
};

/// Slices of the view, strips of the light, the better of both, faces of the view for either kind of light, cubes, aimed spots.
std::span<const Division> divisions();

/// The division of that name. @throws std::out_of_range where there is none
const Division& divisionNamed(const std::string& name);

} // namespace Lixel::Test

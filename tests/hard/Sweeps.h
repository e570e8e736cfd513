#pragma once

#include "HardScene.h"

#include <functional>
#include <string>
#include <vector>

namespace Lixel::Tests {

/// A light or a viewer that turns through a direction at which a shadow map may jump.
struct Sweep {
    std::string name;
    /// Places bodies, viewer and light.
    std::function<void(HardScene&)> build;
    /// Turns light or viewer to an angle in radians, 0 at the singular direction.
    std::function<void(HardScene&, double angle)> turn;
};

/** Through every direction that is special to the viewer, the light, or the axes of the world.

    All are over the same field: nine boxes on one flat ground. Within 0.1 radians none of them
    comes into a view or a cone, or leaves it: maps may then change at once.
*/
const std::vector<Sweep>& sweeps();

} // namespace Lixel::Tests

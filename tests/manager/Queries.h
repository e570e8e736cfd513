#pragma once

#include "World.h"

#include "../stress/Random.h"

#include <string>
#include <vector>

namespace Lixel::Tests {

/// What the scene manager answers to queries of all kinds at random places, as sorted text: boxes,
/// spheres, volumes, rays (with distances, to the last bit), intersections, and lights by distance.
std::vector<std::string> answers(World& world, Random random);

} // namespace Lixel::Tests

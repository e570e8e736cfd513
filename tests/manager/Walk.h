#pragma once

#include "Managers.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace Lixel::Tests {

/** A walk of two scene managers through the same operations, with a frame and a comparison after
    each few. What a step does follows from the seed, its number and what is there, and not from the
    other steps' chances: steps can be left out. */
struct Walk {
    std::string reference;
    std::string candidate;
    std::uint64_t seed = 1;
    std::vector<std::size_t> steps;
    /// Whether queries are compared.
    bool asks = true;
};

/// Steps 0 to `count` - 1.
std::vector<std::size_t> allSteps(std::size_t count);

struct WalkEnd {
    /// The first difference; empty where there is none.
    std::string difference;
    std::size_t step = 0;
    /// What was done, step by step.
    std::vector<std::string> deeds;
    /// How often each operation found something to be done to.
    std::map<std::string, std::size_t> done;
    std::size_t sights = 0;
    std::size_t queued = 0;  ///< renderables in the sights compared
    std::size_t answers = 0; ///< to queries, compared
};

WalkEnd go(const Walk& walk);

/// Leaves out steps as long as the rest still ends in a difference.
Walk shrink(const Walk& walk);

/// A failed walk for people: the difference, and the deeds of a short walk that ends in one.
std::string story(const Walk& walk);

} // namespace Lixel::Tests

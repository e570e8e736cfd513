#pragma once

#include "Check.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Lixel::Tests {

/// Deeds that follow from a seed. Each step's deed depends on the step's number and on what is
/// there, and not on the other steps' random numbers: steps can be left out.
struct Sequence {
    std::uint64_t seed = 1;
    std::vector<std::size_t> steps;
    std::size_t checkEvery = 2; ///< frames
    bool verbose = false;
    /// Where the picture of a wrong shadow is written, as PPM; empty for nowhere.
    std::string pictureFile{};
};

struct SequenceEnd {
    bool failed = false;
    std::size_t step = 0;
    std::string what;
    std::vector<std::string> lastDeeds; ///< up to 20, with their steps
    std::size_t deeds = 0;
    std::size_t frames = 0;
    CheckCounts counts;
};

/// Runs the sequence in a process of its own, so that a crash is an end like any other.
SequenceEnd runSequence(const Sequence& sequence);

} // namespace Lixel::Tests

#pragma once

#include "fit/Problems.h"
#include "fit/core/FitState.h"
#include "fit/problem/Technique.h"
#include "fit/technique/PlaneOptimal.h"

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

/// What tests try that all techniques pass.
namespace Lixel::Test {

/// A technique with options.
struct Trial {
    std::string name;
    const FitTechnique* technique = nullptr;
    std::shared_ptr<void> options;

    /// Whether whatever is seen has a place in the map. Exact plane optimal says what has none.
    bool servesAll() const;
    /// Plane optimal gets the plane under all receivers.
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept;
};

std::ostream& operator<<(std::ostream& out, const Trial& trial);

/// Every technique with its default options, with each of its flags the other way, and with
/// each share that is 0 by default at 1.
const std::vector<Trial>& trials();

/// Those of the trials that serve all that is seen.
std::vector<Trial> trialsThatServeAll();

/// The same with options drawn at random: from all over their ranges, and from near their ends.
Trial drawn(const Trial& trial, Dice& dice);

/// The trial of that name. @throws std::out_of_range where there is none
const Trial& trialNamed(const std::string& name);

/// The plane under all receivers, for the technique that wants one.
PlaneOptimalOptions groundOf(const ShadowProblem& problem);

} // namespace Lixel::Test

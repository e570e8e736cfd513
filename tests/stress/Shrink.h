#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace Lixel::Tests {

/** Leaves out steps of a failing walk as long as the rest still fails.

    @param walk has `steps`, ascending numbers; what a step does must not depend on the others' chances
    @param failsAt gives the step at which a walk fails, or none
*/
template <typename Walk, typename FailsAt>
Walk leaveOutSteps(Walk walk, const FailsAt& failsAt) {
    const auto endAt = [](Walk& one, std::size_t last) {
        std::erase_if(one.steps, [last](std::size_t step) { return step > last; });
    };
    if (const std::optional<std::size_t> last = failsAt(walk)) endAt(walk, *last);
    for (std::size_t piece = walk.steps.size() / 2; piece > 0; piece /= 2)
        for (std::size_t at = 0; at + piece <= walk.steps.size();) {
            Walk less = walk;
            const auto from = less.steps.begin() + static_cast<std::ptrdiff_t>(at);
            less.steps.erase(from, from + static_cast<std::ptrdiff_t>(piece));
            if (const std::optional<std::size_t> last = failsAt(less)) {
                endAt(less, *last);
                walk = less;
            } else {
                at += piece;
            }
        }
    return walk;
}

} // namespace Lixel::Tests

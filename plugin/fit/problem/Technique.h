#pragma once

#include "fit/problem/Option.h"
#include "fit/problem/ShadowFit.h"
#include "fit/problem/ShadowProblem.h"

#include <concepts>
#include <memory>

namespace Lixel {
/// @addtogroup LixelFit
/// @{

struct FitState;

/** A technique: its name and options, and how it makes one map of a problem.

    A technique's structure of options has a static member `technique()` that gives this: so the
    structure's type stands for the technique. @see Techniques.h for all of them
*/
struct FitTechnique {
    std::string_view name;  ///< in lists, scripts and on command lines, such as "XPSM"
    std::string_view title; ///< one line for people
    std::string_view paper; ///< author and year
    std::span<const Option> options;
    /// A structure of its options with their defaults, or a copy of another.
    std::shared_ptr<void> (*makeOptions)(const void* like);
    /// @param options a structure of its own options
    ShadowFit (*fit)(const ShadowProblem& problem, const void* options, FitState& state) noexcept;
};

/// A structure of a technique's options.
template <typename Options>
concept TechniqueOptions = requires {
    { Options::technique() } -> std::same_as<const FitTechnique&>;
};

/// Makes one map by the technique of these options.
/// @return a map, or the reason why there is none. @see ShadowFit
template <TechniqueOptions Options>
ShadowFit fitMap(const ShadowProblem& problem, const Options& options, FitState& state) noexcept {
    return Options::technique().fit(problem, &options, state);
}

/// @}
} // namespace Lixel

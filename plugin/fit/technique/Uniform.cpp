#include "fit/technique/Uniform.h"

#include "fit/core/Declare.h"
#include "fit/rule/StableUniform.h"

#include <array>

namespace Lixel {
namespace {

WarpChoice uniformWarp(const WarpContext& context, const UniformOptions& options, RuleState state) {
    return options.stable ? stableMap(context, state) : WarpChoice{};
}

} // namespace

const FitTechnique& UniformOptions::technique() {
    static constexpr std::array options{
        option<&UniformOptions::stable>(
            "stable",
            "texels that stay where they are in the world while the viewer turns and moves, "
            "instead of a map that is focused: set a shadow distance with it, or use it for the "
            "slices of cascades"),
    };
    static constexpr FitTechnique declared = declare<UniformOptions, uniformWarp>(
        "Uniform", "uniform, focused on visible receivers", "Williams 1978", options);
    return declared;
}

} // namespace Lixel

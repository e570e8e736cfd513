#pragma once

#include "fit/core/Fit.h"
#include "fit/problem/Technique.h"

/** Declaring a technique: what its source file says of it once. */
namespace Lixel {

/** A technique from its rule: a function of a WarpContext and its options, and of a RuleState where
    it remembers something or needs room.

        const FitTechnique& XpsmOptions::technique() {
            static constexpr FitTechnique declared = declare<XpsmOptions, xpsmWarp>(
                "XPSM", "extended perspective shadow map", "Gusev 2007", Declared);
            return declared;
        }

    @param options must outlive the technique
*/
template <typename Options, auto rule>
constexpr FitTechnique declare(std::string_view name, std::string_view title,
                               std::string_view paper, std::span<const Option> options) {
    FitTechnique technique;
    technique.name = name;
    technique.title = title;
    technique.paper = paper;
    technique.options = options;
    technique.makeOptions = [](const void* like) -> std::shared_ptr<void> {
        return like != nullptr ? std::make_shared<Options>(*static_cast<const Options*>(like))
                               : std::make_shared<Options>();
    };
    technique.fit = [](const ShadowProblem& problem, const void* given,
                       FitState& state) noexcept -> ShadowFit {
        const Options& own = *static_cast<const Options*>(given);
        return fitWithRule(problem, state, [&](const WarpContext& context, RuleState memory) {
            if constexpr (std::invocable<decltype(rule), const WarpContext&, const Options&,
                                         RuleState>)
                return rule(context, own, memory);
            else
                return rule(context, own);
        });
    };
    return technique;
}

} // namespace Lixel

#include "Trials.h"

#include "fit/technique/Techniques.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <stdexcept>

namespace Lixel::Test {
namespace {

/// Counts are what a technique may spend: larger ones only take longer.
constexpr double GreatestCount = 300.0;

/// A number from 0 to 1, which says how much there is of something.
bool isShare(const Option& option) {
    return option.type == OptionType::Number && option.range.least == 0.0 &&
           option.range.greatest == 1.0 && !option.range.isLeastOpen &&
           !option.range.isGreatestOpen;
}

/// A number of an option's range: every third time near one of its ends.
double drawNumber(const Option& option, Dice& dice) {
    const OptionRange& range = option.range;
    const double greatest =
        option.type == OptionType::Count ? std::min(range.greatest, GreatestCount) : range.greatest;
    const double small = std::pow(10.0, dice.in(-6.0, -1.0));
    if (!std::isfinite(greatest))
        return range.least +
               (dice.chance(0.1) && !range.isLeastOpen ? 0.0 : std::pow(10.0, dice.in(-6.0, 6.0)));
    const double width = greatest - range.least;
    switch (dice.below(6)) {
    case 0:
        return range.isLeastOpen ? range.least + small * width : range.least;
    case 1:
        return range.isGreatestOpen ? greatest - small * width : greatest;
    default:
        return range.least + dice.in(0.01, 0.99) * width;
    }
}

} // namespace

PlaneOptimalOptions groundOf(const ShadowProblem& problem) {
    double lowest = std::numeric_limits<double>::infinity();
    if (problem.receivers != nullptr)
        for (const Aabb& box : problem.receivers->boxes())
            lowest = std::min(lowest, box.centre.y() - box.halfExtents.y());
    PlaneOptimalOptions options;
    if (std::isfinite(lowest)) options.wsPlane.w() = -lowest;
    return options;
}

bool Trial::servesAll() const {
    return technique != &PlaneOptimalOptions::technique() ||
           !static_cast<const PlaneOptimalOptions*>(options.get())->exact;
}

ShadowFit Trial::fit(const ShadowProblem& problem, FitState& state) const noexcept {
    if (technique != &PlaneOptimalOptions::technique())
        return technique->fit(problem, options.get(), state);
    PlaneOptimalOptions own = *static_cast<const PlaneOptimalOptions*>(options.get());
    own.wsPlane = groundOf(problem).wsPlane;
    return fitMap(problem, own, state);
}

std::ostream& operator<<(std::ostream& out, const Trial& trial) {
    return out << trial.name;
}

const std::vector<Trial>& trials() {
    static const std::vector<Trial> all = [] {
        std::vector<Trial> made;
        for (const FitTechnique* const technique : techniques()) {
            const std::string name(technique->name);
            made.push_back({name, technique, technique->makeOptions(nullptr)});
            for (const Option& option : technique->options) {
                const auto options = technique->makeOptions(nullptr);
                const bool isOn = optionNumber(option, options.get()) != 0.0;
                if (option.type != OptionType::Flag && (isOn || !isShare(option))) continue;
                setOptionNumber(option, options.get(), isOn ? 0.0 : 1.0);
                std::string variant = name + (isOn ? "_not_" : "_");
                variant += option.keyword;
                made.push_back({variant, technique, options});
            }
        }
        return made;
    }();
    return all;
}

std::vector<Trial> trialsThatServeAll() {
    std::vector<Trial> all;
    std::ranges::copy_if(trials(), std::back_inserter(all), &Trial::servesAll);
    return all;
}

Trial drawn(const Trial& trial, Dice& dice) {
    Trial result = trial;
    result.options = trial.technique->makeOptions(trial.options.get());
    for (const Option& option : trial.technique->options) {
        if (option.type != OptionType::Count && option.type != OptionType::Number) continue;
        setOptionNumber(option, result.options.get(), drawNumber(option, dice));
        result.name += ' ';
        result.name += option.keyword;
        result.name += '=';
        result.name += optionText(option, result.options.get());
    }
    return result;
}

const Trial& trialNamed(const std::string& name) {
    const auto found = std::ranges::find(trials(), name, &Trial::name);
    if (found == trials().end()) throw std::out_of_range("there is no trial " + name);
    return *found;
}

} // namespace Lixel::Test

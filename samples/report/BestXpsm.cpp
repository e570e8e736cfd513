#include "report/BestXpsm.h"

#include <Lixel/setup/ShadowCameraSetups.h>

#include <fmt/core.h>

#include <array>
#include <memory>

namespace Lixel::Samples {
namespace {

/// From hardly any warp to one that eq. (3) bounds nearly everywhere, by factors of two.
constexpr std::array<float, 7> Strengths{0.25F, 0.5F, 1.0F, 2.0F, 4.0F, 8.0F, 16.0F};
constexpr std::array<float, 4> EpsilonsW{0.3F, 0.5F, 0.7F, 0.9F};

/// Where in the list of setups they are; those of the grid follow.
enum Column : std::size_t { Uniform, Optimal, Default, FirstOfGrid };

NamedSetup xpsm(float strength, float epsilonW, bool guarded) {
    NamedSetup setup;
    setup.name = fmt::format("{} {:>5} {:>3}", guarded ? "guarded" : "literal", strength, epsilonW);
    setup.title = "Lixel: extended perspective shadow map, with constants";
    setup.create = [=] {
        return XPSMShadowCameraSetup::create(
            {.strength = strength, .epsilonW = epsilonW, .guarded = guarded});
    };
    return setup;
}

std::vector<NamedSetup> setupsToTry() {
    std::vector<NamedSetup> setups;
    for (const char* const name : {"Uniform", "Optimal", "XPSM"})
        setups.push_back(*findShadowSetup(name));
    for (const bool guarded : {true, false})
        for (const float strength : Strengths)
            for (const float epsilonW : EpsilonsW)
                setups.push_back(xpsm(strength, epsilonW, guarded));
    return setups;
}

GeometricMean meanError(const SomeCases& cases, std::size_t setup) {
    std::vector<double> errors;
    for (const TableCase* one : cases)
        errors.push_back(errorForRatio(*one, setup));
    return geometricMean(errors);
}

/// The setup of the grid with the least mean error.
std::size_t bestFor(const SomeCases& cases, std::size_t setupCount) {
    std::size_t best = FirstOfGrid;
    for (std::size_t i = FirstOfGrid; i < setupCount; ++i)
        if (meanError(cases, i).mean < meanError(cases, best).mean) best = i;
    return best;
}

} // namespace

void printBestXpsm(TableOptions options) {
    options.setups = setupsToTry();
    const std::size_t count = options.setups.size();
    std::vector<TableCase> cases = measureTable(options);
    // The best of each scene becomes one more column.
    for (TableCase& one : cases)
        one.errors.push_back({});
    const SomeCases telling = tellingCases(cases, Uniform);

    fmt::print("XPSM with the constants (strength, epsilonW) that are best for each scene, of {}: "
               "geometric means of errors in %\n\n{:<12} {:>5} {:>8} {:>8} {:>8} {:>8}  {}\n",
               count - FirstOfGrid, "scene", "cases", "Uniform", "XPSM", "best", "Optimal",
               "constants");
    std::string last;
    for (const TableCase& first : cases) {
        if (first.scene == last) continue;
        last = first.scene;
        const SomeCases scene =
            among(telling, [&](const TableCase& one) { return one.scene == first.scene; });
        const std::size_t best = bestFor(scene, count);
        for (TableCase& one : cases)
            if (one.scene == first.scene) one.errors.back() = one.errors[best];
        fmt::print("{:<12} {:>5}", first.scene, scene.size());
        for (const std::size_t setup :
             {std::size_t{Uniform}, std::size_t{Default}, best, std::size_t{Optimal}})
            fmt::print(" {:>8}", describePercent(meanError(scene, setup)));
        // Without a case, none of the constants is the best.
        fmt::print("  {}\n", scene.empty() ? "-" : options.setups[best].name);
    }

    const std::size_t anywhere = bestFor(telling, count);
    fmt::print("\nRatio of Optimal: paired geometric mean with its 95 % interval; the one set of "
               "constants that is best over all scenes is {}\n\n{:<8} {:>5} {:>22} {:>22} {:>22}\n",
               telling.empty() ? "-" : options.setups[anywhere].name, "", "cases",
               "to the best of a scene", "to the best of all", "to XPSM");
    for (const auto& [name, some] : groupsOf(telling))
        fmt::print("{:<8} {:>5} {:>22} {:>22} {:>22}\n", name, some.size(),
                   describe(ratioOf(some, Optimal, count)),
                   describe(ratioOf(some, Optimal, anywhere)),
                   describe(ratioOf(some, Optimal, Default)));
}

} // namespace Lixel::Samples

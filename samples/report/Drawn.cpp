#include "report/Drawn.h"

#include "report/Contenders.h"

#include <fmt/core.h>

#include <algorithm>

namespace Lixel::Samples {
namespace {

/// The cases that were drawn, with either errors; a case has the same index in both.
struct BothWays {
    explicit BothWays(const std::vector<TableCase>& cases) {
        for (const TableCase& one : cases) {
            if (one.drawnErrors.empty()) continue;
            emulated.push_back(one);
            drawn.push_back(one);
            drawn.back().errors = one.drawnErrors;
        }
    }

    std::vector<TableCase> emulated;
    std::vector<TableCase> drawn;
};

SomeCases allOf(const std::vector<TableCase>& cases) {
    return casesWhere(cases, [](const TableCase&) { return true; });
}

/// Of drawn errors to emulated ones.
GeometricMean drawnToEmulated(const BothWays& both, std::size_t setup) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < both.drawn.size(); ++i)
        if (std::max(both.drawn[i].errors[setup].error, both.emulated[i].errors[setup].error) >=
            LeastBaseline)
            ratios.push_back(errorForRatio(both.drawn[i], setup) /
                             errorForRatio(both.emulated[i], setup));
    return geometricMean(ratios);
}

std::string nameOf(const SetupPair& pair, char sign) {
    return fmt::format("{} {} {}", pair.setup, sign, pair.than);
}

/// Of the longest name, in characters.
std::size_t widthOf(const std::vector<SetupPair>& pairs) {
    std::size_t width = 20;
    for (const SetupPair& pair : pairs)
        width = std::max(width, nameOf(pair, '/').size());
    return width;
}

void printRatios(const BothWays& both, const std::vector<SetupPair>& pairs) {
    const std::size_t width = widthOf(pairs);
    fmt::print("\nRatio of errors in these cases: paired geometric mean with its 95 % interval; "
               "those in which both err less than {} %, drawn and emulated, are left out\n\n"
               "{:<{}} {:>5} {:>24} {:>24}\n",
               LeastBaseline, "", width, "cases", "emulated", "drawn");
    for (const SetupPair& pair : pairs) {
        SomeCases emulated;
        SomeCases drawn;
        for (std::size_t i = 0; i < both.drawn.size(); ++i) {
            if (!isTelling(both.emulated[i], pair) && !isTelling(both.drawn[i], pair)) continue;
            emulated.push_back(&both.emulated[i]);
            drawn.push_back(&both.drawn[i]);
        }
        fmt::print("{:<{}} {:>5} {:>24} {:>24}\n", nameOf(pair, '/'), width, drawn.size(),
                   describe(ratioOf(emulated, pair.first, pair.second)),
                   describe(ratioOf(drawn, pair.first, pair.second)));
    }
}

} // namespace

void printDrawn(const TableOptions& options, const std::vector<TableCase>& cases) {
    const BothWays both(cases);
    if (both.drawn.empty()) return;
    std::size_t width = 20;
    for (const NamedSetup& setup : options.setups)
        width = std::max(width, setup.name.size());
    fmt::print("\nDrawn: one case in {}, {} of {}. Mean errors in %, and the paired geometric mean "
               "of their ratios with its 95 % interval\n\n{:<{}} {:>8} {:>8} {:>24}\n",
               options.drawn, both.drawn.size(), cases.size(), "setup", width, "emulated", "drawn",
               "drawn / emulated");
    for (std::size_t i = 0; i < options.setups.size(); ++i) {
        const auto error = [i](const TableCase& one) { return one.errors[i].error; };
        fmt::print("{:<{}} {:>8.3f} {:>8.3f} {:>24}\n", options.setups[i].name, width,
                   meanOf(allOf(both.emulated), error), meanOf(allOf(both.drawn), error),
                   describe(drawnToEmulated(both, i)));
    }
}

void printDrawnClaims(const TableOptions& options, const std::vector<TableCase>& cases) {
    const Contenders contenders(options.setups);
    BothWays both(cases);
    if (both.drawn.empty()) return;
    both.emulated = contenders.withBest(std::move(both.emulated));
    both.drawn = contenders.withBest(std::move(both.drawn));
    printRatios(both, contenders.ratios());

    const std::vector<SetupPair> losses = contenders.losses();
    const std::size_t width = widthOf(losses);
    fmt::print("\nHow many of these {} cases are worse\n\n{:<{}} {:>8} {:>8}\n", both.drawn.size(),
               "", width, "emulated", "drawn");
    for (const SetupPair& pair : losses)
        fmt::print("{:<{}} {:>8} {:>8}\n", nameOf(pair, '>'), width,
                   countWorse(allOf(both.emulated), pair), countWorse(allOf(both.drawn), pair));
}

void printDrawnRatios(const TableOptions& options, const std::vector<TableCase>& cases) {
    const BothWays both(cases);
    if (both.drawn.empty()) return;
    std::vector<SetupPair> pairs;
    for (std::size_t i = 1; i < options.setups.size(); ++i)
        pairs.push_back({options.setups[i].name, options.setups[0].name, i, 0});
    printRatios(both, pairs);
}

} // namespace Lixel::Samples

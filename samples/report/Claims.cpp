#include "report/Claims.h"

#include "report/Contenders.h"

#include <fmt/core.h>

namespace Lixel::Samples {
namespace {

/// All, suns, lamps, what is by seed, and each scene.
std::vector<CaseGroup> kindsOf(const std::vector<TableCase>& cases) {
    const auto where = [&](const auto& filter) { return casesWhere(cases, filter); };
    std::vector<CaseGroup> groups{{"all", where([](const TableCase&) { return true; })},
                                  {"suns", where([](const TableCase& one) { return one.sun; })},
                                  {"lamps", where([](const TableCase& one) { return !one.sun; })},
                                  {"by seed", where([](const TableCase& one) {
                                       const SampleScene* const scene = findSampleScene(one.scene);
                                       return scene != nullptr && scene->bySeed;
                                   })}};
    for (const TableCase& first : cases)
        if (groups.back().name != first.scene)
            groups.push_back({first.scene, where([&](const TableCase& one) {
                                  return one.scene == first.scene;
                              })});
    return groups;
}

/// @param sign between both names of a pair
template <typename Cell>
void printByKind(const std::vector<CaseGroup>& kinds, const std::vector<SetupPair>& pairs,
                 const std::string& sign, int width, const Cell& cell) {
    fmt::print("{:<12} {:>5}", "", "");
    for (const SetupPair& pair : pairs)
        fmt::print(" {:>{}}", pair.setup + " " + sign, width);
    fmt::print("\n{:<12} {:>5}", "kind", "cases");
    for (const SetupPair& pair : pairs)
        fmt::print(" {:>{}}", pair.than, width);
    fmt::print("\n");
    for (const CaseGroup& kind : kinds) {
        fmt::print("{:<12} {:>5}", kind.name, kind.cases.size());
        for (const SetupPair& pair : pairs)
            fmt::print(" {:>{}}", cell(kind.cases, pair), width);
        fmt::print("\n");
    }
}

} // namespace

void printClaims(const TableOptions& options, const std::vector<TableCase>& cases) {
    const Contenders contenders(options.setups);
    const std::vector<TableCase> all = contenders.withBest(cases);
    const std::vector<CaseGroup> kinds = kindsOf(all);

    fmt::print("\nClaims by kind of scene: ratio of errors, paired geometric mean with its 95 % "
               "interval, {}x{} pixels, maps of {}x{} texels; cases in which both err less than "
               "{} % are left out\n\n",
               options.width, options.height, options.mapSize, options.mapSize, LeastBaseline);
    printByKind(kinds, contenders.ratios(), "/", 22,
                [](const SomeCases& some, const SetupPair& pair) {
                    const SomeCases telling =
                        among(some, [&](const TableCase& one) { return isTelling(one, pair); });
                    return describe(ratioOf(telling, pair.first, pair.second));
                });

    fmt::print("\nCases that are worse, by more than {:.0f} % and {} percentage points; best "
               "other: of Uniform and OGRE's setups of one map\n\n",
               100.0 * WorseByPart, WorseByPoints);
    printByKind(kinds, contenders.losses(), ">", 13, countWorse);
}

} // namespace Lixel::Samples

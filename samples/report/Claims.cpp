#include "report/Claims.h"

#include "common/Stage.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace Lixel::Samples {
namespace {

constexpr std::size_t WorstCases = 10;

std::size_t indexOf(const std::vector<NamedSetup>& setups, const std::string& name) {
    const auto found = std::ranges::find(setups, name, &NamedSetup::name);
    if (found == setups.end()) throw std::invalid_argument("no setup '" + name + "' was measured");
    return static_cast<std::size_t>(found - setups.begin());
}

bool isOgres(const NamedSetup& setup) {
    return setup.name.starts_with("Ogre-");
}

/// The setups of a table that claims are about, by their indices.
struct Contenders {
    explicit Contenders(const std::vector<NamedSetup>& setups)
        : uniform(indexOf(setups, "Uniform")),
          xpsm(indexOf(setups, "XPSM")),
          optimal(indexOf(setups, "Optimal")),
          liSPSM(indexOf(setups, "Ogre-LiSPSM")),
          liSPSMFactorOne(indexOf(setups, "Ogre-LiSPSM-1")),
          liSPSMOptimal(indexOf(setups, "Ogre-LiSPSM-Optimal")),
          splits(indexOf(setups, "Ogre-PSSM-3")),
          twoSlices(indexOf(setups, "Cascades-2")),
          threeSlices(indexOf(setups, "Cascades-3")) {
        others.push_back(uniform);
        for (std::size_t i = 0; i < setups.size(); ++i) {
            if (setups[i].maps > 1) continue;
            if (isOgres(setups[i]))
                others.push_back(i);
            else if (findShadowSetup(setups[i].name) != nullptr)
                techniques.push_back(i);
        }
    }

    std::size_t uniform;
    std::size_t xpsm;
    std::size_t optimal;
    std::size_t liSPSM;
    std::size_t liSPSMFactorOne;
    std::size_t liSPSMOptimal;
    std::size_t splits;
    std::size_t twoSlices;
    std::size_t threeSlices;
    std::vector<std::size_t> techniques; ///< Lixel's, of one map
    std::vector<std::size_t> others;     ///< Uniform, and OGRE's of one map
};

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

/// The mean ratio of two setups' errors, without the cases in which neither errs noticeably.
std::string describeTelling(const SomeCases& cases, std::size_t setup, std::size_t than) {
    const SomeCases telling = among(cases, [&](const TableCase& one) {
        return std::max(one.errors[setup].error, one.errors[than].error) >= LeastBaseline;
    });
    return describe(ratioOf(telling, setup, than));
}

struct Comparison {
    std::string setup;
    std::string than;
    std::size_t first;
    std::size_t second;
};

template <typename Cell>
void printByKind(const std::vector<CaseGroup>& kinds, const std::vector<Comparison>& comparisons,
                 int width, const Cell& cell) {
    fmt::print("{:<12} {:>5}", "", "");
    for (const Comparison& one : comparisons)
        fmt::print(" {:>{}}", one.setup, width);
    fmt::print("\n{:<12} {:>5}", "kind", "cases");
    for (const Comparison& one : comparisons)
        fmt::print(" {:>{}}", one.than, width);
    fmt::print("\n");
    for (const CaseGroup& kind : kinds) {
        fmt::print("{:<12} {:>5}", kind.name, kind.cases.size());
        for (const Comparison& one : comparisons)
            fmt::print(" {:>{}}", cell(kind.cases, one), width);
        fmt::print("\n");
    }
}

/// Draws a case, and paints what is wrong with it.
std::string commandFor(const TableOptions& options, const TableCase& one,
                       const std::string& setup) {
    const std::string scene = findSampleScene(one.scene) == nullptr
                                  ? "--scene '" + options.modelFile + "'"
                                  : "--sample " + one.scene;
    const std::string picture = fmt::format("{}-{}-{}-{}", one.scene, one.view, one.light, setup);
    return fmt::format("{}/lixel-browser --headless {} --view {} --light {} --setup {} --map {} "
                       "--size {}x{} --output {}.png --comparison {}-errors.png",
                       programFolder(), scene, one.viewNumber, one.light, setup, options.mapSize,
                       options.width, options.height, picture, picture);
}

void printWorst(const TableOptions& options, const std::vector<TableCase>& cases,
                const Contenders& contenders, std::size_t setup) {
    struct Loss {
        const TableCase* one;
        std::size_t best;
        double ratio;
    };
    std::vector<Loss> losses;
    for (const TableCase& one : cases) {
        const std::size_t best = bestOf(one, contenders.others);
        const double ratio = errorForRatio(one, setup) / errorForRatio(one, best);
        if (one.errors[setup].error - one.errors[best].error > WorseByPoints && ratio > 1.0)
            losses.push_back({&one, best, ratio});
    }
    std::ranges::stable_sort(losses, std::greater(), &Loss::ratio);
    losses.resize(std::min(losses.size(), WorstCases));
    const std::string& name = options.setups[setup].name;
    fmt::print("\nThe worst cases of {} beside the best of Uniform and OGRE's setups of one map: "
               "ratio, errors in %, why the fit is as it is\n\n",
               name);
    for (const auto& [one, best, ratio] : losses) {
        const auto error = [&](std::size_t i) { return one->errors[i].error; };
        fmt::print("{:.2f}  {}, {}, {}: Optimal {:.3f}, XPSM {:.3f}, Uniform {:.3f}, best {} "
                   "{:.3f}; {}\n      {}\n",
                   ratio, one->scene, one->view, one->light, error(contenders.optimal),
                   error(contenders.xpsm), error(contenders.uniform), options.setups[best].name,
                   error(best), one->reasons[setup], commandFor(options, *one, name));
    }
}

} // namespace

bool isWorse(const ClassificationError& error, const ClassificationError& than) {
    return error.error > (1.0 + WorseByPart) * than.error &&
           error.error > than.error + WorseByPoints;
}

std::size_t bestOf(const TableCase& one, const std::vector<std::size_t>& setups) {
    return *std::ranges::min_element(setups, {},
                                     [&](std::size_t i) { return one.errors[i].error; });
}

void printClaims(const TableOptions& options, const std::vector<TableCase>& cases) {
    const Contenders c(options.setups);
    // The best in each case become two more columns.
    const std::size_t bestTechnique = options.setups.size();
    const std::size_t bestOther = bestTechnique + 1;
    std::vector<TableCase> all = cases;
    for (TableCase& one : all) {
        const ClassificationError technique = one.errors[bestOf(one, c.techniques)];
        const ClassificationError other = one.errors[bestOf(one, c.others)];
        one.errors.insert(one.errors.end(), {technique, other});
    }
    const std::vector<CaseGroup> kinds = kindsOf(all);

    fmt::print("\nClaims by kind of scene: ratio of errors, paired geometric mean with its 95 % "
               "interval, {}x{} pixels, maps of {}x{} texels; cases in which both err less than "
               "{} % are left out\n\n",
               options.width, options.height, options.mapSize, options.mapSize, LeastBaseline);
    printByKind(kinds,
                {{"Optimal /", "Ogre-LiSPSM", c.optimal, c.liSPSM},
                 {"Optimal /", "Ogre-LiSPSM-1", c.optimal, c.liSPSMFactorOne},
                 {"Optimal /", "Ogre-LiSPSM-Optimal", c.optimal, c.liSPSMOptimal},
                 {"Optimal /", "best of Lixel's", c.optimal, bestTechnique},
                 {"Cascades-2 /", "Ogre-PSSM-3", c.twoSlices, c.splits}},
                22, [](const SomeCases& some, const Comparison& one) {
                    return describeTelling(some, one.first, one.second);
                });

    fmt::print("\nCases that are worse, by more than {:.0f} % and {} percentage points; best "
               "other: of Uniform and OGRE's setups of one map\n\n",
               100.0 * WorseByPart, WorseByPoints);
    printByKind(kinds,
                {{"Optimal >", "best other", c.optimal, bestOther},
                 {"XPSM >", "best other", c.xpsm, bestOther},
                 {"Optimal >", "Uniform", c.optimal, c.uniform},
                 {"XPSM >", "Uniform", c.xpsm, c.uniform},
                 {"Cascades-2 >", "Optimal", c.twoSlices, c.optimal},
                 {"Cascades-3 >", "Optimal", c.threeSlices, c.optimal}},
                13, [](const SomeCases& some, const Comparison& one) {
                    return std::ranges::count_if(some, [&](const TableCase* each) {
                        return isWorse(each->errors[one.first], each->errors[one.second]);
                    });
                });

    for (const std::size_t setup : {c.optimal, c.xpsm})
        printWorst(options, cases, c, setup);
}

} // namespace Lixel::Samples

#include "report/Contenders.h"

#include <algorithm>
#include <stdexcept>

namespace Lixel::Samples {
namespace {

std::size_t indexOf(const std::vector<NamedSetup>& setups, const std::string& name) {
    const auto found = std::ranges::find(setups, name, &NamedSetup::name);
    if (found == setups.end()) throw std::invalid_argument("no setup '" + name + "' was measured");
    return static_cast<std::size_t>(found - setups.begin());
}

bool isOgres(const NamedSetup& setup) {
    return setup.name.starts_with("Ogre-");
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

bool isTelling(const TableCase& one, const SetupPair& pair) {
    return std::max(one.errors[pair.first].error, one.errors[pair.second].error) >= LeastBaseline;
}

std::size_t countWorse(const SomeCases& cases, const SetupPair& pair) {
    return static_cast<std::size_t>(std::ranges::count_if(cases, [&](const TableCase* one) {
        return isWorse(one->errors[pair.first], one->errors[pair.second]);
    }));
}

Contenders::Contenders(const std::vector<NamedSetup>& setups)
    : uniform(indexOf(setups, "Uniform")),
      xpsm(indexOf(setups, "XPSM")),
      optimal(indexOf(setups, "Optimal")),
      liSPSM(indexOf(setups, "Ogre-LiSPSM")),
      liSPSMFactorOne(indexOf(setups, "Ogre-LiSPSM-1")),
      liSPSMOptimal(indexOf(setups, "Ogre-LiSPSM-Optimal")),
      splits(indexOf(setups, "Ogre-PSSM-3")),
      twoSlices(indexOf(setups, "Cascades-2")),
      threeSlices(indexOf(setups, "Cascades-3")),
      bestTechnique(setups.size()),
      bestOther(setups.size() + 1) {
    others.push_back(uniform);
    for (std::size_t i = 0; i < setups.size(); ++i) {
        if (setups[i].maps > 1) continue;
        if (isOgres(setups[i]))
            others.push_back(i);
        else if (findShadowSetup(setups[i].name) != nullptr)
            techniques.push_back(i);
    }
}

std::vector<TableCase> Contenders::withBest(std::vector<TableCase> cases) const {
    for (TableCase& one : cases) {
        const ClassificationError technique = one.errors[bestOf(one, techniques)];
        const ClassificationError other = one.errors[bestOf(one, others)];
        one.errors.insert(one.errors.end(), {technique, other});
    }
    return cases;
}

std::vector<SetupPair> Contenders::ratios() const {
    return {{"Optimal", "Ogre-LiSPSM", optimal, liSPSM},
            {"Optimal", "Ogre-LiSPSM-1", optimal, liSPSMFactorOne},
            {"Optimal", "Ogre-LiSPSM-Optimal", optimal, liSPSMOptimal},
            {"Optimal", "best of Lixel's", optimal, bestTechnique},
            {"Cascades-2", "Ogre-PSSM-3", twoSlices, splits}};
}

std::vector<SetupPair> Contenders::losses() const {
    return {{"Optimal", "best other", optimal, bestOther},
            {"XPSM", "best other", xpsm, bestOther},
            {"Optimal", "Uniform", optimal, uniform},
            {"XPSM", "Uniform", xpsm, uniform},
            {"Cascades-2", "Optimal", twoSlices, optimal},
            {"Cascades-3", "Optimal", threeSlices, optimal}};
}

} // namespace Lixel::Samples

#include "report/WorstCases.h"

#include "common/Stage.h"
#include "report/Contenders.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <functional>

namespace Lixel::Samples {
namespace {

constexpr std::size_t MostListed = 10;

/// A case in which a setup errs more than the best other.
struct Loss {
    const TableCase* one;
    std::size_t best;
    double ratio;
};

/// The worst first.
std::vector<Loss> lossesOf(const std::vector<TableCase>& cases, const Contenders& contenders,
                           std::size_t setup) {
    std::vector<Loss> losses;
    for (const TableCase& one : cases) {
        const std::size_t best = bestOf(one, contenders.others);
        const double ratio = errorForRatio(one, setup) / errorForRatio(one, best);
        if (one.errors[setup].error - one.errors[best].error > WorseByPoints && ratio > 1.0)
            losses.push_back({&one, best, ratio});
    }
    std::ranges::stable_sort(losses, std::greater(), &Loss::ratio);
    losses.resize(std::min(losses.size(), MostListed));
    return losses;
}

/// Draws a case, and paints what is wrong with it.
std::string commandFor(const TableOptions& options, const TableCase& one,
                       const std::string& setup) {
    const std::string scene = findSampleScene(one.scene) == nullptr
                                  ? "--scene '" + options.modelFile + "'"
                                  : "--sample " + one.scene;
    const std::string picture = pictureName(one, setup);
    return fmt::format("{}/lixel-browser --headless {} --view {} --light {} --setup {} --map {} "
                       "--size {}x{} --output {}.png --comparison {}-errors.png",
                       programFolder(), scene, one.viewNumber, one.light, setup, options.mapSize,
                       options.width, options.height, picture, picture);
}

void printWorst(const TableOptions& options, const std::vector<TableCase>& cases,
                const Contenders& contenders, std::size_t setup, CasePictures* pictures) {
    const std::string& name = options.setups[setup].name;
    fmt::print("\nThe worst cases of {} beside the best of Uniform and OGRE's setups of one map: "
               "ratio, errors in %, why the fit is as it is\n\n",
               name);
    for (const auto& [one, best, ratio] : lossesOf(cases, contenders, setup)) {
        const auto error = [&](std::size_t i) { return one->errors[i].error; };
        fmt::print("{:.2f}  {}, {}, {}: Optimal {:.3f}, XPSM {:.3f}, Uniform {:.3f}, best {} "
                   "{:.3f}; {}\n      {}\n",
                   ratio, one->scene, one->view, one->light, error(contenders.optimal),
                   error(contenders.xpsm), error(contenders.uniform), options.setups[best].name,
                   error(best), one->reasons[setup], commandFor(options, *one, name));
        if (pictures == nullptr) continue;
        for (const std::size_t i : {setup, best}) {
            const CasePictures::Picture picture = pictures->draw(*one, i);
            fmt::print("      {}: emulated {:.3f}, drawn {:.3f}; {}\n", options.setups[i].name,
                       error(i), picture.error, picture.file);
        }
        std::fflush(stdout);
    }
}

} // namespace

void printWorstCases(const TableOptions& options, const std::vector<TableCase>& cases,
                     CasePictures* pictures) {
    const Contenders contenders(options.setups);
    for (const std::size_t setup : {contenders.optimal, contenders.xpsm})
        printWorst(options, cases, contenders, setup, pictures);
}

} // namespace Lixel::Samples

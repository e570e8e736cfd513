#include "report/Table.h"

#include "common/Comparison.h"
#include "report/CaseStage.h"

#include <OgrePrerequisites.h>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>

namespace Lixel::Samples {
namespace {

/// The scene whose cases are shown apart.
const std::string DuelScene = "duel";

SomeCases casesOf(const std::vector<TableCase>& cases, const std::string& scene) {
    return casesWhere(cases, [&](const TableCase& one) { return one.scene == scene; });
}

/// Of the table's first column, in characters.
std::size_t nameWidth(const std::vector<NamedSetup>& setups) {
    std::size_t width = 20;
    for (const NamedSetup& setup : setups)
        width = std::max(width, setup.name.size());
    return width;
}

/// The second half of the table.
void printRatios(const std::vector<NamedSetup>& setups, const std::vector<TableCase>& cases,
                 std::size_t baseline) {
    const std::size_t width = nameWidth(setups);
    const SomeCases telling = tellingCases(cases, baseline);
    const std::array<CaseGroup, 4> groups = groupsOf(telling);

    fmt::print(
        "\nRatio to {}: paired geometric mean with its 95 % interval. {} cases of {} are left "
        "out, in which it errs less than {} %\n\n{:<{}}",
        setups[baseline].name, cases.size() - telling.size(), cases.size(), LeastBaseline, "setup",
        width);
    for (const auto& [name, some] : groups)
        fmt::print(" {:>24}", name == "all" ? fmt::format("all {}", some.size())
                                            : fmt::format("{} {}", some.size(), name));
    fmt::print("\n");
    for (std::size_t i = 0; i < setups.size(); ++i) {
        fmt::print("{:<{}}", setups[i].name, width);
        for (const CaseGroup& group : groups)
            fmt::print(" {:>24}", describe(ratioOf(group.cases, i, baseline)));
        fmt::print("\n");
    }
}

void measureScene(const SampleScene& scene, const TableOptions& options,
                  std::vector<TableCase>& cases) {
    CaseStage stage(scene, options);
    const std::size_t views = options.firstView ? 1 : scene.views.size();
    const std::size_t lights = std::min(options.lights, scene.lights.size());
    for (std::size_t v = 0; v < views; ++v) {
        const SampleView& view = scene.views[v];
        const auto begin = std::chrono::steady_clock::now();
        stage.setView(view);
        for (std::size_t l = 0; l < lights; ++l) {
            const SampleLight light = lightOf(scene, view, l);
            stage.setLight(light);
            TableCase one{scene.name, view.name,
                          light.name, light.kind == SampleLight::Kind::Directional,
                          {},         v + 1};
            for (const NamedSetup& setup : options.setups) {
                one.errors.push_back(stage.emulate(setup));
                one.reasons.push_back(stage.reason());
            }
            if (options.drawn > 0 && cases.size() % options.drawn == 0)
                for (const NamedSetup& setup : options.setups)
                    one.drawnErrors.push_back(compareWithTruth(stage.truth(), stage.draw(setup)));
            cases.push_back(std::move(one));
        }
        const std::chrono::duration<double, std::milli> passed =
            std::chrono::steady_clock::now() - begin;
        fmt::print(stderr, "{}, view {} of {}: {:.0f} ms a setup and light\n", scene.name, v + 1,
                   views, passed.count() / static_cast<double>(lights * options.setups.size()));
    }
}

/// @param prefix of the keys
void writeError(const std::string& prefix, const ClassificationError& error,
                nlohmann::ordered_json& setup) {
    setup[prefix + "error_percent"] = error.error;
    setup[prefix + "acne_percent"] = error.acne;
    setup[prefix + "leak_percent"] = error.leak;
}

} // namespace

std::vector<TableCase> measureTable(const TableOptions& options) {
    std::vector<TableCase> cases;
    for (const SampleScene& scene : measuredScenes())
        if (options.kinds.empty() || std::ranges::count(options.kinds, scene.name) > 0)
            measureScene(scene, options, cases);
    if (!options.modelFile.empty()) measureScene(modelScene(options.modelFile), options, cases);
    return cases;
}

SomeCases casesWhere(const std::vector<TableCase>& cases,
                     const std::function<bool(const TableCase&)>& filter) {
    SomeCases found;
    for (const TableCase& one : cases)
        if (filter(one)) found.push_back(&one);
    return found;
}

SomeCases among(const SomeCases& cases, const std::function<bool(const TableCase&)>& filter) {
    SomeCases some;
    std::copy_if(cases.begin(), cases.end(), std::back_inserter(some),
                 [&](const TableCase* one) { return filter(*one); });
    return some;
}

SomeCases tellingCases(const std::vector<TableCase>& cases, std::size_t baseline) {
    return casesWhere(
        cases, [&](const TableCase& one) { return one.errors[baseline].error >= LeastBaseline; });
}

std::array<CaseGroup, 4> groupsOf(const SomeCases& cases) {
    return {{{"all", cases},
             {"suns", among(cases, [](const TableCase& one) { return one.sun; })},
             {"duels", among(cases, [](const TableCase& one) { return one.scene == DuelScene; })},
             {"lamps", among(cases, [](const TableCase& one) { return !one.sun; })}}};
}

double meanOf(const SomeCases& cases, const std::function<double(const TableCase&)>& value) {
    double sum = 0.0;
    for (const TableCase* one : cases)
        sum += value(*one);
    return cases.empty() ? 0.0 : sum / static_cast<double>(cases.size());
}

double errorForRatio(const TableCase& one, std::size_t setup) {
    return one.errors[setup].error + 50.0 / static_cast<double>(one.errors[setup].counted());
}

GeometricMean ratioOf(const SomeCases& cases, std::size_t setup, std::size_t baseline) {
    std::vector<double> ratios;
    for (const TableCase* one : cases)
        ratios.push_back(errorForRatio(*one, setup) / errorForRatio(*one, baseline));
    return geometricMean(ratios);
}

std::string describe(const GeometricMean& mean) {
    return mean.count == 0
               ? "-"
               : fmt::format("{:.3f} [{:.3f}, {:.3f}]", mean.mean, mean.lower, mean.upper);
}

std::string describePercent(const GeometricMean& mean) {
    return mean.count == 0 ? "-" : fmt::format("{:.4f}", mean.mean);
}

void printTable(const std::vector<NamedSetup>& setups, const std::vector<TableCase>& cases,
                std::size_t baseline) {
    const std::size_t width = nameWidth(setups);
    std::vector<std::string> scenes;
    for (const TableCase& one : cases)
        if (scenes.empty() || scenes.back() != one.scene) scenes.push_back(one.scene);
    const SomeCases all = casesWhere(cases, [](const TableCase&) { return true; });

    // OGRE's own setups changed between its versions.
    fmt::print("Error in %, mean over the lights and views of a scene, {} cases in all, OGRE "
               "{}.{}.{}\n\n"
               "{:<{}}",
               cases.size(), OGRE_VERSION_MAJOR, OGRE_VERSION_MINOR, OGRE_VERSION_PATCH, "setup",
               width);
    for (const std::string& scene : scenes)
        fmt::print(" {:>11}", scene);
    fmt::print(" {:>8} {:>8} {:>8}\n", "all", "acne", "leaks");
    for (std::size_t i = 0; i < setups.size(); ++i) {
        const auto error = [i](const TableCase& one) { return one.errors[i].error; };
        fmt::print("{:<{}}", setups[i].name, width);
        for (const std::string& scene : scenes)
            fmt::print(" {:>11.3f}", meanOf(casesOf(cases, scene), error));
        fmt::print(" {:>8.3f} {:>8.3f} {:>8.3f}\n", meanOf(all, error),
                   meanOf(all, [i](const TableCase& one) { return one.errors[i].acne; }),
                   meanOf(all, [i](const TableCase& one) { return one.errors[i].leak; }));
    }

    printRatios(setups, cases, baseline);
}

std::string describeRatio(const std::vector<TableCase>& cases, std::size_t setup,
                          std::size_t baseline) {
    return describe(ratioOf(tellingCases(cases, baseline), setup, baseline));
}

void writeCases(const TableOptions& options, const std::vector<TableCase>& cases,
                const std::string& file) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const TableCase& one : cases) {
        nlohmann::ordered_json row{{"scene", one.scene},
                                   {"view", one.view},
                                   {"view_number", one.viewNumber},
                                   {"light", one.light},
                                   {"sun", one.sun},
                                   {"pixels_counted", one.errors.at(0).counted()},
                                   {"pixels_shadowed", one.errors.at(0).shadowed}};
        for (std::size_t i = 0; i < options.setups.size(); ++i) {
            nlohmann::ordered_json& setup = row["setups"][options.setups[i].name];
            writeError("", one.errors.at(i), setup);
            if (!one.drawnErrors.empty()) writeError("drawn_", one.drawnErrors.at(i), setup);
            setup["reason"] = one.reasons.at(i);
        }
        rows.push_back(std::move(row));
    }
    const nlohmann::ordered_json all{{"ogre", fmt::format("{}.{}.{}", OGRE_VERSION_MAJOR,
                                                          OGRE_VERSION_MINOR, OGRE_VERSION_PATCH)},
                                     {"map", options.mapSize},
                                     {"width", options.width},
                                     {"height", options.height},
                                     {"cases", std::move(rows)}};
    std::ofstream stream(file);
    stream << all.dump(1) << '\n';
    stream.flush();
    if (!stream) throw std::runtime_error("cannot write '" + file + "'");
}

} // namespace Lixel::Samples

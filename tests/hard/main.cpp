// Named hard cases: what each shadow setup loses on each of them.

#include "CaseRun.h"
#include "ExpectedExtent.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>

namespace Lixel::Tests {
namespace {

struct Options {
    std::string caseName;
    std::string setupName;
    std::string json;
    bool lixelsOnly = false;
    bool extent = false;
    bool check = false;
};

std::vector<const Samples::NamedSetup*> chosenSetups(const Options& options) {
    std::vector<const Samples::NamedSetup*> chosen;
    for (const Samples::NamedSetup& setup : judgedSetups())
        if ((options.setupName.empty() || setup.name == options.setupName) &&
            (!options.lixelsOnly || isLixels(setup)))
            chosen.push_back(&setup);
    if (chosen.empty()) throw std::runtime_error("there is no setup '" + options.setupName + "'");
    return chosen;
}

std::vector<const HardCase*> chosenCases(const Options& options) {
    std::vector<const HardCase*> chosen;
    for (const HardCase& hardCase : hardCases())
        if (options.caseName.empty() || hardCase.name == options.caseName)
            chosen.push_back(&hardCase);
    if (chosen.empty()) throw std::runtime_error("there is no case '" + options.caseName + "'");
    return chosen;
}

/// Whether a result is what is expected of one of Lixel's setups.
bool isExpected(const HardCase& hardCase, const CaseResult& result) {
    // A case in which the viewer looks elsewhere would say nothing.
    if (hardCase.nothingShadowed != (result.losses.shadowed == 0)) return false;
    // What is known to fail and no longer does is to be struck from the list.
    return hardCase.known.empty() ? result.ok
                                  : result.text.find(hardCase.known) != std::string::npos;
}

nlohmann::json toJson(const HardCase& hardCase, const Samples::NamedSetup& setup,
                      const CaseResult& result) {
    const Losses& losses = result.losses;
    return {{"case", hardCase.name},
            {"setup", setup.name},
            {"ok", result.ok},
            {"result", result.text},
            {"shadowedPoints", losses.shadowed},
            {"outsidePercent", losses.outside},
            {"behindPercent", losses.behind},
            {"clippedPercent", losses.clipped},
            {"culledPercent", losses.culled},
            {"apartPercent", losses.apart},
            {"coarsePercent", losses.coarse},
            {"mirroredPercent", losses.mirrored},
            {"unservedPercent", losses.unserved},
            {"worstApartTexels", losses.worstApart}};
}

/// @return the program's exit status
int run(const Options& options) {
    // Child processes are copies without this one's threads, so Mesa must have none.
    setenv("LP_NUM_THREADS", "0", 1);
    const auto cases = chosenCases(options);
    if (options.extent) {
        const int worse = printExtents(cases);
        return options.check && worse > 0 ? 1 : 0;
    }
    const auto setups = chosenSetups(options);
    Samples::Stage stage({.headless = true, .width = 320, .height = 240});
    const bool one = setups.size() == 1 && cases.size() == 1;
    int failures = 0;
    nlohmann::json all = nlohmann::json::array();
    for (const HardCase* const hardCase : cases) {
        fmt::print("{}\n", hardCase->name);
        // Setups that agree share a line.
        std::vector<std::pair<std::string, std::string>> lines;
        std::size_t shadowed = 0;
        const std::vector<CaseResult> results =
            one ? std::vector{runCase(stage, *hardCase, *setups.front())}
                : runCaseApart(stage, *hardCase, setups);
        for (std::size_t i = 0; i < setups.size(); ++i) {
            const Samples::NamedSetup* const setup = setups[i];
            const CaseResult& result = results[i];
            all.push_back(toJson(*hardCase, *setup, result));
            shadowed = std::max(shadowed, result.losses.shadowed);
            if (isLixels(*setup) && !isExpected(*hardCase, result)) ++failures;
            const auto same = std::find_if(lines.begin(), lines.end(), [&](const auto& line) {
                return line.first == result.text;
            });
            if (same == lines.end())
                lines.emplace_back(result.text, setup->name);
            else
                same->second += " " + setup->name;
        }
        for (const auto& [text, names] : lines)
            fmt::print("    {:<34} {}\n", text, names);
        if (shadowed == 0) fmt::print("    (nothing visible is in shadow)\n");
        std::fflush(stdout);
    }
    if (!options.json.empty()) std::ofstream(options.json) << all.dump(1) << '\n';
    fmt::print("{} cases; Lixel's setups fail {} times\n", cases.size(), failures);
    return options.check && failures > 0 ? 1 : 0;
}

} // namespace
} // namespace Lixel::Tests

int main(int argc, char** argv) {
    Lixel::Tests::Options options;
    CLI::App app(
        "What shadow setups lose on hard cases, in percent of the visible shadowed points:\n"
        "out: outside the map; w<=0: behind it; clip, cull: their casters are not drawn;\n"
        "apart: caster and receiver of one light ray fall into different texels;\n"
        "mirror: the map is mirrored.");
    app.add_option("--case", options.caseName, "one case alone");
    app.add_option("--setup", options.setupName, "one setup alone; with --case in this process");
    app.add_option("--json", options.json, "file for all numbers");
    app.add_flag("--lixel", options.lixelsOnly, "Lixel's own setups only");
    app.add_flag("--extent", options.extent,
                 "instead, how large XPSM's texels are expected to be, guarded and not, relative "
                 "to a uniform map's; of the samples' scenes too");
    app.add_flag("--check", options.check,
                 "fail unless Lixel's setups do what is expected; with --extent, unless guarded "
                 "XPSM is nowhere expected to be worse than a uniform map");
    CLI11_PARSE(app, argc, argv);
    try {
        return Lixel::Tests::run(options);
    } catch (const std::exception& exception) {
        fmt::print(stderr, "lixel-hard-cases: {}\n", exception.what());
        return 1;
    }
}

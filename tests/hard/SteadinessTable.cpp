// Sweeps through singular directions: how steady each shadow setup is.

#include "CaseRun.h"
#include "ChildProcess.h"
#include "Steadiness.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>

namespace Lixel::Tests {
namespace {

/// Seconds; a sweep takes about one.
constexpr unsigned TimeLimit = 60;

struct Options {
    std::vector<std::string> sweepNames;
    std::vector<std::string> setupNames;
    std::string json;
    int frames = SweepOptions{}.frames;
    bool lixelsOnly = false;
    bool check = false;
};

/// One cell of the table.
struct Cell {
    const Samples::NamedSetup* setup;
    Steadiness steadiness;
    /// What became of the sweep that hits the singular direction exactly, where it failed:
    /// steadiness is then that of one that passes it by half a step.
    std::string failure;
    /// The same of that one.
    std::string passingFailure;
};

/// Those whose names are given; all for none.
template <typename T>
std::vector<const T*> chosen(const std::vector<T>& all, const std::vector<std::string>& names,
                             const char* what) {
    std::vector<const T*> found;
    for (const T& one : all)
        if (names.empty() || std::find(names.begin(), names.end(), one.name) != names.end())
            found.push_back(&one);
    if (found.empty()) throw std::runtime_error(fmt::format("there is no such {}", what));
    return found;
}

/// All but those that are made for a plane exactly, or are another one with one split.
std::vector<Samples::NamedSetup> sweptSetups(bool lixelsOnly) {
    std::vector<Samples::NamedSetup> setups;
    for (const Samples::NamedSetup& setup : judgedSetups())
        if (setup.name != "PlaneOptimal-Exact" && setup.name != "Ogre-PlaneOptimal" &&
            setup.name != "Ogre-PSSM" && (!lixelsOnly || isLixels(setup)))
            setups.push_back(setup);
    return setups;
}

Cell measure(Samples::Stage& stage, const Sweep& sweep, const Samples::NamedSetup& setup,
             int frames) {
    const auto sweepAt = [&](double offset, Steadiness& result) {
        return runApart(
            TimeLimit,
            [&] { result = runSweep(stage, sweep, setup, {.frames = frames, .offset = offset}); },
            std::as_writable_bytes(std::span(&result, 1)));
    };
    Cell cell{&setup, {}, {}, {}};
    cell.failure = sweepAt(0.0, cell.steadiness);
    if (!cell.failure.empty()) cell.passingFailure = sweepAt(0.5, cell.steadiness);
    return cell;
}

std::string describe(const Cell& cell) {
    if (!cell.passingFailure.empty()) return cell.passingFailure;
    const Steadiness& s = cell.steadiness;
    if (s.measured == 0) return "no map";
    return fmt::format("{:.{}f}{}{}", s.greatest, s.greatest < 0.1 ? 4 : 2,
                       s.jumps > 0 ? fmt::format("/{}", s.jumps) : "",
                       cell.failure.empty() ? "" : "!");
}

/// Names over two lines, broken at the last dash.
void printHeader(const std::vector<const Samples::NamedSetup*>& setups) {
    for (const bool second : {false, true}) {
        fmt::print("{:<32}", second ? "sweep" : "");
        for (const Samples::NamedSetup* setup : setups) {
            const std::size_t dash = setup->name.rfind('-');
            const bool whole = dash == std::string::npos;
            fmt::print(" {:>11}", second ? setup->name.substr(whole ? 0 : dash + 1)
                                         : setup->name.substr(0, whole ? 0 : dash));
        }
        fmt::print("\n");
    }
}

nlohmann::json toJson(const Sweep& sweep, const Cell& cell) {
    const Steadiness& s = cell.steadiness;
    return {{"sweep", sweep.name},
            {"setup", cell.setup->name},
            {"exactly", cell.failure.empty() ? "ok" : cell.failure},
            {"greatestChange", s.greatest},
            {"greatestChangeWithoutJumps", s.greatestSteady},
            {"percentile99", s.percentile99},
            {"frameOfGreatestWithoutJumps", s.greatestFrame},
            {"unsteadySteps", s.unsteadySteps},
            {"jumps", s.jumps},
            {"leastGainOfJumps", s.jumps > 0 ? nlohmann::json(s.leastGain) : nlohmann::json()},
            {"framesWithoutMap", s.framesWithoutMap},
            {"measured", s.measured}};
}

/// What Lixel's contract asks of its own setups.
bool isSteady(const Cell& cell) {
    return cell.failure.empty() && cell.steadiness.measured > 0 &&
           cell.steadiness.framesWithoutMap == 0 && cell.steadiness.greatestSteady <= MostChange &&
           // Beside what the same frame changes anyway. Bodies come into slices of the view, and
           // leave them: what that makes of the map's area is not the jump's, which must be rare.
           (cell.setup->maps > 1 ? cell.steadiness.jumps <= 1
                                 : cell.steadiness.leastGain >= LeastGain - MostChange);
}

/// Sums up each setup's column.
void printSummary(const std::vector<const Samples::NamedSetup*>& setups,
                  const std::vector<Cell>& cells) {
    const auto line = [&](const char* title, const auto& text) {
        fmt::print("{:<32}", title);
        for (const Samples::NamedSetup* setup : setups) {
            Steadiness sum;
            int aborts = 0;
            for (const Cell& cell : cells) {
                if (cell.setup != setup) continue;
                const Steadiness& s = cell.steadiness;
                sum.greatest = std::max(sum.greatest, s.greatest);
                sum.greatestSteady = std::max(sum.greatestSteady, s.greatestSteady);
                sum.percentile99 = std::max(sum.percentile99, s.percentile99);
                sum.jumps += s.jumps;
                sum.leastGain = std::min(sum.leastGain, s.leastGain);
                sum.unsteadySteps += s.unsteadySteps;
                aborts += cell.failure.empty() ? 0 : 1;
            }
            fmt::print(" {:>11}", text(sum, aborts));
        }
        fmt::print("\n");
    };
    line("largest", [](const Steadiness& s, int) { return fmt::format("{:.4f}", s.greatest); });
    line("largest without jumps",
         [](const Steadiness& s, int) { return fmt::format("{:.4f}", s.greatestSteady); });
    line("99th percentile of the worst",
         [](const Steadiness& s, int) { return fmt::format("{:.4f}", s.percentile99); });
    line("jumps", [](const Steadiness& s, int) { return fmt::format("{}", s.jumps); });
    line("least area saved by a jump, %", [](const Steadiness& s, int) {
        return s.jumps > 0 ? fmt::format("{:.1f}", 100.0 * s.leastGain) : "-";
    });
    line("steps above 0.02 without a jump",
         [](const Steadiness& s, int) { return fmt::format("{}", s.unsteadySteps); });
    line("sweeps that fail",
         [](const Steadiness&, int aborts) { return fmt::format("{}", aborts); });
}

/// @return the program's exit status
int run(const Options& options) {
    // Child processes are copies without this one's threads, so Mesa must have none.
    setenv("LP_NUM_THREADS", "0", 1);
    const std::vector<Samples::NamedSetup> all = sweptSetups(options.lixelsOnly);
    const auto setups = chosen(all, options.setupNames, "setup");
    const auto swept = chosen(sweeps(), options.sweepNames, "sweep");
    Samples::Stage stage({.headless = true, .width = 64, .height = 48});
    fmt::print(
        "Largest change of ln m from one frame to the next, 1e-4 rad apart, over {} frames;\n"
        "/n: n times a map's axes jump; !: fails where the direction is exact\n\n",
        options.frames);
    printHeader(setups);
    std::vector<Cell> cells;
    nlohmann::json json = nlohmann::json::array();
    int failures = 0;
    for (const Sweep* const sweep : swept) {
        fmt::print("{:<32}", sweep->name);
        for (const Samples::NamedSetup* const setup : setups) {
            cells.push_back(measure(stage, *sweep, *setup, options.frames));
            json.push_back(toJson(*sweep, cells.back()));
            if (isLixels(*setup) && !isSteady(cells.back())) ++failures;
            fmt::print(" {:>11}", describe(cells.back()));
            std::fflush(stdout);
        }
        fmt::print("\n");
    }
    fmt::print("\n");
    printSummary(setups, cells);
    if (!options.json.empty()) std::ofstream(options.json) << json.dump(1) << '\n';
    fmt::print("\n{} sweeps; Lixel's setups are unsteady in {}\n", swept.size(), failures);
    return options.check && failures > 0 ? 1 : 0;
}

} // namespace
} // namespace Lixel::Tests

int main(int argc, char** argv) {
    Lixel::Tests::Options options;
    CLI::App app("How much texels change in the picture while a light or a viewer turns through "
                 "directions at which shadow maps jump.");
    app.add_option("--sweep", options.sweepNames, "these sweeps alone");
    app.add_option("--setup", options.setupNames, "these setups alone");
    app.add_option("--frames", options.frames, "frames of a sweep, its middle in their middle")
        ->check(CLI::Range(3, 100000));
    app.add_option("--json", options.json, "file for all numbers");
    app.add_flag("--lixel", options.lixelsOnly, "Lixel's own setups only");
    app.add_flag("--check", options.check, "fail unless Lixel's setups are steady");
    CLI11_PARSE(app, argc, argv);
    try {
        return Lixel::Tests::run(options);
    } catch (const std::exception& exception) {
        fmt::print(stderr, "lixel-steadiness: {}\n", exception.what());
        return 1;
    }
}

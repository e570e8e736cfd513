// lixel-report: how wrong one shadow setup is beside another, or all are, over all samples.

#include "common/Comparison.h"
#include "common/Names.h"
#include "common/PictureSize.h"
#include "common/Setups.h"
#include "report/BestXpsm.h"
#include "report/Budgets.h"
#include "report/CasePictures.h"
#include "report/Claims.h"
#ifdef LIXEL_SAMPLES_RTSS
#include "report/Casters.h"
#endif
#include "report/Drawn.h"
#include "report/FeedbackTable.h"
#include "report/Motion.h"
#include "report/Rows.h"
#include "report/Table.h"
#include "report/WorstCases.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <span>

using namespace Lixel::Samples;

namespace {

struct Options {
    std::string setup = "XPSM";
    /// Its options, KEYWORD=VALUE each.
    std::vector<std::string> assignments;
    std::string baseline = "Uniform";
    std::string modelFile;
    int width = 400;
    int height = 300;
    std::size_t lights = 4;
    bool firstView = false;
    bool table = false;
    bool budgets = false;
    bool bestXpsm = false;
    bool casters = false;
    bool motion = false;
    bool feedback = false;
    int frames = MotionOptions().frames;
    std::vector<std::string> kinds;
    std::vector<std::string> rows;   ///< of the table; empty for all setups
    std::optional<PictureSize> size; ///< by emulation
    int shifts = 1;
    std::size_t drawn = 0;     ///< of so many cases one is drawn; 0: none is
    std::string pictureFolder; ///< for the worst cases; empty for no pictures
    std::string jsonFile;
    std::string motionScene;
};

/// One scene at a time: each gets a stage of its own. @param name empty for the model file.
std::vector<ComparedCase> compareScene(const std::string& name, const Options& options) {
    Stage stage({.headless = true, .width = options.width, .height = options.height});
    const SampleScene scene = name.empty() ? modelScene(options.modelFile) : *findSampleScene(name);
    stage.show(scene);
    return compareSetups(stage, scene,
                         withOptions(*findShadowSetup(options.setup), options.assignments),
                         *findShadowSetup(options.baseline), options.lights,
                         std::span(scene.views).first(options.firstView ? 1 : scene.views.size()),
                         [](const std::string& left) {
                             fmt::print("{:<32} left out: no map size errs 1 to 5 %\n", left);
                         });
}

/// Runs --motion. @return the program's exit status
int filmMotion(const Options& options) {
    MotionOptions motion;
    motion.modelFile = options.modelFile;
    motion.frames = options.frames;
    motion.scene = options.motionScene;
    try {
        const std::vector<MotionRow> rows = measureMotion(motion);
        printMotion(motion, rows);
        if (!options.jsonFile.empty()) writeMotion(motion, rows, options.jsonFile);
    } catch (const std::exception& error) {
        fmt::print(stderr, "lixel-report: {}\n", error.what());
        return 1;
    }
    return 0;
}

/// Runs --table with rows of one's own. @return the program's exit status
int makeTableOfRows(TableOptions table, const Options& options) {
    table.setups.clear();
    try {
        for (const std::string& row : options.rows)
            table.setups.push_back(rowOf(row));
    } catch (const std::invalid_argument& error) {
        fmt::print(stderr, "lixel-report: {}\n", error.what());
        return 2;
    }
    const std::vector<TableCase> cases = measureTable(table);
    printTable(table.setups, cases, 0);
    printDrawn(table, cases);
    printDrawnRatios(table, cases);
    if (!options.jsonFile.empty()) writeCases(table, cases, options.jsonFile);
    return 0;
}

/// Runs --table, --budgets, --best-xpsm or --casters. @return the program's exit status
int makeTable(const Options& options) {
    const std::vector<NamedSetup>& setups = emulatedSetups();
    const auto baseline = std::find_if(setups.begin(), setups.end(), [&](const NamedSetup& setup) {
        return setup.name == options.baseline;
    });
    if (baseline == setups.end()) {
        fmt::print(stderr, "lixel-report: {}\n", noneOfThatName("setup", options.baseline, setups));
        return 2;
    }
    TableOptions table;
    table.kinds = options.kinds;
    table.modelFile = options.modelFile;
    table.lights = options.lights;
    table.firstView = options.firstView;
    table.drawn = options.drawn;
    table.shifts = options.shifts;
    if (options.size) {
        table.width = options.size->width;
        table.height = options.size->height;
    }
    try {
#ifdef LIXEL_SAMPLES_RTSS
        if (options.casters) {
            printCasters(options.width, options.height);
            return 0;
        }
#endif
        if (options.feedback) {
            printFeedback(table, options.frames);
            return 0;
        }
        if (options.bestXpsm) {
            printBestXpsm(table);
            return 0;
        }
        if (options.budgets) {
            printBudgets(table);
            return 0;
        }
        if (!options.rows.empty()) return makeTableOfRows(table, options);
        // Made first: a folder that cannot be made is said before all is measured.
        std::optional<CasePictures> pictures;
        if (!options.pictureFolder.empty()) pictures.emplace(table, options.pictureFolder);
        const std::vector<TableCase> cases = measureTable(table);
        printTable(setups, cases, static_cast<std::size_t>(baseline - setups.begin()));
        printClaims(table, cases);
        printDrawn(table, cases);
        printDrawnClaims(table, cases);
        if (!options.jsonFile.empty()) writeCases(table, cases, options.jsonFile);
        printWorstCases(table, cases, pictures ? &*pictures : nullptr);
    } catch (const std::exception& error) {
        fmt::print(stderr, "lixel-report: {}\n", error.what());
        return 1;
    }
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app{"Compares the errors of two shadow setups over all samples, on maps sized so that "
                 "the baseline errs 1 to 5 %; or of all setups, on maps of one size."};
    app.add_option("--setup", options.setup, "Setup to judge");
    auto* const assignments = app.add_option(
        "--set", options.assignments,
        "An option of the setup to judge, KEYWORD=VALUE; may be given several times");
    app.add_option("--baseline", options.baseline, "Setup to compare it with");
    app.add_option("--scene", options.modelFile, "A model file as one more scene");
    app.add_option("--lights", options.lights, "Lights of each scene")->check(CLI::PositiveNumber);
    auto* const kinds = app.add_option(
        "--kind", options.kinds, "A sample to measure instead of all; may be given several times");
    app.add_flag("--first-view", options.firstView, "The first view of each scene alone");
    // They judge no one setup.
    auto* const table =
        app.add_flag("--table", options.table, "All setups in one table, by emulation")
            ->excludes(assignments);
    app.add_flag("--budgets", options.budgets,
                 "Optimal alone, by samples and evaluations, with its time, by emulation")
        ->excludes(assignments);
    app.add_flag(
           "--best-xpsm", options.bestXpsm,
           "Optimal beside XPSM with the constants that are best for each scene, by emulation")
        ->excludes(assignments);
#ifdef LIXEL_SAMPLES_RTSS
    app.add_flag("--casters", options.casters,
                 "The garden's kinds of casters, each alone, beside OGRE's own shadows")
        ->excludes(assignments)
        ->excludes(kinds);
#endif
    app.add_option_function<std::string>(
           "--size",
           [&](const std::string& text) {
               options.size = parsePictureSize(text);
               if (!options.size) throw CLI::ValidationError("--size", noPictureSize(text));
           },
           "With --table: picture size, WxH; fewer pixels are measured faster")
        ->needs(table);
    auto* const rows =
        app.add_option(
               "--row", options.rows,
               "With --table: a setup and its options, 'NAME KEYWORD=VALUE...', instead of all "
               "setups; may be given several times, and the first is what others are compared "
               "with")
            ->needs(table);
    app.add_option("--shifts", options.shifts,
                   "With --table: emulated maps lie at so many by so many places within a texel, "
                   "and errors are their means: chance says less")
        ->check(CLI::Range(1, 16))
        ->needs(table);
    app.add_option("--drawn", options.drawn,
                   "With --table: of so many cases the first is drawn too, under all setups, and "
                   "compared both ways")
        ->check(CLI::PositiveNumber)
        ->needs(table);
    app.add_option("--pictures", options.pictureFolder,
                   "With --table: a folder for pictures of what is wrong with the worst cases, and "
                   "with the best others in these")
        ->needs(table)
        ->excludes(rows);
    auto* const motion =
        app.add_flag("--motion", options.motion,
                     "What a walking and turning viewer sees: flicker, errors, and how often maps "
                     "are drawn, by setup and lasting_maps, by emulation")
            ->excludes(assignments)
            ->excludes(kinds);
    auto* const frames = app.add_option("--frames", options.frames,
                                        "With --motion or --feedback: frames of each motion")
                             ->check(CLI::Range(2, 100000));
    app.add_option("--sample", options.motionScene, "With --motion: one scene alone")
        ->check(CLI::IsMember({"street", "field", "miners-lamp", "model"}))
        ->needs(motion);
    app.add_flag("--feedback", options.feedback,
                 "What the option feedback gives a walking viewer, and after a camera cut: errors, "
                 "points without shadow, and times")
        ->excludes(assignments)
        ->excludes(motion);
    app.add_option("--json", options.jsonFile,
                   "With --table or --motion: a file for all numbers, JSON");
    CLI11_PARSE(app, argc, argv);
    for (const std::string& kind : options.kinds) {
        if (std::ranges::count(measuredScenes(), kind, &SampleScene::name) == 0) {
            fmt::print(stderr, "lixel-report: {}\n",
                       noneOfThatName("sample", kind, measuredScenes()));
            return 2;
        }
    }
    if (!options.jsonFile.empty() && !options.table && !options.motion) {
        fmt::print(stderr, "lixel-report: --json goes with --table or --motion\n");
        return 2;
    }
    if (frames->count() > 0 && !options.motion && !options.feedback) {
        fmt::print(stderr, "lixel-report: --frames goes with --motion or --feedback\n");
        return 2;
    }
    if (options.motion) return filmMotion(options);
    if (options.table || options.feedback || options.bestXpsm || options.budgets || options.casters)
        return makeTable(options);
    for (const std::string& name : {options.setup, options.baseline}) {
        if (findShadowSetup(name) == nullptr) {
            fmt::print(stderr, "lixel-report: {}\n", noneOfThatName("setup", name, shadowSetups()));
            return 2;
        }
    }
    const std::string wrong = wrongAssignment(*findShadowSetup(options.setup), options.assignments);
    if (!wrong.empty()) {
        fmt::print(stderr, "lixel-report: {}\n", wrong);
        return 2;
    }
    std::vector<std::string> names = options.kinds;
    if (names.empty())
        for (const SampleScene& scene : measuredScenes())
            names.push_back(scene.name);
    if (!options.modelFile.empty()) names.emplace_back();

    std::vector<double> ratios;
    fmt::print("{:<32} {:>5} {:>9} {:>9} {:>6}  {}\n", "scene, light", "map", options.baseline,
               options.setup, "ratio", "reason");
    for (const std::string& name : names) {
        try {
            for (const ComparedCase& one : compareScene(name, options)) {
                fmt::print("{:<32} {:>5} {:>7.3f} % {:>7.3f} % {:>6.3f}  {}\n",
                           fmt::format("{}, {}", one.scene, one.light), one.mapSize, one.baseline,
                           one.error, one.ratio(), one.reason);
                std::fflush(stdout);
                ratios.push_back(one.ratio());
            }
        } catch (const std::exception& error) {
            fmt::print(stderr, "lixel-report: {}\n", error.what());
            return 1;
        }
    }
    if (ratios.empty()) return 1;
    const GeometricMean mean = geometricMean(ratios);
    fmt::print("{} / {}: geometric mean {:.3f} [{:.3f}, {:.3f}] over {} cases, worst {:.3f}\n",
               options.setup, options.baseline, mean.mean, mean.lower, mean.upper, mean.count,
               *std::max_element(ratios.begin(), ratios.end()));
    return 0;
}

#include "browser/Options.h"

#include "common/Names.h"
#include "common/PictureSize.h"

#include <CLI/CLI.hpp>

#include <fmt/core.h>

#include <cmath>

namespace Lixel::Samples {
namespace {

void parseSize(const std::string& text, BrowserOptions& options) {
    const std::optional<PictureSize> size = parsePictureSize(text);
    if (!size) throw CLI::ValidationError("--size", noPictureSize(text));
    options.width = size->width;
    options.height = size->height;
}

/// "AZIMUTH,ELEVATION" in degrees, or a name, which has no comma.
void parseLight(const std::string& text, BrowserOptions& options) {
    if (text.find(',') == std::string::npos) {
        options.lightName = text;
        return;
    }
    char rest = 0;
    float azimuth = 0;
    float elevation = 0;
    if (std::sscanf(text.c_str(), "%f,%f%c", &azimuth, &elevation, &rest) != 2 ||
        !std::isfinite(azimuth) || !std::isfinite(elevation) || std::abs(elevation) > 90.0F)
        throw CLI::ValidationError(
            "--light", "'" + text + "' is not AZIMUTH,ELEVATION in degrees, such as 120,30");
    options.azimuthElevation = {azimuth, elevation};
}

/// Whether the scene's lights have presets.
bool usesPresets(const BrowserOptions& options) {
    return options.modelFile.empty() && findSampleScene(options.sample)->shaderSystem;
}

} // namespace

std::variant<BrowserOptions, int> parseOptions(int argc, char** argv) {
    BrowserOptions options;
    CLI::App app{"Shows and measures Lixel's shadows on sample scenes and model files.",
                 "lixel-browser"};
    app.get_formatter()->column_width(34);
    app.add_flag("--list", options.list, "List samples and setups, then exit");
    app.add_flag("--options", options.listOptions,
                 "Print the options of all setups as a table, then exit");
    app.add_flag("--headless", options.headless, "Draw without a window or display server");
    auto* sample = app.add_option("--sample", options.sample, "Sample scene (see --list)");
    app.add_option("--scene", options.modelFile, "Model file instead of a sample: glTF, OBJ, …")
        ->excludes(sample);
    app.add_option("--setup", options.setup,
                   "Shadow camera setup (see --list); XPSM, or where lights of the sample have "
                   "presets, these");
    app.add_option("--set", options.assignments,
                   "An option of the setup, KEYWORD=VALUE; may be given several times");
    app.add_option("--map", options.mapSize, "Shadow map size in texels")
        ->check(CLI::Range(16, 8192));
    app.add_option_function<std::string>(
        "--size", [&](const std::string& text) { parseSize(text, options); },
        "Picture or window size, WxH");
    app.add_option("--frames", options.frames, "Frames to draw and time (headless)")
        ->check(CLI::Range(1, 100000));
    app.add_option_function<std::string>(
        "--light", [&](const std::string& text) { parseLight(text, options); },
        "Sun's AZIMUTH,ELEVATION in degrees, or the name of one of the sample's lights");
    app.add_option("--view", options.view, "View of the sample, from 1")
        ->check(CLI::Range(1, 1000));
    app.add_option("--output", options.output, "PNG to write: at once when headless, else at F12");
    app.add_option("--stats", options.stats, "File for times and errors, JSON (headless)");
    app.add_option("--comparison", options.comparison,
                   "PNG of errors against exact shadows: red acne, blue leak (headless)");
    app.add_option("--manager", options.manager,
                   "Type of the scene manager: LixelSceneManager, or one of OGRE's");
    app.add_option("--budget", options.budget,
                   "Shadow maps that a frame draws at most; others wait for their turn")
        ->check(CLI::Range(1, 1000));
    app.add_flag(
        "--proof", options.proof,
        "Draw maps that could be kept, or were drawn in layers, once more, and compare them");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error);
    }
    const auto complain = [](const std::string& what) {
        fmt::print(stderr, "lixel-browser: {}\n", what);
        return 2;
    };
    if (options.modelFile.empty() && findSampleScene(options.sample) == nullptr)
        return complain(noneOfThatName("sample", options.sample, sampleScenes()));
    if (options.setup.empty() && !(usesPresets(options) && options.assignments.empty()))
        options.setup = "XPSM";
    if (options.setup.empty()) return options;
    if (findShadowSetup(options.setup) == nullptr)
        return complain(noneOfThatName("setup", options.setup, shadowSetups()));
    const std::string wrong = wrongAssignment(*findShadowSetup(options.setup), options.assignments);
    if (!wrong.empty()) return complain(wrong);
    return options;
}

std::optional<SampleLight> askedLight(const BrowserOptions& options, const SampleScene& scene,
                                      const SampleView& view) {
    if (!options.lightName.empty()) return findLight(scene, view, options.lightName);
    if (!options.azimuthElevation) return defaultLight(scene, view);
    SampleLight sun =
        sunlight("sun", options.azimuthElevation->first, options.azimuthElevation->second);
    sun.shadowPreset = scene.lights.front().shadowPreset;
    return sun;
}

void printNames() {
    fmt::print("Samples:\n");
    for (const SampleScene& scene : sampleScenes())
        fmt::print("  {}\n", scene.name);
    fmt::print("Setups:\n");
    for (const NamedSetup& setup : shadowSetups())
        fmt::print("  {}\n", setup.name);
}

} // namespace Lixel::Samples

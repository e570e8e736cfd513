#pragma once

#include "common/Scenes.h"
#include "common/Setups.h"

#include <optional>
#include <string>
#include <variant>

namespace Lixel::Samples {

/// What the command line asks for.
struct BrowserOptions {
    bool list = false;
    bool listOptions = false;
    bool headless = false;
    std::string sample = "field";
    std::string modelFile; ///< instead of a sample
    /// Empty for the presets of the scene's lights.
    std::string setup;
    /// Its options, KEYWORD=VALUE each.
    std::vector<std::string> assignments;
    int mapSize = 1024;
    int width = 800;
    int height = 600;
    int frames = 10;
    std::optional<std::pair<float, float>> azimuthElevation;
    std::string lightName; ///< instead; empty for neither: the view's own light
    int view = 1;          ///< counted from 1
    std::string output;
    std::string stats;
    std::string comparison;
    std::string manager; ///< type of the scene manager; empty for OGRE's default one
    bool proof = false;
    int budget = 0; ///< shadow maps that a frame draws at most; 0: no limit
};

/** Parses the command line.

    @return the options, or the program's exit code where it has already said all there is to say
    (help, or what is wrong with the arguments).
*/
std::variant<BrowserOptions, int> parseOptions(int argc, char** argv);

/// The light that was asked for; null where the scene has none of that name.
std::optional<SampleLight> askedLight(const BrowserOptions& options, const SampleScene& scene,
                                      const SampleView& view);

/// Prints the names that --sample and --setup know, under the headings "Samples:" and "Setups:".
void printNames();

} // namespace Lixel::Samples

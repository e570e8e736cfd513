#include "browser/Options.h"
#include "browser/Report.h"
#include "browser/Viewer.h"
#include "common/Names.h"
#include "common/OptionsTable.h"

#include <Lixel/headless/Headless.h>
#include <Lixel/setup/MapBudget.h>

#include <OgreLogManager.h>

#include <fmt/core.h>

using namespace Lixel::Samples;

namespace {

/// Prints Lixel's and the samples' warnings, as the stage writes no log file.
class WarningPrinter : public Ogre::LogListener {
public:
    void messageLogged(const Ogre::String& message, Ogre::LogMessageLevel level, bool,
                       const Ogre::String&, bool&) override {
        const std::size_t begin = message.find("Lixel: "); // after OGRE's own prefix
        if (level >= Ogre::LML_WARNING && begin != std::string::npos)
            fmt::print(stderr, "{}\n", message.substr(begin));
    }
};

int show(Stage& stage, const BrowserOptions& options) {
    const SampleScene scene = options.modelFile.empty() ? *findSampleScene(options.sample)
                                                        : modelScene(options.modelFile);
    if (static_cast<std::size_t>(options.view) > scene.views.size()) {
        fmt::print(stderr, "lixel-browser: '{}' has {} views, no view {}\n", scene.name,
                   scene.views.size(), options.view);
        return 2;
    }
    const SampleView& view = scene.views[static_cast<std::size_t>(options.view) - 1];
    const std::optional<SampleLight> light = askedLight(options, scene, view);
    if (!light) {
        fmt::print(stderr, "lixel-browser: {}\n",
                   noneOfThatName("light", options.lightName, scene.lights));
        return 2;
    }
    stage.show(scene);
    stage.setView(view);
    stage.setLight(*light);
    stage.setShadowMapSize(options.mapSize);
    Lixel::MapBudget budget;
    budget.maps = static_cast<std::size_t>(options.budget);
    Lixel::setMapBudget(budget);
    if (!options.setup.empty()) {
        const NamedSetup& setup = *findShadowSetup(options.setup);
        stage.setShadowSetup(withOptions(setup, options.assignments).create(), setup.maps);
    }
    if (options.headless)
        drawHeadless(stage, scene, options);
    else
        runViewer(stage, scene, options);
    return 0;
}

int run(const BrowserOptions& options) {
    if (!options.headless && !Lixel::Headless::isDisplayUsable()) {
        fmt::print(stderr, "lixel-browser: no window can be opened (DISPLAY is not set, or its X "
                           "server does not answer); --headless draws without one\n");
        return 1;
    }
    WarningPrinter printer; // outlives the log
    Stage stage({.headless = options.headless,
                 .width = options.width,
                 .height = options.height,
                 .sceneManagerType = options.manager});
    Ogre::LogManager::getSingleton().getDefaultLog()->addListener(&printer);
    try {
        return show(stage, options);
    } catch (const Ogre::Exception& error) {
        // Here and not in main(): the exception's type may live in a plugin of the stage's.
        fmt::print(stderr, "lixel-browser: {}\n", error.getDescription());
        return 1;
    }
}

} // namespace

int main(int argc, char** argv) {
    try {
        const auto parsed = parseOptions(argc, argv);
        if (const int* const exitCode = std::get_if<int>(&parsed)) return *exitCode;
        const BrowserOptions& options = std::get<BrowserOptions>(parsed);
        if (options.listOptions) {
            fmt::print("{}\n{}", optionsTable(), settingsTable());
            return 0;
        }
        if (options.list) {
            printNames();
            return 0;
        }
        return run(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "lixel-browser: {}\n", error.what());
    }
    return 1;
}

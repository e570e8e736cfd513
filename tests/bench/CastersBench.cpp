// lixel-bench-casters: what drawing shadow casters costs, each by itself and in batches.
//
//     lixel-bench-casters [--objects N …] [--frames K] [--json FILE]
//
// The field of lixel-bench-scene, seen from inside, with one sun whose map is drawn for real with
// Lixel/Caster in each frame, by OGRE's default scene manager and by Lixel's without and with
// batches. "main thread" is the time until the last draw call of the pass is made, and "pass" that
// until all is drawn (`glFinish`). All ways of drawing take turns of a few frames each, and times
// are medians of wall clock.
#include "BenchMain.h"
#include "BenchMaterials.h"
#include "BenchWatch.h"
#include "WriteJson.h"

#include "common/Median.h"
#include "manager/LixelSceneManager.h"
#include "material/ShadowParameters.h"
#include "setup/ShadowCameraSetups.h"

#include <fmt/core.h>

#include <OgreFrameListener.h>
#include <OgreShadowCameraSetupLiSPSM.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <random>

namespace Lixel::Tests {
namespace {

constexpr int FramesATurn = 4;
constexpr int UncountedFrames = 2;

struct CastersOptions {
    std::vector<std::size_t> objects{1000, 10000};
    int frames = 40;
    std::string json;
};

struct CastersRow {
    std::string manager;
    std::string setup;
    bool batches = false;
    std::size_t objects = 0;
    std::size_t drawCalls = 0;
    std::vector<double> find;       ///< finding casters and queueing them
    std::vector<double> mainThread; ///< the pass, until the last call was made
    std::vector<double> pass;       ///< the pass, until all was drawn
};

/// A scene with its watch, and the rows that are measured in it.
struct CastersScene {
    CastersScene(HeadlessOgre& ogre, const std::string& manager, std::size_t objects)
        : scene(ogre, manager, objects), watch(scene) {
        scene.manager().setShadowTextureCasterMaterial(benchCaster());
        scene.setDrawing(true);
    }

    BenchScene scene;
    BenchWatch watch;
};

struct CastersContender {
    CastersScene* scene;
    Ogre::ShadowCameraSetupPtr setup;
    CastersRow row;
};

BenchTimes drawCasters(Ogre::Root& root, CastersScene& scene, int frame) {
    scene.scene.turn(frame);
    scene.watch.begin();
    Ogre::FrameEvent event{};
    root._fireFrameStarted(event);
    scene.scene.draw();
    root._fireFrameEnded(event);
    return scene.watch.end();
}

void takeCastersTurn(Ogre::Root& root, CastersContender& contender, int frame) {
    CastersScene& scene = *contender.scene;
    CastersRow& row = contender.row;
    scene.scene.use(BenchView::Inside, contender.setup);
    if (auto* const lixels = dynamic_cast<LixelSceneManager*>(&scene.scene.manager()))
        lixels->setCasterBatches(row.batches);
    // This one's alone: scene managers share the texture, and all watches hear of it.
    scene.watch.setFinishing(true);
    for (int i = -UncountedFrames; i < FramesATurn; ++i) {
        const BenchTimes times = drawCasters(root, scene, frame + i);
        if (i < 0) continue;
        row.find.push_back(times.findMap);
        row.mainThread.push_back(times.mapCalls);
        row.pass.push_back(times.map);
        row.drawCalls = scene.scene.mapDrawCalls();
    }
    scene.watch.setFinishing(false);
}

std::vector<CastersRow> measureCasters(HeadlessOgre& ogre, std::size_t objects, int frames) {
    std::vector<std::unique_ptr<CastersScene>> scenes;
    std::vector<CastersContender> contenders;
    for (const std::string& manager : {DefaultManager, FlatManager}) {
        scenes.push_back(std::make_unique<CastersScene>(ogre, manager, objects));
        for (const auto& [name, setup] :
             std::initializer_list<std::pair<const char*, Ogre::ShadowCameraSetupPtr>>{
                 {"OGRE's LiSPSM", Ogre::LiSPSMShadowCameraSetup::create()},
                 {"XPSM", XPSMShadowCameraSetup::create()}})
            for (const bool batches : {false, true})
                if (!batches || manager == FlatManager)
                    contenders.push_back({scenes.back().get(),
                                          setup,
                                          {manager, name, batches, objects, 0, {}, {}, {}}});
    }
    std::vector<CastersContender*> order;
    for (CastersContender& contender : contenders)
        order.push_back(&contender);
    std::mt19937 engine(1);
    for (int frame = 0; frame < frames; frame += FramesATurn) {
        std::shuffle(order.begin(), order.end(), engine);
        for (CastersContender* contender : order)
            takeCastersTurn(ogre.root(), *contender, frame);
    }
    std::vector<CastersRow> rows;
    for (CastersContender& contender : contenders)
        rows.push_back(std::move(contender.row));
    return rows;
}

void printCasters(const std::vector<CastersRow>& rows) {
    fmt::print("\n{} objects; microseconds\n\n{:20} {:14} {:8} {:>6} {:>9} {:>12} {:>8}\n",
               rows.front().objects, "manager", "setup", "batches", "draws", "find", "main thread",
               "pass");
    for (const CastersRow& row : rows)
        fmt::print("{:20} {:14} {:8} {:6} {:9.0f} {:12.0f} {:8.0f}\n", row.manager, row.setup,
                   row.batches ? "yes" : "no", row.drawCalls, Samples::median(row.find),
                   Samples::median(row.mainThread), Samples::median(row.pass));
    std::fflush(stdout);
}

void runCasters(const CastersOptions& options) {
    HeadlessOgre ogre;
    ShadowParameters parameters;
    nlohmann::json json{{"frames", options.frames}, {"rows", nlohmann::json::array()}};
    for (const std::size_t objects : options.objects) {
        const std::vector<CastersRow> rows = measureCasters(ogre, objects, options.frames);
        printCasters(rows);
        for (const CastersRow& row : rows)
            json["rows"].push_back({{"manager", row.manager},
                                    {"setup", row.setup},
                                    {"batches", row.batches},
                                    {"objects", row.objects},
                                    {"draw_calls", row.drawCalls},
                                    {"find_us", Samples::median(row.find)},
                                    {"main_thread_us", Samples::median(row.mainThread)},
                                    {"pass_us", Samples::median(row.pass)}});
    }
    writeJson(json, options.json);
}

} // namespace
} // namespace Lixel::Tests

int main(int argc, char** argv) {
    using namespace Lixel::Tests;
    CastersOptions options;
    CLI::App app("What drawing shadow casters costs");
    addObjects(app, options.objects);
    addFrames(app, options.frames);
    addJson(app, options.json);
    return runBench("lixel-bench-casters", app, argc, argv, [&] { runCasters(options); });
}

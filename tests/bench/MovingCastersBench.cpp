// lixel-bench-moving-casters: what drawing shadow casters costs where some of them move.
//
//     lixel-bench-moving-casters [--objects N,…] [--moving PERCENT,…] [--map SIDE,…] [--frames K]
//                                [--json FILE]
//
// The field of lixel-bench-scene, seen from inside by a viewer who stands still, with one sun whose
// map lasts (lasting_maps), and so stands still too. In each frame a share of the entities moves,
// and the map is drawn for real by LixelSceneManager: at once, or what moves over a copy of what
// stands still (moving_apart). "plan" is the time until the map is begun (survey, search, fit, and
// which casters have changed), "pass" that until it is drawn (`glFinish`), "both" their sum. All
// ways of drawing take turns of some frames each, and times are medians of wall clock. Frames in
// which a way of drawing finds its feet are not counted.
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

#include <algorithm>
#include <cstdio>
#include <exception>
#include <random>

namespace Lixel::Tests {
namespace {

constexpr int FramesOfATurn = 12;
/// After another way of drawing: until casters are known to stand still, and the layer is filled.
constexpr int FramesToSettle = 24;

struct MovingOptions {
    std::vector<std::size_t> objects{1000, 10000};
    std::vector<int> moving{1, 10, 25, 50};
    std::vector<int> maps{1024, 2048};
    int frames = 48;
    std::string json;
};

struct MovingRow {
    std::size_t objects = 0;
    int map = 0;
    int moving = 0; ///< in percent
    bool batches = false;
    bool apart = false;
    std::size_t drawCalls = 0;
    std::size_t layered = 0; ///< maps over a copy of what stands still
    std::vector<double> plan;
    std::vector<double> pass;
    std::vector<double> both;
};

void drawMovingFrame(Ogre::Root& root, BenchScene& scene, BenchWatch& watch, MovingRow* row,
                     std::size_t moving, int frame) {
    scene.move(moving, frame);
    watch.begin();
    Ogre::FrameEvent event{};
    root._fireFrameStarted(event);
    scene.draw();
    root._fireFrameEnded(event);
    const BenchTimes times = watch.end();
    if (row == nullptr) return;
    row->plan.push_back(times.untilMap);
    row->pass.push_back(times.map);
    row->both.push_back(times.untilMap + times.map);
    row->drawCalls = scene.mapDrawCalls();
    row->layered += times.plan == MapPlan::DrawMoving ? 1U : 0U;
}

std::vector<MovingRow> measureMoving(HeadlessOgre& ogre, std::size_t objects, int map,
                                     const MovingOptions& options) {
    BenchScene scene(ogre, FlatManager, objects);
    scene.manager().setShadowTextureSettings(static_cast<Ogre::uint16>(map), 1, Ogre::PF_FLOAT32_R);
    BenchWatch watch(scene);
    scene.manager().setShadowTextureCasterMaterial(benchCaster());
    scene.setDrawing(true);
    watch.setFinishing(true);
    std::vector<MovingRow> rows;
    for (const int moving : options.moving)
        for (const bool batches : {false, true})
            for (const bool apart : {false, true}) {
                MovingRow row;
                row.objects = objects;
                row.map = map;
                row.moving = moving;
                row.batches = batches;
                row.apart = apart;
                rows.push_back(row);
            }
    std::vector<MovingRow*> order;
    for (MovingRow& row : rows)
        order.push_back(&row);
    // What moves is a receiver too, and would have a map fitted in each frame follow it.
    const auto setup = XPSMShadowCameraSetup::create();
    setup->setLastingMaps(0.1f);
    scene.use(BenchView::Inside, setup);
    scene.turn(0);
    std::mt19937 engine(1);
    for (int turn = 0; turn < options.frames; turn += FramesOfATurn) {
        std::shuffle(order.begin(), order.end(), engine);
        for (MovingRow* row : order) {
            setup->setMovingApart(row->apart);
            static_cast<LixelSceneManager&>(scene.manager()).setCasterBatches(row->batches);
            const std::size_t count = objects * static_cast<std::size_t>(row->moving) / 100;
            for (int frame = 0; frame < FramesToSettle; ++frame)
                drawMovingFrame(ogre.root(), scene, watch, nullptr, count, frame);
            for (int frame = 0; frame < FramesOfATurn; ++frame)
                drawMovingFrame(ogre.root(), scene, watch, row, count, frame);
        }
    }
    return rows;
}

void printMoving(const std::vector<MovingRow>& rows) {
    fmt::print("\n{} objects, a map of {}²; microseconds\n\n{:>8} {:>8} {:>6} {:>8} {:>6} {:>9} "
               "{:>9} {:>9}\n",
               rows.front().objects, rows.front().map, "moving", "batches", "apart", "layered",
               "draws", "plan", "pass", "both");
    for (const MovingRow& row : rows)
        fmt::print("{:>6} % {:>8} {:>6} {:>8} {:>6} {:>9.0f} {:>9.0f} {:>9.0f}\n", row.moving,
                   row.batches ? "yes" : "no", row.apart ? "yes" : "no", row.layered, row.drawCalls,
                   Samples::median(row.plan), Samples::median(row.pass), Samples::median(row.both));
    std::fflush(stdout);
}

void runMoving(const MovingOptions& options) {
    HeadlessOgre ogre;
    ShadowParameters parameters;
    nlohmann::json json{{"frames", options.frames}, {"rows", nlohmann::json::array()}};
    for (const std::size_t objects : options.objects)
        for (const int map : options.maps) {
            const std::vector<MovingRow> rows = measureMoving(ogre, objects, map, options);
            printMoving(rows);
            for (const MovingRow& row : rows)
                json["rows"].push_back({{"objects", row.objects},
                                        {"map", row.map},
                                        {"moving_percent", row.moving},
                                        {"batches", row.batches},
                                        {"moving_apart", row.apart},
                                        {"layered", row.layered},
                                        {"draw_calls", row.drawCalls},
                                        {"plan_us", Samples::median(row.plan)},
                                        {"pass_us", Samples::median(row.pass)},
                                        {"both_us", Samples::median(row.both)}});
        }
    writeJson(json, options.json);
}

} // namespace
} // namespace Lixel::Tests

int main(int argc, char** argv) {
    using namespace Lixel::Tests;
    MovingOptions options;
    CLI::App app("What drawing shadow casters costs where some of them move");
    addObjects(app, options.objects);
    app.add_option("--moving", options.moving, "how many percent of them move in each frame")
        ->delimiter(',')
        ->check(CLI::Range(0, 100))
        ->capture_default_str();
    app.add_option("--map", options.maps, "side of the map in texels")
        ->delimiter(',')
        ->check(CLI::Range(16, 8192))
        ->capture_default_str();
    addFrames(app, options.frames);
    addJson(app, options.json);
    return runBench("lixel-bench-moving-casters", app, argc, argv, [&] { runMoving(options); });
}

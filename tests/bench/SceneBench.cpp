// lixel-bench-scene: what scene managers cost, beside one another, in whole frames.
//
//     lixel-bench-scene [--objects N …] [--frames K] [--manager TYPE …] [--draw] [--announced]
//                       [--build] [--json FILE]
//
// The same field of entities in each scene manager, seen from inside and from its rim, without
// shadows and with several setups for one sun, with everything at rest and with some entities moved
// each frame. Nothing is drawn: OGRE finds what is visible, queues it, and is then told to skip it;
// with --draw it is drawn and waited for. With --announced Lixel's scene manager is promised that
// changes of objects will be announced (LixelSceneManager::setChangesAnnounced). Draw calls are
// counted in a frame that is drawn, in any case. All ways of drawing take turns of a few frames each,
// and times are medians of wall clock: an idle core is all that the machine needs to give. With
// --build: what it takes to fill the scene, to move everything once, and to empty it, and how much
// memory that is.
#include "BenchMain.h"
#include "BenchTable.h"
#include "WriteJson.h"

#include <cstdio>
#include <exception>

namespace Lixel::Tests {
namespace {

struct SceneBenchOptions {
    std::vector<std::size_t> objects{1000, 10000};
    std::string json;
    bool builds = false;
    FrameOptions frames;
};

void run(const SceneBenchOptions& options) {
    HeadlessOgre ogre;
    nlohmann::json json{{"frames", options.frames.frames},
                        {"rows", nlohmann::json::array()},
                        {"builds", nlohmann::json::array()}};
    for (const std::size_t objects : options.objects) {
        if (options.builds) {
            const auto rows = measureBuilds(ogre, objects, options.frames.managers);
            print(rows);
            for (const nlohmann::json& row : toJson(rows))
                json["builds"].push_back(row);
        } else {
            const auto rows = measureFrames(ogre, objects, options.frames);
            print(rows);
            for (const nlohmann::json& row : toJson(rows))
                json["rows"].push_back(row);
        }
    }
    writeJson(json, options.json);
}

} // namespace
} // namespace Lixel::Tests

int main(int argc, char** argv) {
    using namespace Lixel::Tests;
    SceneBenchOptions options;
    options.frames.managers = {DefaultManager, OctreeManager, FlatManager};
    CLI::App app("What scene managers cost, in whole frames");
    addObjects(app, options.objects);
    addFrames(app, options.frames.frames);
    app.add_option("--manager", options.frames.managers, "types of scene managers")
        ->delimiter(',')
        ->capture_default_str();
    app.add_flag("--draw", options.frames.draws, "draw what is found");
    app.add_flag("--announced", options.frames.announced,
                 "promise Lixel's scene manager that changes of objects will be announced");
    app.add_flag("--build", options.builds, "measure filling and emptying the scene instead");
    addJson(app, options.json);
    return runBench("lixel-bench-scene", app, argc, argv, [&] { run(options); });
}

// lixel-bench-still-frames: what shadows cost in a frame in which nothing moves.
//
//     lixel-bench-still-frames [--objects N …] [--frames K] [--json FILE]
//
// The field of lixel-bench-scene in Lixel's scene manager, seen from inside, with one sun whose map is
// drawn with Lixel/Caster. First each setup is drawn until its map has come to rest. Then all take
// turns of some frames: with each setup while the application announces changes
// (LixelSceneManager::setChangesAnnounced) and while it does not, each frame right after one without
// shadows. At first nothing of the view is drawn: OGRE finds what is visible, queues it, and is then
// told to skip it. Then the same is drawn for real and waited for. Frames' times are medians of CPU
// time, of all threads. "shadows" is how much longer a frame takes than the one before it. It is made
// of "survey", "casters" and "fit" as setups measure them, "read", the reading of casters'
// fingerprints by itself, and the "rest".
#include "BenchMain.h"
#include "BenchMaterials.h"
#include "BenchWatch.h"
#include "WriteJson.h"

#include "common/Median.h"
#include "manager/LixelSceneManager.h"
#include "material/ShadowParameters.h"
#include "scene/CasterFingerprint.h"
#include "scene/OgreMath.h"
#include "setup/ShadowCameraSetups.h"

#include <fmt/core.h>

#include <OgreCamera.h>
#include <OgreFrameListener.h>

#include <time.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <random>

namespace Lixel::Tests {
namespace {

constexpr int StillFramesATurn = 6;
/// The first frames of a turn draw the map, and read what it shows.
constexpr int UncountedStillFrames = 4;
/// As long as any search takes to come to rest.
constexpr int FramesToRest = 1500;

struct StillOptions {
    std::vector<std::size_t> objects{1000, 10000, 100000};
    int frames = 60;
    std::string json;
};

struct StillContender {
    const char* name;
    Ogre::ShadowCameraSetupPtr setup;
    bool announced = false;
    std::vector<double> frame{};
    std::vector<double> shadows{}; ///< more than a frame without, right before
    std::vector<double> survey{};
    std::vector<double> casters{};
    std::vector<double> fit{};
    std::vector<double> read{};
    std::size_t kept = 0;
};

/// CPU time of all of the process's threads.
double microsecondsOfProcess() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

class StillScene {
public:
    StillScene(HeadlessOgre& ogre, std::size_t objects)
        : mRoot(ogre.root()), mScene(ogre, FlatManager, objects), mWatch(mScene) {
        mScene.manager().setShadowTextureCasterMaterial(benchCaster());
    }

    void setDrawing(bool draws) {
        mScene.setDrawing(draws);
        mWatch.setFinishing(draws);
    }
    /// From the next frame on.
    void use(const StillContender& contender, bool shadows) {
        mScene.use(BenchView::Inside, shadows ? contender.setup : nullptr);
        mScene.setChangesAnnounced(contender.announced);
    }
    /// Frames are timed by the process's own clock, which others on the machine do not disturb.
    BenchTimes draw() {
        const double begin = microsecondsOfProcess();
        mWatch.begin();
        Ogre::FrameEvent event{};
        mRoot._fireFrameStarted(event);
        mScene.draw();
        mRoot._fireFrameRenderingQueued(event);
        mRoot._fireFrameEnded(event);
        BenchTimes times = mWatch.end();
        times.frame = microsecondsOfProcess() - begin;
        return times;
    }
    /// Microseconds of reading the fingerprints of the last map's casters.
    double readCasters() {
        const Ogre::Camera& viewer = mScene.camera();
        mSurvey.take(viewer, *viewer.getViewport(), mScene.shadowDistance());
        mSearch.find(mSurvey, {.wsDirection = toDouble(mScene.sun().getDerivedDirection())},
                     mScene.shadowDistance());
        const auto begin = std::chrono::steady_clock::now();
        mFingerprint.take(mSearch, true); // as with the option moving_apart
        return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin)
            .count();
    }

private:
    Ogre::Root& mRoot;
    BenchScene mScene;
    BenchWatch mWatch;
    Survey mSurvey;
    CasterSearch mSearch;
    CasterFingerprint mFingerprint;
};

std::vector<StillContender> stillContenders() {
    std::vector<StillContender> all;
    for (const auto& [name, setup] :
         std::initializer_list<std::pair<const char*, Ogre::ShadowCameraSetupPtr>>{
             {"XPSM", XPSMShadowCameraSetup::create()},
             {"Optimal", OptimalShadowCameraSetup::create()}})
        for (const bool announced : {false, true})
            all.push_back({name, setup, announced});
    return all;
}

void takeStillTurn(StillScene& scene, StillContender& contender) {
    for (int i = -UncountedStillFrames; i < StillFramesATurn; ++i) {
        scene.use(contender, false);
        const double without = scene.draw().frame;
        scene.use(contender, true);
        const BenchTimes times = scene.draw();
        if (i < 0) continue;
        contender.frame.push_back(times.frame);
        contender.shadows.push_back(times.frame - without);
        contender.survey.push_back(times.survey);
        contender.casters.push_back(times.casters);
        contender.fit.push_back(times.fit);
        contender.kept += times.plan == MapPlan::Reuse ? 1U : 0U;
    }
    contender.read.push_back(contender.announced ? 0.0 : scene.readCasters());
}

nlohmann::json reportStill(const StillContender& contender, std::size_t objects, bool draws) {
    const double frame = Samples::median(contender.frame);
    const double shadows = Samples::median(contender.shadows);
    const double survey = Samples::median(contender.survey);
    const double casters = Samples::median(contender.casters);
    const double fit = Samples::median(contender.fit);
    const double read = Samples::median(contender.read);
    const double rest = shadows - survey - casters - fit - read;
    const double share = 100.0 * shadows / frame;
    fmt::print(
        "{:8} {:10} {:9.1f} {:9.1f} {:6.1f} % {:8.1f} {:8.1f} {:8.1f} {:8.1f} {:8.1f} {:6}\n",
        contender.name, contender.announced ? "announced" : "read", frame, shadows, share, survey,
        casters, fit, read, rest, fmt::format("{}/{}", contender.kept, contender.frame.size()));
    return {{"objects", objects},
            {"setup", contender.name},
            {"drawn", draws},
            {"announced", contender.announced},
            {"frame_us", frame},
            {"shadows_us", shadows},
            {"survey_us", survey},
            {"casters_us", casters},
            {"fit_us", fit},
            {"read_us", read},
            {"rest_us", rest},
            {"kept", contender.kept},
            {"frames", contender.frame.size()}};
}

void measureStill(HeadlessOgre& ogre, std::size_t objects, int frames, nlohmann::json& rows) {
    StillScene scene(ogre, objects);
    std::vector<StillContender> contenders = stillContenders();
    for (const StillContender& contender : contenders) {
        scene.use(contender, true);
        // Only searches go on, and frames with all of so many objects take long.
        for (int i = 0; i < std::min(FramesToRest, 10 * frames); ++i)
            scene.draw();
    }
    std::mt19937 engine(1);
    for (const bool draws : {false, true}) {
        scene.setDrawing(draws);
        std::vector<StillContender*> order;
        for (StillContender& contender : contenders) {
            contender = {contender.name, contender.setup, contender.announced};
            order.push_back(&contender);
        }
        for (int frame = 0; frame < frames; frame += StillFramesATurn) {
            std::shuffle(order.begin(), order.end(), engine);
            for (StillContender* contender : order)
                takeStillTurn(scene, *contender);
        }
        fmt::print("\n{} objects, {}; microseconds\n\n{:8} {:10} {:>9} {:>9} {:>8} {:>8} {:>8} "
                   "{:>8} {:>8} {:>8} {:>6}\n",
                   objects, draws ? "drawn" : "without drawing", "setup", "changes", "frame",
                   "shadows", "share", "survey", "casters", "fit", "read", "rest", "kept");
        for (const StillContender& contender : contenders)
            rows.push_back(reportStill(contender, objects, draws));
        std::fflush(stdout);
    }
}

void runStill(const StillOptions& options) {
    HeadlessOgre ogre;
    ShadowParameters parameters;
    nlohmann::json rows = nlohmann::json::array();
    for (const std::size_t objects : options.objects)
        measureStill(ogre, objects, options.frames, rows);
    writeJson({{"frames", options.frames}, {"rows", rows}}, options.json);
}

} // namespace
} // namespace Lixel::Tests

int main(int argc, char** argv) {
    using namespace Lixel::Tests;
    StillOptions options;
    CLI::App app("What shadows cost in a frame in which nothing moves");
    addObjects(app, options.objects);
    addFrames(app, options.frames);
    addJson(app, options.json);
    return runBench("lixel-bench-still-frames", app, argc, argv, [&] { runStill(options); });
}

#include "BenchFrames.h"

#include "BenchWatch.h"

#include "common/Median.h"
#include "setup/ShadowCameraSetups.h"

#include <OgreFrameListener.h>
#include <OgreRoot.h>
#include <OgreShadowCameraSetupLiSPSM.h>

#include <algorithm>
#include <memory>
#include <random>
#include <utility>

namespace Lixel::Tests {
namespace {

/// Frames of one way of drawing in a row, after some that are not counted: these find what the way
/// before has left in the caches, and what is kept from frame to frame is old.
constexpr int FramesATurn = 4;
constexpr int UncountedFrames = 2;

constexpr std::array MovedShares{0.01, 0.1};

struct NamedBenchSetup {
    const char* name;
    Ogre::ShadowCameraSetupPtr setup;
};

std::vector<NamedBenchSetup> benchSetups() {
    return {{"none", nullptr},
            {"OGRE's LiSPSM", Ogre::LiSPSMShadowCameraSetup::create()},
            {"Uniform", UniformShadowCameraSetup::create()},
            {"XPSM", XPSMShadowCameraSetup::create()},
            {"Optimal", OptimalShadowCameraSetup::create()}};
}

/// One row on its way.
struct Contender {
    BenchScene* scene;
    BenchWatch* watch;
    Ogre::ShadowCameraSetupPtr setup;
    FrameRow row;
    std::vector<BenchTimes> times{};
    /// Of frames in which entities move: how much longer they took than the one before, in which
    /// nothing moved.
    std::vector<double> longer{};

    double medianTime(double BenchTimes::*member) const {
        std::vector<double> values;
        for (const BenchTimes& each : times)
            values.push_back(each.*member);
        return Samples::median(values);
    }
};

BenchTimes drawFrame(Ogre::Root& root, Contender& contender, int frame, std::size_t moved) {
    contender.scene->turn(frame);
    contender.watch->begin();
    contender.scene->move(moved, frame);
    Ogre::FrameEvent event{};
    root._fireFrameStarted(event);
    contender.scene->draw();
    root._fireFrameRenderingQueued(event);
    root._fireFrameEnded(event);
    return contender.watch->end();
}

void takeTurn(Ogre::Root& root, Contender& contender, int frame, int frames) {
    contender.scene->use(contender.row.view, contender.setup);
    for (int i = -UncountedFrames; i < frames; ++i) {
        const BenchTimes still = drawFrame(root, contender, frame + i, 0);
        BenchTimes times = still;
        if (contender.row.moved > 0)
            times = drawFrame(root, contender, frame + i, contender.row.moved);
        if (i < 0) continue;
        contender.times.push_back(times);
        contender.longer.push_back(times.frame - still.frame);
    }
}

void countDrawCalls(Ogre::Root& root, Contender& contender) {
    contender.scene->use(contender.row.view, contender.setup);
    contender.scene->setDrawing(true);
    drawFrame(root, contender, 0, 0);
    contender.row.viewDrawCalls = contender.scene->viewDrawCalls();
    contender.row.mapDrawCalls = contender.setup ? contender.scene->mapDrawCalls() : 0;
    contender.scene->setDrawing(false);
}

void addContenders(BenchScene& scene, BenchWatch& watch, const std::string& manager,
                   std::vector<Contender>& all) {
    for (const NamedBenchSetup& setup : benchSetups())
        for (const BenchView view : BenchViews) {
            Contender contender{&scene, &watch, setup.setup, {}};
            contender.row.manager = manager;
            contender.row.setup = setup.name;
            contender.row.objects = scene.objects();
            contender.row.view = view;
            all.push_back(contender);
            if (setup.setup) continue;
            for (const double share : MovedShares) {
                contender.row.movedShare = share;
                contender.row.moved = std::max<std::size_t>(
                    1, static_cast<std::size_t>(share * static_cast<double>(scene.objects() - 1)));
                all.push_back(contender);
            }
        }
}

FrameRow finish(Contender& contender) {
    FrameRow row = contender.row;
    if (row.moved > 0)
        row.nanosecondsAMove =
            1000 * Samples::median(contender.longer) / static_cast<double>(row.moved);
    row.frame = contender.medianTime(&BenchTimes::frame);
    row.survey = contender.medianTime(&BenchTimes::survey);
    row.casters = contender.medianTime(&BenchTimes::casters);
    row.fit = contender.medianTime(&BenchTimes::fit);
    row.find = contender.medianTime(&BenchTimes::find);
    row.findMap = contender.medianTime(&BenchTimes::findMap);
    row.map = contender.medianTime(&BenchTimes::map);
    return row;
}

} // namespace

std::vector<FrameRow> measureFrames(HeadlessOgre& ogre, std::size_t objects,
                                    const FrameOptions& options) {
    std::vector<std::unique_ptr<BenchScene>> scenes;
    std::vector<std::unique_ptr<BenchWatch>> watches;
    std::vector<Contender> all;
    for (const std::string& manager : options.managers) {
        scenes.push_back(std::make_unique<BenchScene>(ogre, manager, objects));
        scenes.back()->setChangesAnnounced(options.announced);
        watches.push_back(std::make_unique<BenchWatch>(*scenes.back()));
        addContenders(*scenes.back(), *watches.back(), manager, all);
    }
    for (Contender& contender : all)
        countDrawCalls(ogre.root(), contender);
    for (const auto& scene : scenes)
        scene->setDrawing(options.draws);
    for (const auto& watch : watches)
        watch->setFinishing(options.draws);
    // Each time in another order: nobody always comes after the same one.
    std::vector<Contender*> order;
    for (Contender& contender : all)
        order.push_back(&contender);
    std::mt19937 engine(1);
    for (int frame = 0; frame < options.frames; frame += FramesATurn) {
        std::shuffle(order.begin(), order.end(), engine);
        for (Contender* contender : order)
            takeTurn(ogre.root(), *contender, frame, std::min(FramesATurn, options.frames - frame));
    }
    std::vector<FrameRow> rows;
    for (Contender& contender : all)
        rows.push_back(finish(contender));
    watches.clear();
    return rows;
}

} // namespace Lixel::Tests

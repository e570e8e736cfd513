#include "BenchBuild.h"

#include "BenchScene.h"

#include "common/Median.h"

#include <malloc.h>

#include <algorithm>
#include <chrono>

namespace Lixel::Tests {
namespace {

constexpr int Repetitions = 3;

class Stopwatch {
public:
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(Clock::now() - mBegin).count();
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point mBegin = Clock::now();
};

/// Bytes that the process has asked for and not given back.
double memoryInUse() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
}

BuildRow build(HeadlessOgre& ogre, const std::string& manager, std::size_t objects) {
    BuildRow row{manager, objects};
    {
        // Meshes and materials are made on first use.
        BenchScene warmUp(ogre, manager, 2);
        warmUp.draw();
    }
    const double before = memoryInUse();
    const Stopwatch buildWatch;
    BenchScene scene(ogre, manager, objects);
    row.build = buildWatch.milliseconds();
    scene.use(BenchView::Outwards, nullptr);
    const Stopwatch frameWatch;
    scene.draw();
    row.firstFrame = frameWatch.milliseconds();
    row.bytes = (memoryInUse() - before) / static_cast<double>(objects);
    scene.draw();
    const Stopwatch moveWatch;
    scene.move(objects - 1, 0);
    scene.manager()._updateSceneGraph(nullptr);
    row.move = 1e6 * moveWatch.milliseconds() / static_cast<double>(objects - 1);
    const Stopwatch clearWatch;
    scene.clear();
    row.clear = clearWatch.milliseconds();
    return row;
}

double medianOf(const std::vector<BuildRow>& rows, double BuildRow::*member) {
    std::vector<double> values;
    for (const BuildRow& row : rows)
        values.push_back(row.*member);
    return Samples::median(values);
}

} // namespace

std::vector<BuildRow> measureBuilds(HeadlessOgre& ogre, std::size_t objects,
                                    const std::vector<std::string>& managers) {
    std::vector<std::vector<BuildRow>> all(managers.size());
    for (int i = 0; i < Repetitions; ++i)
        for (std::size_t manager = 0; manager < managers.size(); ++manager)
            all[manager].push_back(build(ogre, managers[manager], objects));
    std::vector<BuildRow> medians;
    for (std::vector<BuildRow>& rows : all) {
        BuildRow median{rows.front().manager, objects};
        for (const auto member : {&BuildRow::build, &BuildRow::firstFrame, &BuildRow::move,
                                  &BuildRow::clear, &BuildRow::bytes})
            median.*member = medianOf(rows, member);
        medians.push_back(median);
    }
    return medians;
}

} // namespace Lixel::Tests

#include "BenchTable.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace Lixel::Tests {
namespace {

/// The frame of OGRE's default scene manager without shadows that a row is compared with; 0 where
/// that was not measured.
double standardOf(const FrameRow& row, const std::vector<FrameRow>& rows) {
    const auto standard = std::ranges::find_if(rows, [&](const FrameRow& other) {
        return other.manager == DefaultManager && other.setup == "none" && other.moved == 0 &&
               other.view == row.view && other.objects == row.objects;
    });
    return standard == rows.end() ? 0 : standard->frame;
}

void printFrames(const std::vector<FrameRow>& rows, BenchView view) {
    const bool draws = std::ranges::any_of(rows, [](const FrameRow& row) { return row.map > 0; });
    fmt::print("\n{} objects, {}; microseconds, and the frame as a multiple of the default "
               "manager's without shadows\n\n",
               rows.front().objects, toString(view));
    fmt::print("{:20} {:14} {:>9} {:>6} {:>8} {:>8} {:>8} {:>8} {:>8} {:>9} {:>6} {:>6}\n",
               "manager", "setup", "frame", "", "find", "survey", "casters", "fit", "find map",
               draws ? "draw map" : "", "draws", "of map");
    for (const FrameRow& row : rows) {
        if (row.view != view || row.moved > 0) continue;
        const double standard = standardOf(row, rows);
        fmt::print("{:20} {:14} {:9.0f} {:>6} {:8.1f} {:8.1f} {:8.1f} {:8.1f} {:8.1f} {:>9} {:6} "
                   "{:6}\n",
                   row.manager, row.setup, row.frame,
                   standard > 0 ? fmt::format("{:.2f}", row.frame / standard) : "", row.find,
                   row.survey, row.casters, row.fit, row.findMap,
                   draws ? fmt::format("{:.0f}", row.map) : "", row.viewDrawCalls,
                   row.mapDrawCalls);
    }
}

void printMoves(const std::vector<FrameRow>& rows) {
    fmt::print("\n{} objects, no shadows; nanoseconds a moved entity\n\n{:20} {:9} {:>8} {:>8} "
               "{:>9} {:>9}\n",
               rows.front().objects, "manager", "view", "share", "moved", "frame", "a move");
    for (const FrameRow& row : rows)
        if (row.moved > 0)
            fmt::print("{:20} {:9} {:8.0f}% {:7} {:9.0f} {:9.0f}\n", row.manager,
                       toString(row.view), 100 * row.movedShare, row.moved, row.frame,
                       row.nanosecondsAMove);
}

} // namespace

void print(const std::vector<FrameRow>& rows) {
    if (rows.empty()) return;
    for (const BenchView view : BenchViews)
        printFrames(rows, view);
    printMoves(rows);
    std::fflush(stdout);
}

void print(const std::vector<BuildRow>& rows) {
    if (rows.empty()) return;
    fmt::print("\n{} objects\n\n{:20} {:>9} {:>14} {:>14} {:>9} {:>13}\n", rows.front().objects,
               "manager", "build ms", "first frame ms", "ns a move", "clear ms", "bytes each");
    for (const BuildRow& row : rows)
        fmt::print("{:20} {:9.1f} {:14.1f} {:14.0f} {:9.1f} {:13.0f}\n", row.manager, row.build,
                   row.firstFrame, row.move, row.clear, row.bytes);
    std::fflush(stdout);
}

nlohmann::json toJson(const std::vector<FrameRow>& rows) {
    nlohmann::json all = nlohmann::json::array();
    for (const FrameRow& row : rows) {
        nlohmann::json object{{"manager", row.manager},
                              {"setup", row.setup},
                              {"objects", row.objects},
                              {"view", toString(row.view)},
                              {"frame_us", row.frame},
                              {"survey_us", row.survey},
                              {"casters_us", row.casters},
                              {"fit_us", row.fit},
                              {"find_us", row.find},
                              {"find_map_us", row.findMap},
                              {"draw_calls", row.mapDrawCalls},
                              {"view_draw_calls", row.viewDrawCalls}};
        if (row.map > 0) object["draw_map_us"] = row.map;
        if (row.moved > 0) {
            object["moved_share"] = row.movedShare;
            object["moved"] = row.moved;
            object["ns_per_moved"] = row.nanosecondsAMove;
        }
        all.push_back(object);
    }
    return all;
}

nlohmann::json toJson(const std::vector<BuildRow>& rows) {
    nlohmann::json all = nlohmann::json::array();
    for (const BuildRow& row : rows)
        all.push_back({{"manager", row.manager},
                       {"objects", row.objects},
                       {"build_ms", row.build},
                       {"first_frame_ms", row.firstFrame},
                       {"ns_per_moved", row.move},
                       {"clear_ms", row.clear},
                       {"bytes_per_entity", row.bytes}});
    return all;
}

} // namespace Lixel::Tests

#pragma once

#include "BenchScene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace Lixel::Tests {

/// One way of drawing, measured: medians, in microseconds.
struct FrameRow {
    std::string manager;
    std::string setup;
    std::size_t objects = 0;
    BenchView view{};
    /// Entities moved each frame, of all but the ground; 0 for none.
    double movedShare = 0;
    std::size_t moved = 0;

    double frame = 0;
    double survey = 0;  ///< Lixel's setups only
    double casters = 0; ///< Lixel's setups only
    double fit = 0;     ///< Lixel's setups only
    double find = 0;    ///< what the viewer sees, and queueing it
    double findMap = 0; ///< what the shadow camera sees, and queueing it
    double map = 0;     ///< drawing the map, only where that is asked for

    std::size_t mapDrawCalls = 0;
    std::size_t viewDrawCalls = 0;
    /// Nanoseconds for each moved entity more than the same frame without moves takes; the moving
    /// itself among them.
    double nanosecondsAMove = 0;
};

struct FrameOptions {
    std::vector<std::string> managers;
    int frames = 40; ///< measured, of each row
    bool draws = false;
    bool announced = false; ///< changes of objects, to LixelSceneManager
};

/// Measures all ways of drawing scenes of that many objects, in turns, so that what slows the
/// machine down meets them all alike.
std::vector<FrameRow> measureFrames(HeadlessOgre& ogre, std::size_t objects,
                                    const FrameOptions& options);

} // namespace Lixel::Tests

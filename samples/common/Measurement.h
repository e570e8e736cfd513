#pragma once

#include "common/Stage.h"
#include "common/TruthComparison.h"

#include <Lixel/setup/ShadowMapObserver.h>

namespace Lixel::Samples {

/// What one shadow setup costs and gives on one view; times are medians over the frames measured.
struct Measurement {
    ClassificationError error; ///< against the oracle, one nearest tap
    double surveyMicroseconds = 0.0;
    double fitMicroseconds = 0.0;
    double casterMilliseconds = 0.0;
    double receiverMilliseconds = 0.0;
    double frameMilliseconds = 0.0;
    /// Of a frame in which nothing has changed, so that maps may be reused.
    double stillFrameMilliseconds = 0.0;
    // What is done with the maps of such a frame.
    std::size_t mapsDrawn = 0;
    std::size_t mapsDrawnMoving = 0; ///< of those: what moves, over a copy of what stands still
    std::size_t mapsReused = 0;
    std::size_t mapsSkipped = 0;
    std::string reason; ///< what kept the fit from its ideal, "none" where nothing did
};

/** Draws `frames` frames (>= 1) after one to warm up, and times them, with all maps drawn anew; then
    as many in which nothing changes.

    On a software renderer the clock is the process' CPU time around glFinish, which counts the
    renderer's threads too; on a GPU it is the wall clock.
*/
Measurement measureFrames(Stage& stage, int frames);

/** How wrong the next frame's shadows are, against exact ones.

    @param oracle of this stage's scene
    @param shadowDistance as SampleScene's
    @param[out] visibility if not null, what was drawn
    @param[out] truth if not null, what it should have been
*/
ClassificationError measureError(Stage& stage, const ShadowOracle& oracle, double shadowDistance,
                                 std::vector<std::uint8_t>* visibility = nullptr,
                                 ShadowTruth* truth = nullptr);

} // namespace Lixel::Samples

#pragma once

#include "Sweeps.h"

#include "common/Setups.h"

#include <limits>

namespace Lixel::Tests {

/// How a sweep is run.
struct SweepOptions {
    int frames = 401;   ///< the middle one at the singular direction
    double step = 1e-4; ///< radians between two
    /// Of a step: 0 hits the singular direction exactly, 0.5 passes it by.
    double offset = 0.0;
};

/** How steady a map is along a sweep.

    ln m, the logarithm of a texel's largest extent in pixels, is compared between successive frames
    at points that both frames see, light (n.l, n.v >= 0.05) and have in the same one of their maps.
    @see fit/problem/TexelInPixels.h
*/
struct Steadiness {
    double greatest = 0.0;       ///< change of ln m from one frame to the next
    double greatestSteady = 0.0; ///< the same without maps whose orientation jumps in the frame
    double percentile99 = 0.0;   ///< of all points' and frames' changes
    int greatestFrame = 0;       ///< of greatestSteady
    int unsteadySteps = 0;       ///< how often a map changes by more than MostChange without one
    int jumps = 0;               ///< how often a map's axes turn
    /// Share of the map's area that a jump saves, the least of all of them; infinite without any.
    double leastGain = std::numeric_limits<double>::infinity();
    int framesWithoutMap = 0;
    std::size_t measured = 0; ///< pairs of points
};

/// Contract of a fit, 7: what 1e-4 rad may change ln m by.
constexpr double MostChange = 0.02;

/// Degrees by which a map's axes turn in a frame that count as a jump: 175 times as far as light or
/// viewer turn. A rectangle whose sides have the ratio r gains a tenth of its area, the least for
/// which an orientation may be given up, when it turns by 0.1 / (r + 1 / r): by more than this up
/// to r = 5.
constexpr double LeastJump = 1.0;
/// How many times as far a jump turns it as the frame before did. What turns gradually is no jump: it
/// has to keep within MostChange. (Where a map is narrow, a warp that follows turns texels' sides by
/// one or two degrees and changes m by 0.006.)
constexpr double SuddenTurn = 2.0;

/// Contract of a fit, 7: the share of its area that a jump must save.
constexpr double LeastGain = 0.1;

/** Runs the sweep on the stage, which must be new, with one instance of the setup, whose memory it
    keeps as in an application.
    @exception whatever OGRE or the oracle throws; OGRE may also abort the process
*/
Steadiness runSweep(Samples::Stage& stage, const Sweep& sweep, const Samples::NamedSetup& setup,
                    const SweepOptions& options);

} // namespace Lixel::Tests

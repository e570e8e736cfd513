#pragma once

#include "HardCases.h"

#include <Lixel/setup/FittedShadowCameraSetup.h>

namespace Lixel::Tests {

/** How large XPSM's texels are expected to be where the viewer looks, by the measure that its guard
    judges by, relative to a uniform map's: below 1 they are smaller. @see fit/sampling/TexelExtent.h

    Spots' are 1: XPSM gives them the uniform map.
*/
struct ExpectedExtent {
    bool judged = false;  ///< there is a map, and something that it can be judged by
    double guarded = 1.0; ///< as drawn: warm, after the frames before
    double literal = 1.0; ///< without the guard: the paper's
    /// Of all frames so far.
    double greatestGuarded = 0.0;
};

/** Guarded XPSM as applications have it, which says of each frame what is expected of it. */
class ExtentSetup : public FittedShadowCameraSetup {
public:
    /// @param extent what is told, which outlives the setup
    explicit ExtentSetup(ExpectedExtent& extent) : mExtent(extent) {}

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept override;

private:
    ExpectedExtent& mExtent;
};

/** What is expected of the case's judged frame. The stage must be new.
    @exception whatever OGRE throws
*/
ExpectedExtent expectedExtent(Samples::Stage& stage, const HardCase& hardCase);

/** Prints what is expected in every hard case, then in the samples' scenes, all views and lights,
    each with a summary.
    @return in how many cases the guarded map is expected to be worse than a uniform one
*/
int printExtents(const std::vector<const HardCase*>& cases);

} // namespace Lixel::Tests

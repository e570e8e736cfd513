#pragma once

#include "fit/core/WarpContext.h"

/** The one fit that every technique shares.

    A technique is a rule that picks the warp. Focusing, the warp's safety, the affine fit, the
    depth row and the matrices are here.

    Every fit and every division into parts is noexcept, and gives a reason for bad input. Vectors
    of its state and its problem grow to the scene's size nevertheless: where memory for that is
    refused, the program ends (std::terminate).
*/
namespace Lixel {

/// Runs the shared fit around a rule. Never throws; bad input gives a fit without a map.
ShadowFit fitWithRule(const ShadowProblem& problem, FitState& state, const WarpRule& rule) noexcept;

/** Lets a fit's focus polygon be all that its map has room for, up to near its horizon: so that
    casters are drawn on all of its light rays, for a map that is to serve other regions too.
    @param state its scratch memory is used */
void focusOnWindow(ShadowFit& fit, FitState& state) noexcept;

} // namespace Lixel

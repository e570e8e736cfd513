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

/** A fit whose texels are those of an earlier map, of the same size and for the same light: what
    both maps show lies in texels on the same rays, so that its shadows' edges stay where they are.
    Only the map's window moves, by whole texels, and its depths are new.

    @param wsShift of the problem's origin relative to the earlier map's, in world units
    @return none where there is nothing to draw, or where the earlier map's texels are too fine for
    a map of its size to show the region
*/
std::optional<ShadowFit> fitToTexels(const ShadowProblem& problem, FitState& state,
                                     const ShadowFit& earlier, const Vec3& wsShift) noexcept;

} // namespace Lixel

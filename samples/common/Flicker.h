#pragma once

#include "common/ShadowOracle.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace Lixel::Samples {

/** Pixels of a frame whose points can be followed into the next frame.

    Those are visible in both, away from silhouettes by more than two pixels in both, and truly Lit
    or truly Shadowed. Scene and light stand still, so the truth is the same in both frames.

    A silhouette is where two neighbouring pixels show points that are farther apart than one
    surface explains, or where one of them shows nothing.

    @param truth of the points that are visible now
    @param next what is visible in the next frame
    @param nextView of that frame
*/
std::vector<std::size_t> followedPixels(const VisiblePoints& now, const OracleView& nowView,
                                        const ShadowTruth& truth, const VisiblePoints& next,
                                        const OracleView& nextView);

/** How many of these pixels are classified otherwise in the next frame.

    @param visibilityNow, visibilityNext of the same points, as MapEmulation::visibility gives it
*/
std::size_t changedPixels(std::span<const std::size_t> followed,
                          std::span<const std::uint8_t> visibilityNow,
                          std::span<const std::uint8_t> visibilityNext);

} // namespace Lixel::Samples

#pragma once

#include "fit/problem/ShadowFit.h"

namespace Lixel {

/// How a map that was fitted before serves what is seen now.
struct KeptFit {
    /// Whether it shows every light ray of the fresh fit's focus region, among those on which its
    /// casters were drawn, and has depths for it all.
    bool covers = false;
    /// Side of its texels relative to the fresh fit's, where that has its texels: 1 is as fine.
    double coarseness = 0.0;
};

/** Compares a kept map with a fresh fit for the same light, and for a map of the same size.

    The mean of coarseness is taken over the fresh fit's focus region, weighted with the fresh map's
    texels: it has them where they are wanted.

    @param wsShift of the fresh fit's origin relative to the kept one's, in world units
    @return {false, 0} unless both have a map
*/
KeptFit compareFits(const ShadowFit& kept, const ShadowFit& fresh, const Vec3& wsShift) noexcept;

} // namespace Lixel

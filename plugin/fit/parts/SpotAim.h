#pragma once

#include "fit/geometry/ConvexVolume.h"
#include "fit/problem/ShadowProblem.h"
#include "fit/sampling/ViewRays.h"

#include <optional>

namespace Lixel {

/// Scratch memory of aiming, kept between frames.
struct AimScratch {
    ClipScratch clip;
    std::vector<Vec3> wsPoints;
    std::vector<Vec3> directions;
    ViewRays rays;
};

/** Widest half angle, in radians, to which a spot is aimed: 80°. Its map is tan(80°) = 5.7 times as
    wide as the light is far, so that a uniform texel is 33 times as large in the middle as at the
    rim; wider than that several maps are the better choice. */
inline constexpr double WidestAim = 1.3962634015954636;

/** A point light, or a spot too wide for one map, as the narrowest spot that will do.

    Around the smaller of two cones: that of what the viewer sees of the receivers, within the
    light's range, and that of the casters within it; only what is in both can be shadowed.

    @param[out] spot the light as a spot, where there is one
    @return whether one of the two fits into a cone of WidestAim. A set that has a body without
    bounds gives no cone. Where there is nothing to shadow, any cone will do.
*/
bool aimSpot(const ShadowProblem& problem, AimScratch& scratch, ShadowLight& spot);

/** The same where no spot will do: one of WidestAim, along the mean direction in which light reaches
    what the viewer sees. What lies outside of its cone is not served.
    @param wsAxis the last frame's axis, which is kept while the mean is near it, so that the cone's
           border stands still and the map may; it is set */
ShadowLight widestSpot(const ShadowProblem& problem, AimScratch& scratch,
                       std::optional<Vec3>& wsAxis);

/// The spot around directions from the light; false where they need more than the widest half
/// angle, or there are none. @param directions of any length but zero; they are changed
bool spotAround(const ShadowLight& light, double widest, std::vector<Vec3>& directions,
                ShadowLight& spot);

} // namespace Lixel

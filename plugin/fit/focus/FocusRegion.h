#pragma once

#include "fit/focus/FocusScratch.h"
#include "fit/geometry/BoxSet.h"
#include "fit/problem/ShadowFit.h"

namespace Lixel {

/** The focus region: the light rays that meet a visible receiver and a caster before it.

    Gusev 2007, §3.6 takes the boxes of all receivers and of all casters. Here receivers are clipped
    to the view volume first, casters that cannot shadow a receiver are left out, and hulls are
    intersected instead of boxes. Otherwise the map would have to cover the whole box of a large
    ground. A large body that says that it shadows nothing of itself is no caster for itself
    (SelfShadowFree.h): or the ground would have all that is visible of it in the map.
*/
struct FocusRegion {
    /// None, UnboundedBody, or the reason why there is nothing to focus on.
    FitReason reason = FitReason::InvalidInput;
    /// Convex hull of the region in the light image, counter-clockwise.
    Polygon2 liHull;
    /// Interior point of the hull.
    Vec2 liCentre = Vec2::Zero();
    /// Distances along the light's axis (-z of light space) of visible receivers.
    double lsReceiverNear = 0.0;
    double lsReceiverFar = 0.0;
    /// The same of the casters that matter; their near end may be in front of the receivers'.
    double lsCasterNear = 0.0;
    /// Depths in front of the viewer of the visible receivers.
    double vsReceiverNear = 0.0;
    double vsReceiverFar = 0.0;
    /// The receivers that may reach into what is in view and lit.
    BoxSet receiversInView;
    /// The casters that may cover visible receivers.
    BoxSet coveringCasters;
};

/// Finds the focus region. @param[out] region overwritten; its memory is used again
void findFocusRegion(const ShadowProblem& problem, const LightImage& image, FocusScratch& scratch,
                     FocusRegion& region);

} // namespace Lixel

#include "fit/focus/FocusRegion.h"

#include "fit/focus/LightVolume.h"
#include "fit/focus/RelevantCasters.h"
#include "fit/focus/ViewVolume.h"
#include "fit/focus/VisibleReceivers.h"

#include <algorithm>

namespace Lixel {

void findFocusRegion(const ShadowProblem& problem, const LightImage& image, FocusScratch& scratch,
                     FocusRegion& region) {
    region = FocusRegion{.reason = FitReason::None,
                         .liHull = std::move(region.liHull),
                         .receiversInView = std::move(region.receiversInView),
                         .coveringCasters = std::move(region.coveringCasters)};
    region.liHull.clear();
    const auto stop = [&](FitReason reason) { region.reason = reason; };

    const BoxSet& casters = *problem.casters;
    const BoxSet& receivers = *problem.receivers;
    if (receivers.empty()) return stop(FitReason::NoReceivers);
    if (casters.empty()) return stop(FitReason::NothingShadowed);

    // Visible receivers, clipped to what the viewer sees and the light reaches.
    const ConvexVolume lit = lightVolume(problem.light, image);
    VisibleReceivers visible(problem, image, lit, scratch, region.receiversInView);
    visible.addAll(receivers);
    if (receivers.unbounded() > 0) {
        Aabb everything;
        if (!viewBounds(problem.viewer, everything)) return stop(FitReason::Unbounded);
        visible.addClipped(everything);
        region.reason = FitReason::UnboundedBody;
    }
    visible.addLeaving();
    if (visible.hull().hull().empty()) return stop(FitReason::NoReceivers);
    region.lsReceiverNear = visible.lsRange().x();
    region.lsReceiverFar = visible.lsRange().y();
    region.vsReceiverNear = visible.vsRange().x();
    region.vsReceiverFar = visible.vsRange().y();

    // Casters between the light and a visible receiver.
    RelevantCasters covering(problem, image, lit, visible, region.receiversInView,
                             region.coveringCasters, scratch);
    covering.addAll(casters);
    region.lsCasterNear = covering.lsNear();
    if (casters.unbounded() > 0) {
        region.reason = FitReason::UnboundedBody;
        region.lsCasterNear = std::min(region.lsCasterNear, region.lsReceiverNear);
        region.liHull = visible.hull().hull();
    } else {
        region.liHull = covering.hull().hull();
    }
    if (region.liHull.empty()) return stop(FitReason::NothingShadowed);
    region.liCentre = steinerPoint(region.liHull);
}

} // namespace Lixel

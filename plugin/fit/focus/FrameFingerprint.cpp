#include "fit/focus/FrameFingerprint.h"

#include "fit/focus/ViewVolume.h"

#include <algorithm>
#include <limits>

namespace Lixel {

FrameFingerprint fingerprintOf(const ShadowProblem& problem, const LightImage& image,
                               const FocusRegion& region) {
    double perimeter = 0.0;
    for (std::size_t i = 0; i < region.liHull.size(); ++i)
        perimeter += (region.liHull[(i + 1) % region.liHull.size()] - region.liHull[i]).norm();
    const Vec3 viewer = image.oriented(image.lsFromPoint(wsEyeOf(problem.viewer)));
    const double distance =
        viewer.z() > 0.0 ? (region.liCentre - viewer.head<2>() / viewer.z()).norm() : 0.0;
    return {Vec3(distance, perimeter, region.vsReceiverFar),
            -problem.viewer.viewFromWorld.row(2).head<3>().stableNormalized(),
            image.lsFromWs().row(2)};
}

double relativeChange(double a, double b) {
    return std::abs(a - b) / std::max(std::abs(a + b), std::numeric_limits<double>::min());
}

double turnBetween(const FrameFingerprint& a, const FrameFingerprint& b) {
    return std::max((a.wsView - b.wsView).norm(), (a.wsLight - b.wsLight).norm());
}

double changeBetween(const FrameFingerprint& a, const FrameFingerprint& b) {
    double change = turnBetween(a, b);
    for (Eigen::Index i = 0; i < 3; ++i)
        change = std::max(change, relativeChange(a.measures[i], b.measures[i]));
    return change;
}

} // namespace Lixel

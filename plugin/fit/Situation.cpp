#include "fit/Situation.h"

#include <algorithm>
#include <limits>

namespace Lixel {

Situation situationOf(const ShadowProblem& problem, const LightImage& image,
                      const FocusRegion& region, const Vec3& viewer) {
    double perimeter = 0.0;
    for (std::size_t i = 0; i < region.liHull.size(); ++i)
        perimeter += (region.liHull[(i + 1) % region.liHull.size()] - region.liHull[i]).norm();
    const double distance =
        viewer.z() > 0.0 ? (region.liCentre - viewer.head<2>() / viewer.z()).norm() : 0.0;
    return {Vec3(distance, perimeter, region.vsReceiverFar),
            -problem.viewer.viewFromWorld.row(2).head<3>().stableNormalized(),
            image.lsFromWs().row(2)};
}

double changeBetween(const Situation& a, const Situation& b) {
    const double lengths =
        ((a.measures - b.measures).cwiseAbs().array() /
         (a.measures + b.measures).cwiseAbs().array().max(std::numeric_limits<double>::min()))
            .maxCoeff();
    return std::max({lengths, (a.wsView - b.wsView).norm(), (a.wsLight - b.wsLight).norm()});
}

} // namespace Lixel

#include "fit/CascadeSplits.h"

#include "fit/Fit.h"
#include "fit/ShadowParts.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace Lixel {
namespace {

/// Most that a settled depth changes in a frame in which nothing moves noticeably, as the logarithm
/// of a ratio, and how much more for each unit of change. A slice that ends at it follows, and where
/// shadows end in the slice, what is left of them changes by a dozen times as much: 12 (0.0005 +
/// 4 x 1e-4), with what the slice's own search may change, is below the 0.02 that a fit may change
/// when something turns by 1e-4.
constexpr double SteadyStep = 0.0005;
constexpr double SteadyGrowth = 4.0;

/// Step from which on a depth is not settled at all.
constexpr double CutStep = 0.693; // ln 2

/// Least ratio of nearest and farthest: an eye that touches a receiver wants no slice for it.
constexpr double LeastNearRatio = 1e-4;

/// All that view rays find: the least and the greatest of few would be anywhere.
constexpr std::size_t Samples = ViewRays::Rounds * ViewRays::Count;

/// Both ends move together: one that jumps may come by the other.
void settle(double nearest, double farthest, const Situation& situation, CascadeMemory& memory) {
    const double greatest = SteadyStep + SteadyGrowth * changeBetween(situation, memory.situation);
    memory.situation = situation;
    const double nearStep = std::log(nearest / memory.nearest);
    const double farStep = std::log(farthest / memory.farthest);
    // Negated, so that it holds where there was nothing before.
    if (!(std::abs(nearStep) <= CutStep) || !(std::abs(farStep) <= CutStep)) {
        memory.nearest = nearest;
        memory.farthest = farthest;
        return;
    }
    memory.nearest *= std::exp(std::clamp(nearStep, -greatest, greatest));
    memory.farthest *= std::exp(std::clamp(farStep, -greatest, greatest));
    memory.nearest = std::min(memory.nearest, memory.farthest);
}

/// Depths of what is seen of all slices together; false where nothing is.
bool findDepths(const ShadowProblem& problem, CascadeMemory& memory) {
    if (!isValid(problem) || needsParts(problem.light)) return false;
    FitState& state = memory.state;
    FocusRegion& region = state.region;
    const LightImage image(problem.light);
    findFocusRegion(problem, image, state.scratch, region);
    if (!hasMap(region.reason)) return false;
    sampleView(problem, image, region.liHull, state.scratch.receiversInView, Samples,
               state.sampling, state.samples);
    double nearest = region.vsReceiverNear;
    double farthest = region.vsReceiverFar;
    if (!state.samples.empty()) {
        nearest = farthest;
        farthest = 0.0;
        for (const ViewSample& sample : state.samples) {
            nearest = std::min(nearest, sample.vsDepth);
            farthest = std::max(farthest, sample.vsDepth);
        }
    }
    nearest = std::max(nearest, LeastNearRatio * farthest);
    if (!(nearest > 0.0) || !std::isfinite(farthest)) return false;
    const Vec3 wsEye = problem.viewer.viewFromWorld.inverse().topRightCorner<3, 1>();
    const Vec3 viewer = image.oriented(image.lsFromPoint(wsEye));
    settle(nearest, farthest, situationOf(problem, image, region, viewer), memory);
    return true;
}

/// Depths of the viewer's own clip planes and shadow distance; false for a view without end.
bool planDepths(const ShadowProblem& problem, CascadeMemory& memory) {
    ShadowViewer viewer = problem.viewer;
    viewer.viewFromWorld = Mat4::Identity();
    Box box;
    if (!viewer.clipFromView.allFinite() || !viewBounds(viewer, box)) return false;
    memory.farthest = -(box.centre.z() - box.halfExtents.z());
    memory.nearest =
        std::max(-(box.centre.z() + box.halfExtents.z()), LeastNearRatio * memory.farthest);
    return memory.nearest > 0.0;
}

} // namespace

void cascadeSplits(const ShadowProblem& problem, int count, const CascadeOptions& options,
                   CascadeMemory& memory, std::vector<double>& vsSplits) {
    vsSplits.clear();
    if (count < 2) return;
    if (options.followReceivers ? !findDepths(problem, memory) : !planDepths(problem, memory))
        return;
    const double ratio = memory.farthest / memory.nearest;
    const double uniformity = std::clamp(options.uniformity, 0.0, 1.0);
    for (int i = 1; i < count; ++i) {
        const double part = static_cast<double>(i) / count;
        const double logarithmic = memory.nearest * std::pow(ratio, part);
        const double uniform = memory.nearest + (memory.farthest - memory.nearest) * part;
        vsSplits.push_back(logarithmic + uniformity * (uniform - logarithmic));
    }
}

} // namespace Lixel

#include "fit/parts/CascadeSplits.h"

#include "fit/core/Fit.h"
#include "fit/focus/ViewVolume.h"
#include "fit/parts/CascadeMemory.h"
#include "fit/parts/LightPartition.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace Lixel {
namespace {

/// Most that a settled depth changes in a frame in which nothing moves noticeably, as the logarithm
/// of a ratio, and how much more for each unit of change. Texels of a slice whose edge moves change
/// by four times as much, or by a dozen times where shadows end near the edge, as was measured:
/// with what the slice's own search may change they stay below the 0.02 that a fit may change when
/// something turns by 1e-4.
constexpr double SteadyStep = 0.0005;
constexpr double SteadyGrowth = 4.0;

/// Most that it changes in any frame while it follows: a factor of two takes a quarter of a second.
constexpr double GreatestStep = 0.05;

/// What is farther from it than this, as by a camera cut, is not followed but taken at once.
constexpr double CutStep = 0.693; // ln 2

/// Least ratio of nearest and farthest: an eye that touches a receiver wants no slice for it.
constexpr double LeastNearRatio = 1e-4;

/// All that view rays find: the least and the greatest of few would be anywhere.
constexpr std::size_t AllSamples = ViewRays::Rounds * ViewRays::Count;

CascadeView viewOf(const ShadowProblem& problem, const LightImage& image,
                   const FocusRegion& region) {
    return {fingerprintOf(problem, image, region), problem.wsOrigin + wsEyeOf(problem.viewer),
            region.vsReceiverNear};
}

/// Has the depths follow what is seen now.
void settle(double nearest, double farthest, const CascadeView& view, CascadeMemory& memory) {
    const CascadeView before = std::exchange(memory.view, view);
    const double moved = (view.wsEye - before.wsEye).norm() / memory.nearest;
    const double nearStep = std::log(nearest / memory.nearest);
    const double farStep = std::log(farthest / memory.farthest);
    // False where there was nothing before.
    const bool follows = std::abs(nearStep) <= CutStep && std::abs(farStep) <= CutStep &&
                         moved < 1.0 &&
                         turnBetween(view.fingerprint, before.fingerprint) < CameraCutChange;
    if (!follows) {
        memory.nearest = nearest;
        memory.farthest = farthest;
        return;
    }
    const double change = std::max({moved, changeBetween(view.fingerprint, before.fingerprint),
                                    relativeChange(view.vsReceiverNear, before.vsReceiverNear)});
    const double step = std::min(SteadyStep + SteadyGrowth * change, GreatestStep);
    memory.nearest *= std::exp(std::clamp(nearStep, -step, step));
    memory.farthest *= std::exp(std::clamp(farStep, -step, step));
    // One that is far from what is seen may come by the other.
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
    sampleView(problem, image, region.liHull, state.scratch.receiversInView,
               {.most = AllSamples, .enough = AllSamples}, state.sampling, state.samples);
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
    settle(nearest, farthest, viewOf(problem, image, region), memory);
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

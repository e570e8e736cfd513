#include "fit/CascadeSplits.h"

#include "fit/Fit.h"
#include "fit/ShadowParts.h"

#include <algorithm>
#include <cmath>

namespace Lixel {
namespace {

/// Most that a settled depth changes in one frame, as the logarithm of a ratio, and from which
/// change on it is not settled at all.
constexpr double GreatestStep = 0.01;
constexpr double CutStep = 0.693; // ln 2

/// Least ratio of nearest and farthest: an eye that touches a receiver wants no slice for it.
constexpr double LeastNearRatio = 1e-4;

constexpr std::size_t Samples = 256;

/// Both ends move together: one that jumps may come by the other.
void settle(double nearest, double farthest, CascadeMemory& memory) {
    const double nearStep = std::log(nearest / memory.nearest);
    const double farStep = std::log(farthest / memory.farthest);
    // Negated, so that it holds where there was nothing before.
    if (!(std::abs(nearStep) <= CutStep) || !(std::abs(farStep) <= CutStep)) {
        memory.nearest = nearest;
        memory.farthest = farthest;
        return;
    }
    memory.nearest *= std::exp(std::clamp(nearStep, -GreatestStep, GreatestStep));
    memory.farthest *= std::exp(std::clamp(farStep, -GreatestStep, GreatestStep));
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
    settle(nearest, farthest, memory);
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

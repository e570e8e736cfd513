#include "fit/parts/CascadeSplits.h"

#include "fit/core/Validity.h"
#include "fit/focus/ViewVolume.h"
#include "fit/parts/CascadeMemory.h"
#include "fit/parts/LightPartition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace Lixel {
namespace {

/// The most that a settled depth changes in one frame, as the logarithm of a ratio: SteadyStep if
/// nothing moves noticeably, plus SteadyGrowth for each unit of change. Measured: when a slice's
/// edge moves, its texels change by four times as much, or a dozen times where shadows end near
/// the edge. Together with changes by the slice's own search, that stays below the 0.02 allowed to
/// a fit when something turns by 1e-4 rad.
constexpr double SteadyStep = 0.0005;
constexpr double SteadyGrowth = 4.0;

/// Most that it changes in any frame while it follows: a factor of two takes a quarter of a second.
constexpr double GreatestStep = 0.05;

/// What is farther from it than this, as by a camera cut, is not followed but taken at once.
constexpr double CutStep = 0.693; // ln 2

/// Least ratio of nearest and farthest: an eye that touches a receiver wants no slice for it.
constexpr double LeastNearRatio = 1e-4;

/// Least ratio of farthest and nearest: where all that is seen is at one depth, a wall that the
/// viewer faces or the ground from straight above, no slices meet there. Rounding would decide for
/// each of its points which map serves it. A receiver finds its map by depths in float, with an
/// error of 2^-20 or so.
constexpr double LeastDepthRatio = 1.0 + 0x1p-10;

/// Relative rounding of a near plane's depth that comes from a projection matrix in float.
constexpr double NearRounding = 0x1p-16;

/// All samples that view rays can give: the least and greatest depth of only a few mean little.
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
        memory.change = std::numeric_limits<double>::infinity();
        memory.nearest = nearest;
        memory.farthest = farthest;
        return;
    }
    memory.change = std::max({moved, changeBetween(view.fingerprint, before.fingerprint),
                              relativeChange(view.vsReceiverNear, before.vsReceiverNear)});
    const double step = std::min(SteadyStep + SteadyGrowth * memory.change, GreatestStep);
    // What has been reached is taken exactly, so that slices of a still view stand still.
    const auto follow = [&](double& depth, double now, double ahead) {
        depth = std::abs(ahead) <= step ? now : depth * std::exp(std::clamp(ahead, -step, step));
    };
    follow(memory.nearest, nearest, nearStep);
    follow(memory.farthest, farthest, farStep);
    // A depth that is still far from what is seen may overtake the other.
    memory.nearest = std::min(memory.nearest, memory.farthest);
}

/// Depths of what is seen of all slices together; false where nothing is.
bool findDepths(const ShadowProblem& problem, CascadeMemory& memory, CascadeScratch& scratch) {
    if (!isValid(problem) || needsParts(problem.light)) return false;
    FocusRegion& region = scratch.region;
    const LightImage image(problem.light);
    findFocusRegion(problem, image, scratch.focusing, region);
    if (!hasMap(region.reason)) return false;
    sampleView(problem, image, region.liHull, region.receiversInView,
               {.most = AllSamples, .enough = AllSamples}, scratch.sampling, scratch.samples);
    double nearest = region.vsReceiverNear;
    double farthest = region.vsReceiverFar;
    if (!scratch.samples.empty()) {
        nearest = farthest;
        farthest = 0.0;
        for (const ViewSample& sample : scratch.samples) {
            nearest = std::min(nearest, sample.vsDepth);
            farthest = std::max(farthest, sample.vsDepth);
        }
    }
    nearest = std::max(nearest, LeastNearRatio * farthest);
    if (!(nearest > 0.0) || !std::isfinite(farthest)) return false;
    farthest = std::max(farthest, LeastDepthRatio * nearest);
    settle(nearest, farthest, viewOf(problem, image, region), memory);
    return true;
}

/// Depths of the viewer's own clip planes and shadow distance; false for a view without end.
bool planDepths(const ShadowProblem& problem, CascadeMemory& memory) {
    ShadowViewer viewer = problem.viewer;
    viewer.viewFromWorld = Mat4::Identity();
    Aabb box;
    if (!viewer.clipFromView.allFinite() || !viewBounds(viewer, box)) return false;
    memory.farthest = -(box.centre.z() - box.halfExtents.z());
    memory.nearest =
        std::max(-(box.centre.z() + box.halfExtents.z()), LeastNearRatio * memory.farthest);
    return memory.nearest > 0.0;
}

/// The given depths where there are maps for all. Of more, the first ones for which no slice ends
/// before the viewer sees anything.
void givenDepths(const ShadowViewer& viewer, std::size_t most, const std::vector<double>& depths,
                 std::vector<double>& vsSplits) {
    if (depths.size() <= most) {
        vsSplits = depths;
        return;
    }
    const double vsNear = vsNearOf(viewer) * (1.0 + NearRounding);
    const auto first = std::upper_bound(depths.begin(), depths.end(), vsNear);
    vsSplits.assign(first, depths.end());
    if (vsSplits.size() > most) vsSplits.resize(most);
}

constexpr std::array Declared{
    option<&CascadeOptions::uniformity>(
        "uniformity", between(0.0, 1.0), "",
        "0: the depths of all slices have one ratio; 1: all are equally deep"),
    option<&CascadeOptions::followReceivers>(
        "follow_receivers",
        "whether slices divide what is seen and can be shadowed, following it little by little, or "
        "what is between the near plane and the end of shadows; off for stable maps"),
    option<&CascadeOptions::stripLight>(
        "strip_light",
        "whether the light's image may be divided instead of the view, where that is expected to "
        "make texels smaller, as seen from above; off for materials of others that find slices by "
        "depth"),
    option<&CascadeOptions::vsSplitDepths>(
        "split_depths", above(0.0), "world units",
        "where slices meet, instead of all this; of more than there are maps for, those up to the "
        "near plane do not count"),
    option<&CascadeOptions::splitPadding>(
        "split_padding", atLeast(0.0), "world units",
        "how much farther each slice's map reaches than to where slices meet, for receivers of "
        "others, which may find slices by another depth"),
};

} // namespace

std::span<const Option> CascadeOptions::declared() {
    return Declared;
}

double vsNearOf(const ShadowViewer& viewer) {
    const Eigen::RowVector4d plane = viewer.clipFromView.row(2) + viewer.clipFromView.row(3);
    const double depth = plane[3] / plane[2];
    return std::isfinite(depth) ? std::max(depth, 0.0) : 0.0;
}

void cascadeSplits(const ShadowProblem& problem, std::size_t count, const CascadeOptions& options,
                   CascadeMemory& memory, CascadeScratch& scratch, std::vector<double>& vsSplits) {
    vsSplits.clear();
    if (count < 2) return;
    if (!options.vsSplitDepths.empty())
        return givenDepths(problem.viewer, count - 1, options.vsSplitDepths, vsSplits);
    const bool isFound = options.followReceivers ? findDepths(problem, memory, scratch)
                                                 : planDepths(problem, memory);
    if (!isFound) return;
    const double ratio = memory.farthest / memory.nearest;
    const double uniformity = std::clamp(options.uniformity, 0.0, 1.0);
    for (std::size_t i = 1; i < count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count);
        const double logarithmic = memory.nearest * std::pow(ratio, part);
        const double uniform = memory.nearest + (memory.farthest - memory.nearest) * part;
        vsSplits.push_back(logarithmic + uniformity * (uniform - logarithmic));
    }
}

} // namespace Lixel

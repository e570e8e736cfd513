#include "fit/rule/WarpSearch.h"

#include "fit/core/Warp.h"
#include "fit/geometry/Smoothstep.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Lixel {
namespace {

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Gain over a uniform map, relative, from which on the search is believed in full. Boxes are a
/// coarse model of what is seen: less than a tenth is within its error.
constexpr double ClearGain = 0.1;

/// Greatest change of a denominator's logarithm in a frame: SteadyStep where nothing moves
/// noticeably, and SteadyGrowth more per unit of change, as much as a spread of length
/// GreatestSpread moves when it turns with the view. A texel's extent depends on four such
/// factors, two of its own denominator and two in the map's sides: 4 (0.003 + 8 x 1e-4) leaves a
/// quarter of the 0.02 that a fit may change when something turns by 1e-4 rad to the focus region.
constexpr double SteadyStep = 0.003;
constexpr double SteadyGrowth = WarpSearch::GreatestSpread;

/// Vertices of the focus region that the search keeps; the fit itself uses all.
constexpr std::size_t SearchVertices = 12;

/// Greatest change of a denominator's logarithm on the hull, from one warp to another.
double greatestLogChange(const Polygon2& hull, const Vec2& centre, const Vec2& a, const Vec2& b) {
    double greatest = 0.0;
    for (const Vec2& vertex : hull) {
        const Vec2 q = vertex - centre;
        greatest = std::max(greatest, std::abs(std::log((1.0 + a.dot(q)) / (1.0 + b.dot(q)))));
    }
    return greatest;
}

} // namespace

Vec2 warpOfSpread(const Polygon2& hull, const Vec2& centre, const Vec2& spread) {
    const double length = spread.norm();
    if (!(length > 0.0)) return Vec2::Zero();
    const Vec2 direction = spread / length;
    const WarpExtent extent = warpExtent(hull, centre, direction, 0.0);
    // With denominators 1 - t A to 1 + t B for the warp t d, their ratio is e^s at
    // t = (1 - e^-s) / (A + e^-s B).
    const double ratio = std::exp(-length);
    const double reach = extent.least + ratio * extent.greatest;
    return reach > 0.0 ? Vec2((1.0 - ratio) / reach * direction) : Vec2(0.0, 0.0);
}

Vec2 spreadOfWarp(const Polygon2& hull, const Vec2& centre, const Vec2& warp) {
    const double length = warp.norm();
    if (!(length > 0.0)) return Vec2::Zero();
    const WarpExtent extent = warpExtent(hull, centre, warp, 0.0);
    return std::log((1.0 + extent.greatest) / (1.0 - extent.least)) / length * warp;
}

WarpSearch::WarpSearch(const WarpContext& context, const Sampling& sampling, RuleState state)
    : mContext(context),
      mMemory(state.memory.search),
      mHull(state.scratch.simpleHull),
      mExtent(state.scratch.extent) {
    mNow.fingerprint = fingerprintOf(context.problem, context.image, context.region);
    std::vector<ViewSample>& seen = state.scratch.samples;
    const FocusRegion& region = context.region;
    mHull = region.liHull;
    simplifyOutward(mHull, SearchVertices);
    sampleView(context.problem, context.image, mHull, region.receiversInView,
               {.most = sampling.most, .enough = (sampling.most + 1) / 2}, state.scratch.sampling,
               seen);
    // A camera cut makes it another region, which the last choice has nothing to do with.
    if (mMemory) mChange = changeBetween(mNow.fingerprint, mMemory->fingerprint);
    if (!(mChange < CameraCutChange)) mMemory.reset();
    mNow.step = mMemory ? mMemory->step : FirstStep;
    mNow.turn = mMemory ? mMemory->turn : 0;
    if (seen.empty()) return;
    if (sampling.edgeWeight > 0.0)
        weighByEdges(context.problem, context.image, region, mHull, sampling.edgeWeight,
                     state.scratch.edges, seen);
    mExtent.reset(seen, mHull, region.liCentre);
    const double uniform = mExtent(Vec2::Zero());
    if (std::isfinite(uniform)) mUniform = uniform;
}

double WarpSearch::operator()(const Vec2& spread) {
    if (!(spread.norm() <= GreatestSpread)) return Infinity;
    const double value = mExtent(warp(spread)) / mUniform;
    return std::isnan(value) ? Infinity : value;
}

WarpSearch::Judged WarpSearch::along(const Vec2& direction, double greatest, int evaluations) {
    constexpr double Golden = 0.6180339887498949;
    double lower = 0.0;
    double upper = std::min(greatest, GreatestSpread);
    Judged best; // a uniform map
    const auto cost = [&](double s) {
        const Judged judged = judge(s * direction);
        if (judged.cost < best.cost) best = judged;
        return judged.cost;
    };
    cost(upper);
    double a = upper - Golden * (upper - lower);
    double b = lower + Golden * (upper - lower);
    double costA = cost(a);
    double costB = cost(b);
    for (int i = 3; i < evaluations; ++i) {
        if (costA < costB) {
            upper = b;
            b = a;
            costB = costA;
            a = upper - Golden * (upper - lower);
            costA = cost(a);
        } else {
            lower = a;
            a = b;
            costA = costB;
            b = lower + Golden * (upper - lower);
            costB = cost(b);
        }
    }
    return best;
}

WarpSearch::Judged WarpSearch::around(const Judged& start, int evaluations) {
    Judged best = start;
    double step = FirstStep;
    // A simplex that has shrunk to nothing may have stalled on a crease of the measure, where the
    // map's orientation changes: another one, the other way around, goes on from there.
    while (evaluations >= LeastSimplex && std::abs(step) > LeastStep) {
        best = simplexFrom(best, step, evaluations);
        step *= -0.7;
    }
    return best;
}

WarpSearch::Judged WarpSearch::simplexFrom(const Judged& start, double step, int& evaluations) {
    const auto vertex = [&](const Vec2& at) {
        --evaluations;
        return judge(at);
    };
    // One side along the start's direction, one across.
    const Vec2 along = start.spread.norm() > 0.0 ? Vec2(start.spread.normalized()) : Vec2(1.0, 0.0);
    const Vec2 across(-along.y(), along.x());
    std::array<Judged, 3> simplex{start, vertex(start.spread - std::abs(step) * along),
                                  vertex(start.spread + step * across)};
    const auto sort = [&] {
        std::sort(simplex.begin(), simplex.end(),
                  [](const Judged& a, const Judged& b) { return a.cost < b.cost; });
    };
    sort();
    while (evaluations > 0 && (simplex[2].spread - simplex[0].spread).norm() > LeastStep) {
        Judged& worst = simplex[2];
        const Vec2 middle = (simplex[0].spread + simplex[1].spread) / 2.0;
        const Judged reflected = vertex(2.0 * middle - worst.spread);
        if (reflected.cost < simplex[0].cost && evaluations > 0) {
            const Judged expanded = vertex(3.0 * middle - 2.0 * worst.spread);
            worst = expanded.cost < reflected.cost ? expanded : reflected;
        } else if (reflected.cost < simplex[1].cost || evaluations == 0) {
            if (reflected.cost < worst.cost) worst = reflected;
        } else {
            const Vec2& outer = reflected.cost < worst.cost ? reflected.spread : worst.spread;
            const Judged contracted = vertex((middle + outer) / 2.0);
            if (contracted.cost < std::min(worst.cost, reflected.cost)) {
                worst = contracted;
            } else if (evaluations >= 2) {
                for (std::size_t i = 1; i < 3; ++i)
                    simplex[i] = vertex((simplex[0].spread + simplex[i].spread) / 2.0);
            }
        }
        sort();
    }
    return simplex[0];
}

Vec2 WarpSearch::settle(const Judged& best) {
    Vec2 chosen = Vec2::Zero();
    if (usable()) {
        const double part = smoothstep((1.0 - best.cost) / ClearGain);
        chosen = part * best.spread;
        // Part of the way need not be better than none of it where the measure has a crease.
        if (part < 1.0 && !((*this)(chosen) <= 1.0)) chosen = Vec2::Zero();
        // To the last bit what it was, however long it rests.
        mNow.wsTarget = mRests ? mMemory->wsTarget : wsFromSpread(best.spread);
        mNow.cost = mRests ? mMemory->cost : best.cost;
    }
    // The samples that the search judges by come and go one by one, and two warps can be equally
    // good.
    if (const auto before = last()) {
        const double step = SteadyStep + SteadyGrowth * mChange;
        const double distance =
            greatestLogChange(mHull, mContext.region.liCentre, warp(chosen), warp(*before));
        if (distance > step) chosen = *before + step / distance * (chosen - *before);
    }
    mNow.wsSpread = wsFromSpread(chosen);
    mMemory = mNow;
    return chosen;
}

std::optional<MapAxes> WarpSearch::axes(const Vec2& warp, const std::optional<WorldAxes>& wsLast) {
    if (!usable()) return std::nullopt;
    std::optional<MapAxes> last;
    if (wsLast) last = axesFromWorld(*wsLast, mContext.image);
    return mExtent.chooseAxes(warp, last);
}

std::optional<Vec2> WarpSearch::last() const {
    if (!mMemory) return std::nullopt;
    return mContext.image.lsFromDirection(mMemory->wsSpread).head<2>();
}

std::optional<Vec2> WarpSearch::target() const {
    if (!mMemory || !mMemory->wsTarget) return std::nullopt;
    return mContext.image.lsFromDirection(*mMemory->wsTarget).head<2>();
}

Vec3 WarpSearch::wsFromSpread(const Vec2& spread) const {
    return mContext.image.lsFromWs().transpose() * Vec3(spread.x(), spread.y(), 0.0);
}

Vec2 WarpSearch::warp(const Vec2& spread) const {
    return warpOfSpread(mHull, mContext.region.liCentre, spread);
}

Vec2 WarpSearch::spread(const Vec2& warp) const {
    return spreadOfWarp(mHull, mContext.region.liCentre, warp);
}

} // namespace Lixel

#include "fit/WarpSearch.h"

#include "fit/Smoothstep.h"
#include "fit/Warp.h"

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

/// How much the logarithm of a denominator may change in a frame in which nothing moves noticeably,
/// and how much more for each unit of change: as much as a spread of GreatestSpread moves when it
/// turns with the view. A texel's extent goes with the square of its denominator and with the map's
/// sides, which go with two more: 4 (0.004 + 8 x 1e-4) is below the 0.02 that a fit may change when
/// something turns by 1e-4.
constexpr double SteadyStep = 0.004;
constexpr double SteadyGrowth = WarpSearch::GreatestSpread;

/// Change from which on the region is another one, as after a camera cut.
constexpr double AnotherRegion = 0.05;

/// Vertices of the focus region that the search keeps; the fit itself uses all.
constexpr std::size_t SearchVertices = 12;

/// Side of the first simplex, as a change of spread: a third more or less at one end.
constexpr double FirstStep = 0.3;

/// A simplex smaller than this is done: it tells warps apart whose texels differ by a hundredth.
constexpr double LeastStep = 0.02;

/// Evaluations that make a simplex and move it once.
constexpr int LeastSimplex = 5;

/// What tells whether viewer, light and region are the same as before, however light space is
/// turned.
SearchMemory describe(const WarpContext& context) {
    const FocusRegion& region = context.region;
    double perimeter = 0.0;
    for (std::size_t i = 0; i < region.liHull.size(); ++i)
        perimeter += (region.liHull[(i + 1) % region.liHull.size()] - region.liHull[i]).norm();
    const Vec3& viewer = context.viewer;
    const double distance =
        viewer.z() > 0.0 ? (region.liCentre - viewer.head<2>() / viewer.z()).norm() : 0.0;
    return {.wsSpread = Vec3::Zero(),
            .measures = Vec3(distance, perimeter, region.vsReceiverFar),
            .wsView = -context.problem.viewer.viewFromWorld.row(2).head<3>().stableNormalized(),
            .wsLight = context.image.lsFromWs().row(2)};
}

/// How much has changed: relative for lengths, radians for directions.
double changeBetween(const SearchMemory& a, const SearchMemory& b) {
    const double lengths =
        ((a.measures - b.measures).cwiseAbs().array() /
         (a.measures + b.measures).cwiseAbs().array().max(std::numeric_limits<double>::min()))
            .maxCoeff();
    return std::max({lengths, (a.wsView - b.wsView).norm(), (a.wsLight - b.wsLight).norm()});
}

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

WarpSearch::WarpSearch(const WarpContext& context, std::size_t samples)
    : mContext(context),
      mHull(context.state.simpleHull),
      mExtent(context.state.extent),
      mNow(describe(context)) {
    FitState& state = context.state;
    const FocusRegion& region = context.region;
    sampleView(context.problem, context.image, region, state.scratch.receiversInView, samples,
               state.viewRays, state.samples);
    // A camera cut makes it another region, which the last choice has nothing to do with.
    if (state.search) mChange = changeBetween(mNow, *state.search);
    if (!(mChange < AnotherRegion)) state.search.reset();
    mHull = region.liHull;
    simplifyOutward(mHull, SearchVertices);
    if (state.samples.empty()) return;
    mExtent.reset(state.samples, mHull, region.liCentre);
    const double uniform = mExtent(Vec2::Zero());
    if (std::isfinite(uniform)) mUniform = uniform;
}

double WarpSearch::operator()(const Vec2& spread) {
    if (!(spread.norm() <= GreatestSpread)) return Infinity;
    const double value = mExtent(warp(spread)) / mUniform;
    return std::isnan(value) ? Infinity : value;
}

Vec2 WarpSearch::along(const Vec2& direction, double greatest, int evaluations) {
    constexpr double Golden = 0.6180339887498949;
    double lower = 0.0;
    double upper = std::min(greatest, GreatestSpread);
    Vec2 best = Vec2::Zero();
    double bestCost = 1.0; // a uniform map's
    const auto cost = [&](double s) {
        const double value = (*this)(s * direction);
        if (value < bestCost) {
            bestCost = value;
            best = s * direction;
        }
        return value;
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

Vec2 WarpSearch::around(const Vec2& start, int evaluations) {
    Vec2 best = start;
    double step = FirstStep;
    // A simplex that has shrunk to nothing may have stalled on a crease of the measure, where the
    // map's orientation changes: another one, the other way around, goes on from there.
    while (evaluations >= LeastSimplex && std::abs(step) > LeastStep) {
        best = simplexFrom(best, step, evaluations);
        step *= -0.7;
    }
    return best;
}

Vec2 WarpSearch::simplexFrom(const Vec2& start, double step, int& evaluations) {
    struct Vertex {
        Vec2 at;
        double cost;
    };
    const auto vertex = [&](const Vec2& at) {
        --evaluations;
        return Vertex{at, (*this)(at)};
    };
    // One side along the start's direction, one across.
    const Vec2 along = start.norm() > 0.0 ? Vec2(start.normalized()) : Vec2(1.0, 0.0);
    const Vec2 across(-along.y(), along.x());
    std::array<Vertex, 3> simplex{vertex(start), vertex(start - std::abs(step) * along),
                                  vertex(start + step * across)};
    const auto sort = [&] {
        std::sort(simplex.begin(), simplex.end(),
                  [](const Vertex& a, const Vertex& b) { return a.cost < b.cost; });
    };
    sort();
    while (evaluations > 0 && (simplex[2].at - simplex[0].at).norm() > LeastStep) {
        Vertex& worst = simplex[2];
        const Vec2 middle = (simplex[0].at + simplex[1].at) / 2.0;
        const Vertex reflected = vertex(2.0 * middle - worst.at);
        if (reflected.cost < simplex[0].cost && evaluations > 0) {
            const Vertex expanded = vertex(3.0 * middle - 2.0 * worst.at);
            worst = expanded.cost < reflected.cost ? expanded : reflected;
        } else if (reflected.cost < simplex[1].cost || evaluations == 0) {
            if (reflected.cost < worst.cost) worst = reflected;
        } else {
            const Vec2& outer = reflected.cost < worst.cost ? reflected.at : worst.at;
            const Vertex contracted = vertex((middle + outer) / 2.0);
            if (contracted.cost < std::min(worst.cost, reflected.cost)) {
                worst = contracted;
            } else if (evaluations >= 2) {
                for (std::size_t i = 1; i < 3; ++i)
                    simplex[i] = vertex((simplex[0].at + simplex[i].at) / 2.0);
            }
        }
        sort();
    }
    return simplex[0].at;
}

Vec2 WarpSearch::settle(const Vec2& best) {
    Vec2 chosen = Vec2::Zero();
    if (usable()) {
        const double gain = 1.0 - (*this)(best);
        chosen = smoothstep(gain / ClearGain) * best;
        // Part of the way need not be better than none of it where the measure has a crease.
        if (!((*this)(chosen) <= 1.0)) chosen = Vec2::Zero();
    }
    // The samples that the search judges by come and go one by one, and two warps can be equally
    // good.
    if (const auto before = last()) {
        const double step = SteadyStep + SteadyGrowth * mChange;
        const double distance =
            greatestLogChange(mHull, mContext.region.liCentre, warp(chosen), warp(*before));
        if (distance > step) chosen = *before + step / distance * (chosen - *before);
    }
    mNow.wsSpread = mContext.image.lsFromWs().transpose() * Vec3(chosen.x(), chosen.y(), 0.0);
    mContext.state.search = mNow;
    return chosen;
}

std::optional<Vec2> WarpSearch::last() const {
    const std::optional<SearchMemory>& memory = mContext.state.search;
    if (!memory) return std::nullopt;
    return mContext.image.lsFromDirection(memory->wsSpread).head<2>();
}

Vec2 WarpSearch::warp(const Vec2& spread) const {
    return warpOfSpread(mHull, mContext.region.liCentre, spread);
}

Vec2 WarpSearch::spread(const Vec2& warp) const {
    return spreadOfWarp(mHull, mContext.region.liCentre, warp);
}

} // namespace Lixel

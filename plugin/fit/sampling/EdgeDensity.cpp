#include "fit/sampling/EdgeDensity.h"

#include <algorithm>
#include <cmath>

namespace Lixel {
namespace {

/// An edge is added at points as far apart as cells are wide: within the grid there are no more than
/// its diagonal has.
constexpr double MostPoints = 24.0;

/// Outlines that go around the focus region so often are believed by half. Among 0, 2 and 8, with 2
/// maps erred least over the samples.
constexpr double HalfBelieved = 2.0;

double signOf(double x) {
    return x < 0.0 ? -1.0 : 1.0;
}

/// Half axes of a box in the light image, and how far along the light each goes.
struct HalfAxes {
    std::array<Vec2, 3> li;
    std::array<double, 3> ls;

    /// @param middle the box's, in light space, and `liMiddle` in the light image
    HalfAxes(const LightImage& image, const Vec3& halfExtents, const Vec3& middle,
             const Vec2& liMiddle) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            const Vec3 half = halfExtents[axis] * image.lsFromWs().col(axis);
            // d(xy / -z) = (dxy + q dz) / -z
            li[k] = image.directional()
                        ? Vec2(half.head<2>())
                        : Vec2((half.head<2>() + liMiddle * half.z()) / -middle.z());
            ls[k] = -half.z();
        }
    }
};

} // namespace

void EdgeDensity::reset(const LightImage& image, const Polygon2& liHull, const Vec2& lsRange) {
    mImage = image;
    mLength.assign(PlaneSize * Planes, 0.0);
    Eigen::AlignedBox2d bounds;
    for (const Vec2& q : liHull)
        bounds.extend(q);
    mLiLeast = bounds.min();
    mLiSize = bounds.sizes();
    mScale = static_cast<double>(Cells) * mLiSize.cwiseInverse();
    mLsNear = lsRange.x();
    mLsScale = static_cast<double>(Planes - 1) / (lsRange.y() - lsRange.x());
    // A region without area has no cells, and receivers across the light have one depth.
    if (!mScale.allFinite()) mScale.setZero();
    if (!std::isfinite(mLsScale)) mLsScale = 0.0;
}

void EdgeDensity::add(const BoxSet& casters, double nearDistance) {
    for (const Aabb& box : casters.boxes()) {
        const Vec3 ls = mImage.lsFromPoint(box.centre);
        if (!mImage.directional() && !(-ls.z() > nearDistance)) continue;
        const Vec2 middle = mImage.project(ls);
        const HalfAxes half(mImage, box.halfExtents, ls, middle);
        // The outermost edges along each axis lie where both other axes point to one side of it.
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t a = (k + 1) % 3;
            const std::size_t b = (k + 2) % 3;
            const double toA = signOf(cross(half.li[k], half.li[a]));
            const double toB = signOf(cross(half.li[k], half.li[b]));
            const Vec2 out = toA * half.li[a] + toB * half.li[b];
            const double outDepth = toA * half.ls[a] + toB * half.ls[b];
            addEdge(middle + out, half.li[k], -ls.z() + outDepth);
            addEdge(middle - out, half.li[k], -ls.z() - outDepth);
        }
    }
}

bool EdgeDensity::cutToGrid(Vec2& middle, Vec2& half) const {
    // middle + t half, for t from -1 to 1 (Liang and Barsky 1984).
    constexpr auto End = static_cast<double>(Cells);
    double from = -1.0;
    double to = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
        if (half[axis] == 0.0) continue; // addAt leaves out what is beside the grid
        const double first = (mLiLeast[axis] - middle[axis]) / half[axis];
        const double last = (mLiLeast[axis] + End / mScale[axis] - middle[axis]) / half[axis];
        from = std::max(from, std::min(first, last));
        to = std::min(to, std::max(first, last));
    }
    if (!(from < to)) return false;
    middle += (from + to) / 2.0 * half;
    half *= (to - from) / 2.0;
    return true;
}

void EdgeDensity::addEdge(Vec2 middle, Vec2 half, double lsDepth) {
    const auto cellsOf = [&] { return 2.0 * half.cwiseProduct(mScale).norm(); };
    double cells = cellsOf();
    // Of shorter edges addAt leaves out what is beside the grid, a cell's length at a time.
    if (cells > static_cast<double>(Cells)) {
        if (!cutToGrid(middle, half)) return;
        cells = cellsOf();
    }
    const double length = 2.0 * half.norm();
    const double count = std::clamp(std::ceil(cells), 1.0, MostPoints);
    for (double i = 0.0; i < count; i += 1.0)
        addAt(middle + ((2.0 * i + 1.0) / count - 1.0) * half, lsDepth, length / count);
}

EdgeDensity::Place EdgeDensity::place(const Vec2& inCells, double lsDepth) const {
    const double plane =
        std::clamp((lsDepth - mLsNear) * mLsScale, 0.0, static_cast<double>(Planes - 1));
    const auto x = static_cast<std::size_t>(inCells.x());
    const auto y = static_cast<std::size_t>(inCells.y());
    const auto z = std::min(static_cast<std::size_t>(plane), Planes - 2);
    return {z * PlaneSize + y * Side + x,
            Vec3(inCells.x() - static_cast<double>(x), inCells.y() - static_cast<double>(y),
                 plane - static_cast<double>(z))};
}

void EdgeDensity::addAt(const Vec2& li, double lsDepth, double length) {
    const Vec2 inCells = (li - mLiLeast).cwiseProduct(mScale);
    constexpr auto End = static_cast<double>(Cells);
    // Nothing that is not a number is.
    const bool isInside = inCells.x() >= 0.0 && inCells.x() <= End && inCells.y() >= 0.0 &&
                          inCells.y() <= End && std::isfinite(lsDepth) && std::isfinite(length);
    if (!isInside) return;
    const auto [node, part] = place(inCells, lsDepth);
    const double before = (1.0 - part.z()) * length;
    const double behind = part.z() * length;
    const std::array<std::size_t, 4> nodes = {node, node + 1, node + Side, node + Side + 1};
    const std::array<double, 4> shares = {(1.0 - part.x()) * (1.0 - part.y()),
                                          part.x() * (1.0 - part.y()), (1.0 - part.x()) * part.y(),
                                          part.x() * part.y()};
    for (std::size_t i = 0; i < 4; ++i) {
        mLength[nodes[i]] += before * shares[i];
        mLength[nodes[i] + PlaneSize] += behind * shares[i];
    }
}

void EdgeDensity::finish() {
    for (std::size_t i = PlaneSize; i < mLength.size(); ++i)
        mLength[i] += mLength[i - PlaneSize];
}

double EdgeDensity::at(const Vec2& li, double lsDepth) const {
    constexpr auto End = static_cast<double>(Cells);
    const Vec2 inCells = (li - mLiLeast).cwiseProduct(mScale).cwiseMax(0.0).cwiseMin(End);
    const auto [node, part] = place(inCells, lsDepth);
    const auto inPlane = [&, part = part](std::size_t first) {
        const double* const length = &mLength[first];
        return (1.0 - part.y()) * ((1.0 - part.x()) * length[0] + part.x() * length[1]) +
               part.y() * ((1.0 - part.x()) * length[Side] + part.x() * length[Side + 1]);
    };
    const double length = (1.0 - part.z()) * inPlane(node) + part.z() * inPlane(node + PlaneSize);
    return length * mScale.x() * mScale.y();
}

double EdgeDensity::turnsOf(double density) const {
    const double perimeter = 2.0 * mLiSize.sum();
    return perimeter > 0.0 ? density * mLiSize.prod() / perimeter : 0.0;
}

void weighByEdges(const ShadowProblem& problem, const LightImage& image, const FocusRegion& region,
                  const Polygon2& liHull, double share, EdgeDensity& edges,
                  std::vector<ViewSample>& samples) {
    edges.reset(image, liHull, Vec2(region.lsCasterNear, region.lsReceiverFar));
    edges.add(region.coveringCasters, problem.light.nearDistance);
    edges.finish();
    double sum = 0.0;
    for (ViewSample& sample : samples) {
        sample.weight = edges.at(sample.liPoint, sample.lsDepth);
        sum += sample.weight;
    }
    const double mean = sum / static_cast<double>(samples.size());
    const double turns = edges.turnsOf(mean);
    const double believed = share * turns / (turns + HalfBelieved);
    const bool isKnown = std::isfinite(believed) && mean > 0.0;
    for (ViewSample& sample : samples)
        sample.weight = isKnown ? 1.0 - believed + believed * sample.weight / mean : 1.0;
}

} // namespace Lixel

#include "fit/geometry/Relief.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace Lixel {
namespace {

/// How much the triangles may be larger or smaller than their box, seen from above, relative: what
/// positions in float leave. A second sheet would be as large as the first.
constexpr double SameArea = 1e-3;

/// A triangle whose doubled area is less than this part of its longest side's square is a line, and
/// its normal is rounding.
constexpr double LeastArea = 1e-6;

/// A vector of two random numbers for each point: the same for the same point.
struct PointHash {
    explicit PointHash(const Vec3& point) {
        std::uint64_t bits = 0;
        constexpr std::array<std::uint64_t, 3> Factors{0x9E3779B97F4A7C15ULL, 0xD1B54A32D192ED03ULL,
                                                       0x8CB92BA72F3D8DD7ULL};
        for (std::size_t i = 0; i < 3; ++i) {
            const double coordinate = point[static_cast<Eigen::Index>(i)] + 0.0; // -0 is 0
            bits += std::bit_cast<std::uint64_t>(coordinate) * Factors[i];
        }
        // The finalizer of SplitMix64 (Steele et al. 2014).
        bits = (bits ^ bits >> 30) * 0xBF58476D1CE4E5B9ULL;
        bits = (bits ^ bits >> 27) * 0x94D049BB133111EBULL;
        first = bits ^ bits >> 31;
        second = std::rotl(first, 32);
    }

    std::uint64_t first;
    std::uint64_t second;
};

/// A number of an edge that is its opposite the other way around: the vectors' cross product.
std::uint64_t edgeNumber(const PointHash& from, const PointHash& to) {
    return from.first * to.second - from.second * to.first;
}

constexpr std::size_t Directions = ReliefCell::Directions;
static_assert(Directions == 8);
using Rises = Eigen::Array<float, Directions, 1>;

/// Of the angles of all directions.
constexpr auto Half = static_cast<float>(std::numbers::sqrt2 / 2.0);
constexpr std::array<float, Directions> Cosines{1.0F, Half, 0.0F, -Half, -1.0F, -Half, 0.0F, Half};
constexpr std::array<float, Directions> Sines{0.0F, Half, 1.0F, Half, 0.0F, -Half, -1.0F, -Half};

/// What slopes may rise along a vector across the axis, at most. What the steepest of some slopes
/// rises is no more along a sum of vectors than the sum of what it rises along each: these are
/// along the two directions that the vector is between.
double riseAlong(const Rises& rises, const Vec2& vector) {
    const Vec2 size = vector.cwiseAbs();
    const bool isLeft = vector.x() < 0.0;
    const bool isDown = vector.y() < 0.0;
    const Eigen::Index straight = size.x() > size.y() ? (isLeft ? 4 : 0) : (isDown ? 6 : 2);
    const Eigen::Index diagonal = isDown ? (isLeft ? 5 : 7) : (isLeft ? 3 : 1);
    return (size.maxCoeff() - size.minCoeff()) * static_cast<double>(rises[straight]) +
           std::numbers::sqrt2 * size.minCoeff() * static_cast<double>(rises[diagonal]);
}

/// The two coordinates across an axis.
Vec2 acrossOf(const Vec3& vector, std::size_t axis) {
    return {vector[static_cast<Eigen::Index>((axis + 1) % 3)],
            vector[static_cast<Eigen::Index>((axis + 2) % 3)]};
}

} // namespace

bool Relief::isLit(const ReliefCell& cell, const Vec4& light) const {
    Eigen::Index along = 0;
    axis.cwiseAbs().maxCoeff(&along);
    // Of the sine of the angle between light and slope, over the slope's cosine.
    const double slack = Slack / std::sqrt(std::max(1.0 - steepness * steepness, Slack * Slack));
    const auto isHigher = [&](const Vec3& direction) {
        const Vec2 across = acrossOf(direction, static_cast<std::size_t>(along));
        return direction.dot(axis) - riseAlong(cell.rise, across) > slack * direction.norm();
    };
    if (!light.allFinite()) return false;
    if (light.w() == 0.0) return isHigher(light.head<3>());
    // Directions for which that holds are a convex cone: with those from the corners it has all.
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3f from =
            cell.bounds.corner(static_cast<Eigen::AlignedBox3f::CornerType>(corner));
        if (!isHigher(light.head<3>() - from.cast<double>())) return false;
    }
    return true;
}

void ReliefBuilder::reset(const Eigen::AlignedBox3d& bounds) {
    mBounds = bounds;
    mAnyAlive = !bounds.isEmpty() && bounds.sizes().allFinite() && bounds.sizes().minCoeff() > 0.0;
    mCandidates.fill({.isAlive = mAnyAlive});
    mEdges = 0;
}

unsigned ReliefBuilder::sidesOf(const Vec3& point) const {
    unsigned sides = 0;
    for (int axis = 0; axis < 3; ++axis) {
        sides |= static_cast<unsigned>(point[axis] == mBounds.min()[axis]) << axis;
        sides |= static_cast<unsigned>(point[axis] == mBounds.max()[axis]) << (3 + axis);
    }
    return sides;
}

void ReliefBuilder::add(const Vec3& a, const Vec3& b, const Vec3& c) {
    if (!mAnyAlive) return;
    const std::array<unsigned, 3> sides{sidesOf(a), sidesOf(b), sidesOf(c)};
    const std::array hashes{PointHash(a), PointHash(b), PointHash(c)};
    const std::array edges{edgeNumber(hashes[0], hashes[1]), edgeNumber(hashes[1], hashes[2]),
                           edgeNumber(hashes[2], hashes[0])};
    mEdges += edges[0] + edges[1] + edges[2];
    const Vec3 normal = Vec3(b - a).cross(Vec3(c - a));
    const double squaredArea = normal.squaredNorm();
    const double longest =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    const bool isLine = !(squaredArea > LeastArea * LeastArea * longest * longest);

    // In a side, and turned outward.
    const unsigned shared = sides[0] & sides[1] & sides[2];
    unsigned outside = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (normal[axis] < 0.0) outside |= shared & 0b000001U << axis;
        if (normal[axis] > 0.0) outside |= shared & 0b001000U << axis;
    }

    mAnyAlive = false;
    for (std::size_t i = 0; i < mCandidates.size(); ++i) {
        Candidate& candidate = mCandidates[i];
        if (!candidate.isAlive) continue;
        const std::size_t axis = i % 3;
        const unsigned top = (i < 3 ? 0b001000U : 0b000001U) << axis;
        const unsigned bottom = (i < 3 ? 0b000001U : 0b001000U) << axis;
        for (std::size_t k = 0; k < 3; ++k)
            if ((sides[k] & sides[(k + 1) % 3] & ~(top | bottom)) == 0)
                candidate.edgesWithin += edges[k];
        if (!isLine && (outside & ~top) != 0) {
            candidate.hasWalls = true;
        } else if (!isLine) {
            const double up = (i < 3 ? 1.0 : -1.0) * normal[static_cast<Eigen::Index>(axis)];
            const double squaredCosine = up * up / squaredArea;
            candidate.squaredCosine = std::min(candidate.squaredCosine, squaredCosine);
            candidate.area += up / 2.0;
            candidate.isAlive = up > 0.0 && 1.0 - squaredCosine <= MostSteep * MostSteep;
            if (candidate.isAlive) addToCell(candidate, axis, {a, b, c}, normal / up);
        }
        mAnyAlive = mAnyAlive || candidate.isAlive;
    }
}

void ReliefBuilder::addToCell(Candidate& candidate, std::size_t axis,
                              const std::array<Vec3, 3>& corners, const Vec3& upNormal) {
    if (candidate.cells.empty())
        candidate.cells.assign(
            Side * Side,
            {Eigen::AlignedBox3f(), Rises::Constant(-std::numeric_limits<float>::infinity())});
    const Vec2 least = acrossOf(mBounds.min(), axis);
    const Vec2 size = acrossOf(mBounds.sizes(), axis);
    const Vec2 middle = acrossOf((corners[0] + corners[1] + corners[2]) / 3.0, axis);
    const auto indexOf = [&](int k) {
        const double at = (middle[k] - least[k]) / size[k] * static_cast<double>(Side);
        return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(Side - 1)));
    };
    ReliefCell& cell = candidate.cells[indexOf(1) * Side + indexOf(0)];
    for (const Vec3& corner : corners)
        cell.bounds.extend(corner.cast<float>());
    const Vec2 gradient = -acrossOf(upNormal, axis);
    cell.rise =
        cell.rise.max(static_cast<float>(gradient.x()) * Eigen::Map<const Rises>(Cosines.data()) +
                      static_cast<float>(gradient.y()) * Eigen::Map<const Rises>(Sines.data()));
}

std::optional<Relief> ReliefBuilder::relief() const {
    for (std::size_t i = 0; i < mCandidates.size(); ++i) {
        const Candidate& candidate = mCandidates[i];
        const auto axis = static_cast<Eigen::Index>(i % 3);
        const double box = mBounds.sizes()[(axis + 1) % 3] * mBounds.sizes()[(axis + 2) % 3];
        const bool isWhole = candidate.hasWalls ? mEdges == 0 : candidate.edgesWithin == 0;
        if (!candidate.isAlive || !isWhole || !(std::abs(candidate.area - box) <= SameArea * box))
            continue;
        Relief relief{(i < 3 ? 1.0 : -1.0) * Vec3::Unit(axis),
                      std::sqrt(std::max(1.0 - candidate.squaredCosine, 0.0)), candidate.cells};
        std::erase_if(relief.cells, [](const ReliefCell& cell) { return cell.bounds.isEmpty(); });
        return relief;
    }
    return std::nullopt;
}

} // namespace Lixel

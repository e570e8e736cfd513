#include "fit/geometry/Relief.h"

#include <algorithm>
#include <bit>
#include <cmath>

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

} // namespace

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
        }
        mAnyAlive = mAnyAlive || candidate.isAlive;
    }
}

std::optional<Relief> ReliefBuilder::relief() const {
    for (std::size_t i = 0; i < mCandidates.size(); ++i) {
        const Candidate& candidate = mCandidates[i];
        const auto axis = static_cast<Eigen::Index>(i % 3);
        const double box = mBounds.sizes()[(axis + 1) % 3] * mBounds.sizes()[(axis + 2) % 3];
        const bool isWhole = candidate.hasWalls ? mEdges == 0 : candidate.edgesWithin == 0;
        if (!candidate.isAlive || !isWhole || !(std::abs(candidate.area - box) <= SameArea * box))
            continue;
        return Relief{(i < 3 ? 1.0 : -1.0) * Vec3::Unit(axis),
                      std::sqrt(std::max(1.0 - candidate.squaredCosine, 0.0))};
    }
    return std::nullopt;
}

} // namespace Lixel

#include "fit/geometry/BodyHull.h"

#include "fit/geometry/Multiversion.h"
#include "fit/geometry/Simd.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Lixel {
namespace {

/// Vertices nearer to each other than this part of the body's size are the same, up to rounding:
/// cuts through one vertex leave several of them.
constexpr double SameVertex = 0x1p-42;

/// The finished hull is enlarged by this part of its size: rounding leaves no point outside.
constexpr double Outward = 0x1p-36;

/// Least that a face cuts off, relative to the body's size: less is not worth its vertices.
constexpr double LeastBevel = 1.0 / 64.0;

/// The axes of a 26-DOP in the order of an odometer over -1, 0, 1, the first half alone: the other
/// half are their opposites.
constexpr std::size_t AxisCount = 13;
const std::array<Vec3, AxisCount>& axes() {
    static const std::array<Vec3, AxisCount> all = [] {
        std::array<Vec3, AxisCount> result;
        for (std::size_t i = 0; i < AxisCount; ++i) {
            const int k = static_cast<int>(i);
            result.at(i) = Vec3(k / 9 - 1, k / 3 % 3 - 1, k % 3 - 1).normalized();
        }
        return result;
    }();
    return all;
}

/// Coordinates that float may have rounded differ by this part of them, at most.
constexpr double FloatRounding = 0x1p-22;

/// Points that are looked at together: few enough for the fastest memory.
constexpr std::size_t BlockSize = 256;

/// Coordinates side by side, for four points to be worked on at once.
struct Block {
    alignas(sizeof(Four)) std::array<std::array<double, BlockSize>, 3> coordinates;
};

/// Widens what is known of how far points reach along an axis.
LIXEL_MULTIVERSION void reach(const Block& block, std::size_t count, const Vec3& axis,
                              double& least, double& most) {
    const Four x = Four{} + axis.x();
    const Four y = Four{} + axis.y();
    const Four z = Four{} + axis.z();
    Four lower = Four{} + least;
    Four upper = Four{} + most;
    for (std::size_t i = 0; i < count; i += 4) {
        Four px;
        Four py;
        Four pz;
        load(block.coordinates[0].data() + i, px);
        load(block.coordinates[1].data() + i, py);
        load(block.coordinates[2].data() + i, pz);
        const Four along = x * px + (y * py + z * pz);
        lesser(along, lower, lower);
        greater(along, upper, upper);
    }
    for (const double value : parts(lower))
        least = std::min(least, value);
    for (const double value : parts(upper))
        most = std::max(most, value);
}

/// Sums up the tetrahedra between a body's middle, a face's middle and each of its edges.
double volumeOf(const BodyHull& hull) {
    Vec3 middle = Vec3::Zero();
    for (const Vec3& vertex : hull.vertices)
        middle += vertex / static_cast<double>(hull.vertices.size());
    double volume = 0.0;
    for (std::uint32_t face = 0; face < hull.faces; ++face) {
        Vec3 faceMiddle = Vec3::Zero();
        double ends = 0.0;
        const auto forEdges = [&](const auto& visit) {
            for (const ClipScratch::Edge& edge : hull.edges)
                if (edge.faces[0] == face || edge.faces[1] == face)
                    visit(hull.vertices[edge.vertices[0]], hull.vertices[edge.vertices[1]]);
        };
        forEdges([&](const Vec3& a, const Vec3& b) {
            faceMiddle += a + b;
            ends += 2.0;
        });
        if (ends == 0.0) continue;
        const Vec3 top = faceMiddle / ends - middle;
        forEdges([&](const Vec3& a, const Vec3& b) {
            volume += std::abs(top.dot((a - middle).cross(b - middle))) / 6.0;
        });
    }
    return volume;
}

} // namespace

BodyHullBuilder::BodyHullBuilder() {
    static_assert(Axes == AxisCount);
    mLeast.fill(std::numeric_limits<double>::infinity());
    mMost.fill(-std::numeric_limits<double>::infinity());
}

void BodyHullBuilder::add(std::span<const Vec3> positions) {
    Block block;
    while (!positions.empty() && mFinite) {
        const std::span<const Vec3> some = positions.first(std::min(positions.size(), BlockSize));
        positions = positions.subspan(some.size());
        std::size_t count = 0;
        const auto append = [&](const Vec3& position) {
            for (std::size_t k = 0; k < 3; ++k)
                block.coordinates[k][count] = position[static_cast<Eigen::Index>(k)];
            ++count;
        };
        for (const Vec3& position : some) {
            mFinite = mFinite && position.allFinite();
            append(position);
        }
        while (count % 4 != 0)
            append(some.back());
        for (std::size_t i = 0; i < Axes; ++i)
            reach(block, count, axes()[i], mLeast[i], mMost[i]);
    }
}

BodyHull BodyHullBuilder::build() const {
    BodyHull hull;
    if (!mFinite || mLeast[0] > mMost[0]) return hull;
    // The axes -x, -y and -z.
    const Vec3 upper(-mLeast[4], -mLeast[10], -mLeast[12]);
    const Vec3 lower(-mMost[4], -mMost[10], -mMost[12]);
    const Eigen::AlignedBox3d bounds(lower, upper);
    const Aabb box{bounds.center(), bounds.sizes() / 2.0};

    // The half spaces around the points whose normals run towards the box's edges and corners.
    ConvexVolume bevels;
    const auto bevel = [&](const Vec3& outward, double farthest) {
        if ((outward.array() != 0.0).count() < 2) return;
        const double corner = outward.dot(box.centre) + outward.cwiseAbs().dot(box.halfExtents);
        if (corner - farthest > LeastBevel * box.halfExtents.maxCoeff())
            bevels.add(-outward, farthest);
    };
    for (std::size_t i = 0; i < Axes; ++i)
        bevel(axes()[i], mMost[i]);
    for (std::size_t i = Axes; i-- > 0;)
        bevel(-axes()[i], -mLeast[i]);

    ClipScratch scratch;
    std::vector<Vec3> all;
    clipBox(box, bevels, scratch, all);

    // The edges that are left, and their vertices.
    const double same = SameVertex * (bounds.min().cwiseAbs() + bounds.max().cwiseAbs()).maxCoeff();
    const auto indexOf = [&](const Vec3& vertex) {
        std::size_t i = 0;
        while (i < hull.vertices.size() && !((hull.vertices[i] - vertex).norm() <= same))
            ++i;
        if (i == hull.vertices.size()) hull.vertices.push_back(vertex);
        return static_cast<std::uint32_t>(i);
    };
    for (const ClipScratch::Edge& edge : scratch.edges) {
        ClipScratch::Edge own = edge;
        for (std::uint32_t& vertex : own.vertices)
            vertex = indexOf(scratch.vertices[vertex]);
        // A body that is but a point keeps one, or it would be none.
        if (own.vertices[0] == own.vertices[1] && !hull.edges.empty()) continue;
        for (const std::uint32_t face : own.faces)
            hull.faces = std::max(hull.faces, face + 1);
        hull.edges.push_back(own);
    }
    for (Vec3& vertex : hull.vertices)
        vertex += Outward * (vertex - box.centre);
    hull.volume = volumeOf(hull);
    const Vec3 reach = upper.cwiseAbs().cwiseMax(lower.cwiseAbs());
    hull.hasCorners = true;
    for (std::size_t i = 0; i < Axes; ++i) {
        const Vec3 axis = axes()[i];
        const double rounding = FloatRounding * axis.cwiseAbs().dot(reach);
        hull.flat = hull.flat || mMost[i] - mLeast[i] <= rounding;
        if ((axis.array() == 0.0).any()) continue;
        const double middle = axis.dot(box.centre);
        const double corner = axis.cwiseAbs().dot(box.halfExtents);
        hull.hasCorners = hull.hasCorners && mMost[i] - middle >= corner - rounding &&
                          middle - mLeast[i] >= corner - rounding;
    }
    return hull;
}

BodyHull makeBodyHull(std::span<const Vec3> positions) {
    BodyHullBuilder builder;
    builder.add(positions);
    return builder.build();
}

void clipHull(const BodyHull& hull, const Transform3& wsFromBody, const ConvexVolume& volume,
              ClipScratch& scratch, std::vector<Vec3>& points) {
    scratch.vertices.clear();
    for (const Vec3& vertex : hull.vertices)
        scratch.vertices.push_back(wsFromBody * vertex);
    scratch.edges = hull.edges;
    clipEdges(volume, hull.faces, scratch, points);
}

} // namespace Lixel

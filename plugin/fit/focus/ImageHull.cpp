#include "fit/focus/ImageHull.h"

#include "fit/geometry/Multiversion.h"
#include "fit/geometry/Simd.h"

#include <algorithm>
#include <cstring>

namespace Lixel {
namespace {

/// A point no farther beyond an edge than this part of the largest coordinate, some units in its
/// last place, is on it: otherwise copies of one point, up to rounding, would make edges that run
/// anywhere.
constexpr double OnEdge = 0x1p-50;

/// A hull narrower than this part of its length, or than as many times OnEdge, is flat: a point
/// left out at the tip of a hull that is just not flat is a 2^-20th of the length beyond it.
constexpr double FlatRatio = 0x1p-16;
constexpr double FlatWidth = 0x1p20 * OnEdge;

/// The edges of a polygon that a point lies beyond: one run of them, around the polygon.
struct Beyond {
    std::size_t count = 0;
    /// The first of them; by rounding there may be more runs than one.
    std::size_t begin = 0;
    std::size_t runs = 0;
    /// Twice the area between them and the point.
    double twiceArea = 0.0;
    /// Whether the edge before the next one is one of them.
    bool last = false;

    /// Goes on to the next edge.
    void next(std::size_t edge, bool beyond, double side) {
        if (beyond) {
            ++count;
            twiceArea -= side;
            if (!last) {
                begin = edge;
                ++runs;
            }
        }
        last = beyond;
    }
};

/// Four vertices in turn; the second and the third change places, so that they are quick to load.
struct FourVertices {
    static constexpr std::array<int, 4> Lanes = {0, 2, 1, 3};
    Four x;
    Four y;
};

// Two of them fill a register: nothing lies between.
static_assert(sizeof(std::array<Vec2, 2>) == sizeof(Four));

/// @param vertices one after the other
[[gnu::always_inline]] inline void loadVertices(std::span<const Vec2, 4> vertices,
                                                FourVertices& result) {
    Four low;
    Four high;
    // Of the vertices themselves: a vertex's own data() ends with its two numbers.
    std::memcpy(&low, vertices.first<2>().data(), sizeof(low));
    std::memcpy(&high, vertices.last<2>().data(), sizeof(high));
    result.x = __builtin_shufflevector(low, high, 0, 4, 2, 6);
    result.y = __builtin_shufflevector(low, high, 1, 5, 3, 7);
}

/// Finds the edges that the point lies beyond.
/// @param slack how far beyond an edge is still on it, by the edge's length in either coordinate
LIXEL_MULTIVERSION
void findBeyond(std::span<const Vec2> hull, const Vec2& point, double slack, Beyond& result) {
    const std::size_t n = hull.size();
    double sideOfOne = 0.0;
    const auto isBeyond = [&](std::size_t edge) {
        const Vec2& from = hull[edge];
        const Vec2 along = hull[edge + 1 < n ? edge + 1 : 0] - from;
        sideOfOne = cross(along, point - from);
        return sideOfOne < -slack * (std::abs(along.x()) + std::abs(along.y()));
    };
    // The edge that closes the polygon comes before the first, and is the last.
    const bool closing = isBeyond(n - 1);
    const double sideOfClosing = sideOfOne;
    result.last = closing;
    std::size_t i = 0;
    for (; i + 4 < n; i += 4) {
        FourVertices from;
        FourVertices to;
        loadVertices(hull.subspan(i).first<4>(), from);
        loadVertices(hull.subspan(i + 1).first<4>(), to);
        const Four edgeX = to.x - from.x;
        const Four edgeY = to.y - from.y;
        const Four side = edgeX * (point.y() - from.y) - edgeY * (point.x() - from.x);
        const Four length = (edgeX < 0.0 ? -edgeX : edgeX) + (edgeY < 0.0 ? -edgeY : edgeY);
        const unsigned beyond = bitsOf(side < -slack * length);
        if (beyond == 0) {
            result.last = false;
            continue;
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const int lane = FourVertices::Lanes[k];
            result.next(i + k, (beyond >> lane & 1U) != 0, side[lane]);
        }
    }
    for (; i + 1 < n; ++i) {
        const bool beyond = isBeyond(i);
        result.next(i, beyond, sideOfOne);
    }
    result.next(n - 1, closing, sideOfClosing);
}

/// Finds which of four points lie beyond an edge, as bits.
/// @param slack as above
LIXEL_MULTIVERSION
unsigned lanesBeyond(std::span<const Vec2> hull, std::span<const Vec2, 4> points, double slack) {
    FourVertices four;
    loadVertices(points, four);
    FourMask beyond{};
    Vec2 from = hull.back();
    for (const Vec2& to : hull) {
        const double edgeX = to.x() - from.x();
        const double edgeY = to.y() - from.y();
        const double limit = -slack * (std::abs(edgeX) + std::abs(edgeY));
        beyond |= edgeX * (four.y - from.y()) - edgeY * (four.x - from.x()) < limit;
        from = to;
    }
    const unsigned bits = bitsOf(beyond);
    // The second and the third change places back.
    return (bits & 9U) | (bits & 2U) << 1 | (bits & 4U) >> 1;
}

} // namespace

void ImageHull::reset(const LightImage& image) {
    mImage = image;
    mHull.clear();
    mEdges.clear();
    mFlat = true;
    ++mRevision;
}

HalfSpace ImageHull::edgePlane(const Vec2& from, const Vec2& to) const {
    const Vec2 edge = to - from;
    // cross(edge, q - from) >= 0 for q = (x, y), or for q = (x, y) / -z with -z multiplied out.
    const double at = cross(edge, from);
    const Mat3& axes = mImage.lsFromWs();
    const Vec3 across = edge.x() * axes.row(1) - edge.y() * axes.row(0);
    if (mImage.directional()) return {across, -at};
    const Vec3 normal = across + at * axes.row(2).transpose();
    return {normal, -normal.dot(mImage.wsEye())};
}

void ImageHull::rebuild(std::span<const Vec2> points) {
    ++mRevision;
    mPoints = mHull;
    mPoints.insert(mPoints.end(), points.begin(), points.end());
    convexHull(mPoints, mHull);
    mEdges.clear();
    const std::size_t n = mHull.size();
    for (std::size_t i = 0; i < n && n > 2; ++i)
        mEdges.push_back(edgePlane(mHull[i], mHull[i + 1 < n ? i + 1 : 0]));

    mOrigin = mHull[0];
    mSquaredLength = 0.0;
    mTwiceArea = 0.0;
    mCoordinate = largestCoordinate(mHull);
    for (std::size_t i = 1; i < n; ++i) {
        mSquaredLength = std::max(mSquaredLength, (mHull[i] - mOrigin).squaredNorm());
        mTwiceArea += cross(mHull[i - 1] - mOrigin, mHull[i] - mOrigin);
    }
    findFlatness();
}

void ImageHull::findFlatness() {
    mFlat = !(mTwiceArea > FlatRatio * mSquaredLength &&
              mTwiceArea > FlatWidth * mCoordinate * std::sqrt(mSquaredLength));
}

bool ImageHull::holds(std::span<const Vec2> points) const {
    if (mFlat) return false;
    const double slack = clipSlack(mCoordinate);
    Vec2 from = mHull.back();
    for (const Vec2& to : mHull) {
        const Vec2 along = to - from;
        const double least = -slack * (std::abs(along.x()) + std::abs(along.y()));
        if (std::ranges::any_of(points,
                                [&](const Vec2& p) { return !(cross(along, p - from) >= least); }))
            return false;
        from = to;
    }
    return true;
}

void ImageHull::add(std::span<const Vec2> points) {
    while (!points.empty()) {
        // A flat hull is found by sorting, which never loses its ends.
        if (mFlat) return rebuild(points);
        const std::size_t count = std::min<std::size_t>(points.size(), 4);
        // Most points are within.
        unsigned rest = (1U << count) - 1;
        if (count == 4) rest = lanesBeyond(mHull, points.first<4>(), OnEdge * mCoordinate);
        for (; rest != 0; rest &= rest - 1)
            addOne(points[static_cast<std::size_t>(std::countr_zero(rest))]);
        points = points.subspan(count);
    }
}

void ImageHull::addOne(const Vec2& point) {
    const std::size_t n = mHull.size();
    const auto rebuildWith = [this](const Vec2& p) { rebuild({&p, 1}); };
    if (mFlat) return rebuildWith(point);

    const double coordinate = std::max(mCoordinate, point.cwiseAbs().maxCoeff());
    Beyond beyond;
    findBeyond(mHull, point, OnEdge * coordinate, beyond);
    if (beyond.count == 0) return;
    // Rounding, where the hull is next to nothing.
    if (beyond.runs != 1) return rebuildWith(point);

    // What remains runs from vertex `first` over `kept` vertices to where the run began.
    const auto vertex = [&](std::size_t i) -> const Vec2& { return mHull[i < n ? i : i - n]; };
    std::size_t first = (beyond.begin + beyond.count) % n;
    std::size_t kept = n + 1 - beyond.count;
    // Vertices on the line from the point to their neighbours are none.
    const auto turn = [](const Vec2& a, const Vec2& b, const Vec2& c) {
        return cross(b - a, c - b);
    };
    while (kept > 2 && turn(vertex(first + kept - 2), vertex(first + kept - 1), point) <= 0.0)
        --kept;
    while (kept > 2 && turn(point, vertex(first), vertex(first + 1)) <= 0.0) {
        first = (first + 1) % n;
        --kept;
    }
    if (kept == 2 && turn(point, vertex(first), vertex(first + 1)) <= 0.0)
        return rebuildWith(point);

    ++mRevision;
    const std::size_t at = replaceBefore(first, n - kept, point);
    const std::size_t size = mHull.size();
    const std::size_t before = at > 0 ? at - 1 : size - 1;
    mEdges[before] = edgePlane(mHull[before], point);
    mEdges[at] = edgePlane(point, mHull[at + 1 < size ? at + 1 : 0]);

    mCoordinate = coordinate;
    mSquaredLength = std::max(mSquaredLength, (point - mOrigin).squaredNorm());
    mTwiceArea += beyond.twiceArea;
    findFlatness();
}

std::size_t ImageHull::replaceBefore(std::size_t end, std::size_t count, const Vec2& point) {
    const auto shift = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
    // Those that come before the polygon's first vertex are its last.
    const std::size_t front = std::min(end, count);
    mHull.resize(mHull.size() - (count - front));
    mEdges.resize(mHull.size());
    const std::size_t at = end > 0 ? end - front : mHull.size();
    if (front == 0) {
        mHull.insert(mHull.begin() + shift(at), point);
        mEdges.insert(mEdges.begin() + shift(at), HalfSpace());
    } else {
        mHull[at] = point;
        mHull.erase(mHull.begin() + shift(at + 1), mHull.begin() + shift(end));
        mEdges.erase(mEdges.begin() + shift(at + 1), mEdges.begin() + shift(end));
    }
    return at;
}

std::array<Vec2, 8> boxImage(const LightImage& image, const Aabb& box) {
    const Vec3 centre = image.lsFromPoint(box.centre);
    const Mat3 sides = image.lsFromWs() * box.halfExtents.asDiagonal();
    std::array<Vec2, 8> result;
    for (std::size_t i = 0; i < 8; ++i)
        result[i] = image.project(centre + ((i & 1) != 0 ? 1.0 : -1.0) * sides.col(0) +
                                  ((i & 2) != 0 ? 1.0 : -1.0) * sides.col(1) +
                                  ((i & 4) != 0 ? 1.0 : -1.0) * sides.col(2));
    return result;
}

} // namespace Lixel

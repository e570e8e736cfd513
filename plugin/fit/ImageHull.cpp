#include "fit/ImageHull.h"

#include <algorithm>

namespace Lixel {
namespace {

/// A point no farther beyond an edge than this part of the largest coordinate, some units in its
/// last place, is on it: or copies of one point but for rounding would make edges that run
/// anywhere.
constexpr double OnEdge = 0x1p-50;

/// A hull narrower than this part of its length, or than as many times OnEdge, is flat: a point
/// left out at the tip of a hull that is just not flat is a 2^-20th of the length beyond it.
constexpr double FlatRatio = 0x1p-16;
constexpr double FlatWidth = 0x1p20 * OnEdge;

} // namespace

void ImageHull::reset(const LightImage& image) {
    mImage = image;
    mHull.clear();
    mEdges.clear();
    mFlat = true;
    ++mRevision;
}

Plane ImageHull::edgePlane(const Vec2& from, const Vec2& to) const {
    const Vec2 edge = to - from;
    // cross(edge, q - from) >= 0 for q = (x, y), or for q = (x, y) / -z with -z multiplied out.
    const double at = cross(edge, from);
    const Vec3 ls(-edge.y(), edge.x(), mImage.directional() ? 0.0 : at);
    const Vec3 ws = mImage.lsFromWs().transpose() * ls;
    return {ws, -ws.dot(mImage.wsEye()) - (mImage.directional() ? at : 0.0)};
}

void ImageHull::rebuild(const Vec2& point) {
    ++mRevision;
    mNextHull = mHull;
    mNextHull.push_back(point);
    convexHull(mNextHull, mHull);
    mEdges.clear();
    const std::size_t n = mHull.size();
    for (std::size_t i = 0; i < n && n > 2; ++i)
        mEdges.push_back(edgePlane(mHull[i], mHull[i + 1 < n ? i + 1 : 0]));
    findFlatness();
}

void ImageHull::findFlatness() {
    const std::size_t n = mHull.size();
    mFlat = true;
    mCoordinate = largestCoordinate(mHull);
    if (n < 3) return;
    double twiceArea = 0.0;
    double squaredLength = 0.0;
    for (std::size_t i = 2; i < n; ++i)
        twiceArea += cross(mHull[i - 1] - mHull[0], mHull[i] - mHull[0]);
    for (std::size_t i = 1; i < n; ++i)
        squaredLength = std::max(squaredLength, (mHull[i] - mHull[0]).squaredNorm());
    mFlat = !(twiceArea > FlatRatio * squaredLength &&
              twiceArea > FlatWidth * mCoordinate * std::sqrt(squaredLength));
}

void ImageHull::add(const Vec2& point) {
    const std::size_t n = mHull.size();
    // A flat hull is found by sorting, which never loses its ends.
    if (mFlat) return rebuild(point);

    // The edges that the point lies beyond: one run of them, around the polygon.
    std::size_t beyond = 0;
    std::size_t runs = 0;
    std::size_t begin = 0;
    const double slack = OnEdge * std::max(mCoordinate, point.cwiseAbs().maxCoeff());
    const auto isBeyond = [&](std::size_t i) {
        const Vec2& a = mHull[i];
        const Vec2 edge = mHull[i + 1 < n ? i + 1 : 0] - a;
        return cross(edge, point - a) < -slack * (std::abs(edge.x()) + std::abs(edge.y()));
    };
    bool last = isBeyond(n - 1);
    for (std::size_t i = 0; i < n; ++i) {
        const bool now = isBeyond(i);
        if (now) ++beyond;
        if (now && !last) {
            begin = i;
            ++runs;
        }
        last = now;
    }
    if (beyond == 0) return;
    // Rounding, where the hull is next to nothing.
    if (runs != 1) return rebuild(point);

    // What remains runs from vertex `first` over `kept` vertices to where the run began.
    const auto vertex = [&](std::size_t i) -> const Vec2& { return mHull[i < n ? i : i - n]; };
    std::size_t first = (begin + beyond) % n;
    std::size_t kept = n + 1 - beyond;
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
    if (kept == 2 && turn(point, vertex(first), vertex(first + 1)) <= 0.0) return rebuild(point);

    ++mRevision;
    mNextHull.clear();
    mNextEdges.clear();
    mNextHull.push_back(point);
    mNextEdges.push_back(edgePlane(point, vertex(first)));
    for (std::size_t i = first; i < first + kept; ++i) {
        mNextHull.push_back(vertex(i));
        if (i + 1 < first + kept) mNextEdges.push_back(mEdges[i < n ? i : i - n]);
    }
    mNextEdges.push_back(edgePlane(mNextHull.back(), point));
    mHull.swap(mNextHull);
    mEdges.swap(mNextEdges);
    findFlatness();
}

std::array<Vec2, 8> boxImage(const LightImage& image, const Box& box) {
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

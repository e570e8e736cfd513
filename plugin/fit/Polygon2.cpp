#include "fit/Polygon2.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace Lixel {
namespace {

constexpr double HalfPi = std::numbers::pi / 2.0;

double largestCoordinate(const Polygon2& polygon) {
    double size = 0.0;
    for (const Vec2& p : polygon)
        size = std::max(size, p.cwiseAbs().maxCoeff());
    return size;
}

/// Keeps of `polygon` what lies to the left of the line through `origin` along `edge`, or within
/// `slack` of it.
void clipLeftOf(const Polygon2& polygon, const Vec2& origin, const Vec2& edge, double slack,
                Polygon2& result) {
    result.clear();
    const double length = edge.norm();
    if (length == 0.0) {
        result = polygon;
        return;
    }
    const auto side = [&](const Vec2& p) { return cross(edge, p - origin) / length + slack; };
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2& a = polygon[i];
        const Vec2& b = polygon[(i + 1) % n];
        const double sa = side(a);
        const double sb = side(b);
        if (sa >= 0.0) result.push_back(a);
        if ((sa > 0.0 && sb < 0.0) || (sa < 0.0 && sb > 0.0))
            result.push_back(a + (b - a) * (sa / (sa - sb)));
    }
}

/// Drops vertices that lie on the line through their neighbours, within rounding, or left of it.
void dropFlatVertices(Polygon2& polygon) {
    const double rounding = 64.0 * std::numeric_limits<double>::epsilon();
    for (std::size_t i = 0; i < polygon.size() && polygon.size() > 3;) {
        const std::size_t n = polygon.size();
        const Vec2 in = polygon[i] - polygon[(i + n - 1) % n];
        const Vec2 out = polygon[(i + 1) % n] - polygon[i];
        // The vertex' distance from the line, times the line's length, against rounding of both.
        if (cross(in, out) <= rounding * (in + out).norm() * polygon[i].norm())
            polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
        else
            ++i;
    }
}

} // namespace

void convexHull(std::vector<Vec2>& points, Polygon2& hull) {
    hull.clear();
    std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) {
        hull = points;
        return;
    }
    const auto turnsRight = [&](const Vec2& p) {
        const std::size_t k = hull.size();
        return cross(hull[k - 1] - hull[k - 2], p - hull[k - 1]) <= 0.0;
    };
    for (const Vec2& p : points) {
        while (hull.size() >= 2 && turnsRight(p))
            hull.pop_back();
        hull.push_back(p);
    }
    const std::size_t lower = hull.size();
    for (std::size_t i = points.size() - 1; i-- > 0;) {
        while (hull.size() > lower && turnsRight(points[i]))
            hull.pop_back();
        hull.push_back(points[i]);
    }
    hull.pop_back();
}

void intersect(const Polygon2& a, const Polygon2& b, Polygon2& result, Polygon2& scratch) {
    result = a;
    if (a.empty() || b.empty()) {
        result.clear();
        return;
    }
    // Rounding of the vertices: a few units in the last place of the largest coordinate.
    const double slack = 16.0 * std::numeric_limits<double>::epsilon() *
                         std::max(largestCoordinate(a), largestCoordinate(b));
    if (b.size() == 1) {
        // A point has no edges to clip by: it is clipped by the other instead.
        if (a.size() > 1) return intersect(b, a, result, scratch);
        if ((a[0] - b[0]).norm() > slack) result.clear();
        return;
    }
    for (std::size_t i = 0; i < b.size() && !result.empty(); ++i) {
        clipLeftOf(result, b[i], b[(i + 1) % b.size()] - b[i], slack, scratch);
        result.swap(scratch);
    }
    if (b.size() == 2) {
        // Both half planes of a segment's line were applied above; its two ends remain.
        const Vec2 along = b[1] - b[0];
        const Vec2 across(-along.y(), along.x());
        clipLeftOf(result, b[0], -across, slack, scratch);
        result.swap(scratch);
        clipLeftOf(result, b[1], across, slack, scratch);
        result.swap(scratch);
    }
}

Vec2 steinerPoint(std::span<const Vec2> polygon) {
    const std::size_t n = polygon.size();
    if (n == 0) return Vec2::Zero();
    // Relative to the first vertex, so that a far away polygon loses no digits.
    Vec2 sum = Vec2::Zero();
    double total = 0.0;
    Vec2 in = Vec2::Zero(); // the edge that ends at this vertex, none of length zero
    for (std::size_t i = n; i-- > 0 && in.isZero(0.0);)
        in = polygon[0] - polygon[i];
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 out = polygon[(i + 1) % n] - polygon[i];
        if (out.isZero(0.0)) continue; // a repeated vertex: its last instance counts
        const double exterior = std::abs(std::atan2(cross(in, out), in.dot(out)));
        sum += exterior * (polygon[i] - polygon[0]);
        total += exterior;
        in = out;
    }
    if (!(total > 0.0)) return polygon[0];
    return polygon[0] + sum / total;
}

double support(std::span<const Vec2> polygon, const Vec2& d) {
    double result = -std::numeric_limits<double>::infinity();
    for (const Vec2& q : polygon)
        result = std::max(result, d.dot(q));
    return result;
}

void simplifyOutward(Polygon2& polygon, std::size_t maxVertices) {
    // Vertices on a line but for rounding have neighbours that meet anywhere.
    dropFlatVertices(polygon);
    while (polygon.size() > std::max<std::size_t>(maxVertices, 4)) {
        const std::size_t n = polygon.size();
        double leastArea = std::numeric_limits<double>::infinity();
        std::size_t drop = n;
        Vec2 corner = Vec2::Zero();
        for (std::size_t i = 0; i < n; ++i) {
            // Drop the edge from b to c: its neighbours a-b and d-c are extended until they meet.
            const Vec2& a = polygon[(i + n - 1) % n];
            const Vec2& b = polygon[i];
            const Vec2& c = polygon[(i + 1) % n];
            const Vec2& d = polygon[(i + 2) % n];
            const double turn = cross(b - a, c - d);
            if (!(turn < 0.0)) continue; // the neighbours turn by π or more: they never meet
            const double t = cross(c - b, c - d) / turn;
            const Vec2 meet = b + t * (b - a);
            const double area = cross(c - b, meet - b) * -0.5;
            if (t >= 0.0 && (meet - c).dot(c - d) >= 0.0 && area < leastArea) {
                leastArea = area;
                drop = i;
                corner = meet;
            }
        }
        if (drop == n) return;
        polygon[drop] = corner;
        polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>((drop + 1) % n));
    }
}

OrientedRectangle boundsAt(std::span<const Vec2> polygon, double angle) {
    OrientedRectangle r;
    r.angle = angle;
    const Vec2 u(std::cos(angle), std::sin(angle));
    const Vec2 v(-u.y(), u.x());
    r.min.setConstant(std::numeric_limits<double>::infinity());
    r.max = -r.min;
    for (const Vec2& q : polygon) {
        const Vec2 p(u.dot(q), v.dot(q));
        r.min = r.min.cwiseMin(p);
        r.max = r.max.cwiseMax(p);
    }
    if (polygon.empty()) r.min = r.max = Vec2::Zero();
    return r;
}

OrientedRectangle smallestRectangle(std::span<const Vec2> polygon) {
    OrientedRectangle best = boundsAt(polygon, 0.0);
    if (polygon.size() < 2) return best;
    double leastArea = std::numeric_limits<double>::infinity();
    double leastPerimeter = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 edge = polygon[(i + 1) % polygon.size()] - polygon[i];
        if (edge.squaredNorm() == 0.0) continue;
        double angle = std::fmod(std::atan2(edge.y(), edge.x()) + 4.0 * HalfPi, HalfPi);
        const OrientedRectangle r = boundsAt(polygon, angle);
        const double perimeter = (r.max - r.min).sum();
        // A polygon without area makes many rectangles of area 0: the shortest is the one wanted.
        if (r.area() < leastArea || (r.area() == leastArea && perimeter < leastPerimeter)) {
            leastArea = r.area();
            leastPerimeter = perimeter;
            best = r;
        }
    }
    return best;
}

} // namespace Lixel

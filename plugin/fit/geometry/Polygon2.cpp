#include "fit/geometry/Polygon2.h"

#include "fit/geometry/Multiversion.h"
#include "fit/geometry/Simd.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

namespace Lixel {
namespace {

constexpr double HalfPi = std::numbers::pi / 2.0;
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Four unit vectors, and a polygon's bounds along each and its left-hand normal.
struct FourAxes {
    std::array<double, 4> x{}, y{};
    std::array<double, 4> leastAlong, leastAcross, mostAlong, mostAcross;

    OrientedRectangle bounds(std::size_t lane) const {
        return {.min = {leastAlong[lane], leastAcross[lane]},
                .max = {mostAlong[lane], mostAcross[lane]}};
    }
};

LIXEL_MULTIVERSION
void findBounds(std::span<const Vec2> polygon, FourAxes& axes) {
    Four x;
    Four y;
    load(axes.x.data(), x);
    load(axes.y.data(), y);
    Four leastAlong = Four{} + Infinity;
    Four leastAcross = leastAlong;
    Four mostAlong = -leastAlong;
    Four mostAcross = -leastAlong;
    for (const Vec2& q : polygon) {
        const Four along = x * q.x() + y * q.y();
        const Four across = x * q.y() - y * q.x();
        lesser(along, leastAlong, leastAlong);
        lesser(across, leastAcross, leastAcross);
        greater(along, mostAlong, mostAlong);
        greater(across, mostAcross, mostAcross);
    }
    store(leastAlong, axes.leastAlong.data());
    store(leastAcross, axes.leastAcross.data());
    store(mostAlong, axes.mostAlong.data());
    store(mostAcross, axes.mostAcross.data());
}

/// The polygon's bounds along a unit vector and its left-hand normal; the angle is left at 0.
OrientedRectangle boundsAlong(std::span<const Vec2> polygon, const Vec2& axis) {
    if (polygon.empty()) return {};
    FourAxes axes;
    axes.x[0] = axis.x();
    axes.y[0] = axis.y();
    findBounds(polygon, axes);
    return axes.bounds(0);
}

/// The direction of an edge, turned by right angles to where both coordinates are positive, the
/// first not zero; zero for an edge of length zero.
Vec2 axisAlong(const Vec2& edge) {
    const double length = edge.norm();
    if (length == 0.0) return Vec2::Zero();
    Vec2 axis = edge / length;
    if (axis.x() < 0.0 || (axis.x() == 0.0 && axis.y() < 0.0)) axis = -axis;
    if (axis.y() < 0.0 || axis.x() == 0.0) axis = Vec2(std::abs(axis.y()), axis.x());
    return axis;
}

/// Drops vertices that lie on the line through their neighbours, within rounding, or left of it.
void dropFlatVertices(Polygon2& polygon) {
    const double rounding = 64.0 * std::numeric_limits<double>::epsilon();
    for (std::size_t i = 0; i < polygon.size() && polygon.size() > 3;) {
        const std::size_t n = polygon.size();
        const Vec2 in = polygon[i] - polygon[(i > 0 ? i : n) - 1];
        const Vec2 out = polygon[i + 1 < n ? i + 1 : 0] - polygon[i];
        // The vertex's distance from the line, times the line's length, against rounding of both.
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

double largestCoordinate(std::span<const Vec2> polygon) {
    double size = 0.0;
    for (const Vec2& p : polygon)
        size = std::max(size, p.cwiseAbs().maxCoeff());
    return size;
}

void clipLeftOf(std::span<const Vec2> polygon, const Vec2& from, const Vec2& to, double slack,
                Polygon2& result) {
    const Vec2 edge = to - from;
    const double length = edge.norm();
    if (length == 0.0) {
        result.assign(polygon.begin(), polygon.end());
        return;
    }
    const Vec2 along = edge / length;
    clipBy(
        polygon, [&](const Vec2& p) { return cross(along, p - from) + slack; }, result);
}

void intersect(const Polygon2& a, const Polygon2& b, Polygon2& result, Polygon2& scratch) {
    result = a;
    if (a.empty() || b.empty()) {
        result.clear();
        return;
    }
    const double slack = clipSlack(std::max(largestCoordinate(a), largestCoordinate(b)));
    if (b.size() == 1) {
        // A point has no edges to clip by: it is clipped by the other instead.
        if (a.size() > 1) return intersect(b, a, result, scratch);
        if ((a[0] - b[0]).norm() > slack) result.clear();
        return;
    }
    for (std::size_t i = 0; i < b.size() && !result.empty(); ++i) {
        clipLeftOf(result, b[i], b[i + 1 < b.size() ? i + 1 : 0], slack, scratch);
        result.swap(scratch);
    }
    if (b.size() == 2) {
        // Both half planes of a segment's line were applied above; its two ends remain.
        const Vec2 along = b[1] - b[0];
        const Vec2 across(-along.y(), along.x());
        clipLeftOf(result, b[0], b[0] - across, slack, scratch);
        result.swap(scratch);
        clipLeftOf(result, b[1], b[1] + across, slack, scratch);
        result.swap(scratch);
    }
}

void sumWithRectangle(std::span<const Vec2> polygon, const Vec2& axis, const Vec2& halfSides,
                      Polygon2& sum) {
    sum.clear();
    const std::size_t n = polygon.size();
    const Vec2 x = halfSides.x() * axis;
    const Vec2 y = halfSides.y() * Vec2(-axis.y(), axis.x());
    // Counter-clockwise; each is farthest along the normals of one quarter.
    const std::array<Vec2, 4> corners = {x + y, y - x, -x - y, x - y};
    // The edge that ends at this vertex, none of length zero.
    Vec2 in = Vec2::Zero();
    for (std::size_t i = n; i-- > 0 && in.isZero(0.0);)
        in = polygon[0] - polygon[i];
    if (in.isZero(0.0)) {
        for (std::size_t i = 0; i < 4 && n > 0; ++i)
            sum.push_back(polygon[0] + corners[i]);
        return;
    }
    // The quarter that the outward normal of an edge points into.
    const auto quarter = [&](const Vec2& edge) -> std::size_t {
        const double normalX = cross(axis, edge);
        const double normalY = -axis.dot(edge);
        if (normalX > 0.0 && normalY >= 0.0) return 0;
        if (normalX <= 0.0 && normalY > 0.0) return 1;
        return normalX < 0.0 ? 2 : 3;
    };
    std::size_t from = quarter(in);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 out = polygon[i + 1 < n ? i + 1 : 0] - polygon[i];
        if (out.isZero(0.0)) continue; // a repeated vertex: its last instance counts
        const std::size_t to = quarter(out);
        // No vertex turns by three quarters. If rounding says so, it is really a slight turn back
        // or, at the end of a sliver, half a turn.
        std::size_t steps = (to - from) % 4;
        if (steps == 3 && in.dot(out) > 0.0) steps = 0;
        for (std::size_t step = 0; step <= steps; ++step)
            sum.push_back(polygon[i] + corners[(from + step) % 4]);
        from = to;
        in = out;
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
    double result = -Infinity;
    for (const Vec2& q : polygon)
        result = std::max(result, d.dot(q));
    return result;
}

void simplifyOutward(Polygon2& polygon, std::size_t maxVertices) {
    // Vertices on a line up to rounding have neighbours that meet anywhere.
    dropFlatVertices(polygon);
    while (polygon.size() > std::max<std::size_t>(maxVertices, 4)) {
        const std::size_t n = polygon.size();
        double leastArea = Infinity;
        std::size_t drop = n;
        Vec2 corner = Vec2::Zero();
        const auto vertex = [&](std::size_t i) -> const Vec2& {
            return polygon[i < n ? i : i - n];
        };
        for (std::size_t i = 0; i < n; ++i) {
            // Drop the edge from b to c: its neighbours a-b and d-c are extended until they meet.
            const Vec2& a = vertex(i + n - 1);
            const Vec2& b = polygon[i];
            const Vec2& c = vertex(i + 1);
            const Vec2& d = vertex(i + 2);
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
    OrientedRectangle r = boundsAlong(polygon, Vec2(std::cos(angle), std::sin(angle)));
    r.angle = angle;
    return r;
}

OrientedRectangle smallestRectangle(std::span<const Vec2> polygon) {
    const std::size_t n = polygon.size();
    OrientedRectangle best = boundsAlong(polygon, Vec2::UnitX());
    if (n < 2) return best;
    double leastArea = Infinity;
    double leastPerimeter = Infinity;
    Vec2 bestAxis = Vec2::UnitX();
    for (std::size_t i = 0; i < n; i += 4) {
        FourAxes axes;
        const std::size_t count = std::min<std::size_t>(n - i, 4);
        for (std::size_t lane = 0; lane < count; ++lane) {
            const std::size_t next = i + lane + 1;
            const Vec2 axis = axisAlong(polygon[next < n ? next : 0] - polygon[i + lane]);
            axes.x[lane] = axis.x();
            axes.y[lane] = axis.y();
        }
        findBounds(polygon, axes);
        for (std::size_t lane = 0; lane < count; ++lane) {
            const Vec2 axis(axes.x[lane], axes.y[lane]);
            const OrientedRectangle r = axes.bounds(lane);
            const double area = r.area();
            const double perimeter = (r.max - r.min).sum();
            // A polygon without area makes many rectangles of area 0: the shortest is the one
            // wanted.
            const bool better =
                area < leastArea || (area == leastArea && perimeter < leastPerimeter);
            if (!better || axis.isZero(0.0)) continue;
            leastArea = area;
            leastPerimeter = perimeter;
            best = r;
            bestAxis = axis;
        }
    }
    // An axis that is next to the second one may round to a right angle, which is the first.
    best.angle = std::min(std::atan2(bestAxis.y(), bestAxis.x()), std::nextafter(HalfPi, 0.0));
    return best;
}

} // namespace Lixel

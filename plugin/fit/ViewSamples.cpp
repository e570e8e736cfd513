#include "fit/ViewSamples.h"

#include "fit/LowDiscrepancy.h"
#include "fit/ShadowParts.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <limits>

namespace Lixel {
namespace {

/// View rays in rows and columns, one per cell of the picture: so many that a focus region which
/// fills but a tenth of the picture still gets its samples.
constexpr int Columns = 20;
constexpr int Rows = 18;

/// Least cosine between normal and light.
constexpr double LeastFacing = 0.05;

/// The range of cells, out of `count`, that the device coordinates lower to upper reach into.
std::pair<int, int> cells(double lower, double upper, int count) {
    const auto cell = [&](double ndc) {
        const double at = (ndc + 1.0) / 2.0 * count;
        if (!(at > 0.0)) return 0; // a NaN too, which any cell is as good for
        return at < count ? static_cast<int>(at) : count - 1;
    };
    return {cell(lower), cell(upper)};
}

/// Bounds of the box in one device coordinate, whose numerator is x and denominator w, each given
/// as its value at the centre and its reach over the box.
std::pair<double, double> bounds(double x, double xReach, double wLeast, double wGreatest) {
    const double lower = x - xReach;
    const double upper = x + xReach;
    return {lower / (lower < 0.0 ? wLeast : wGreatest), upper / (upper > 0.0 ? wLeast : wGreatest)};
}

/// Shortens the ray to the box if that is nearer than what it met before.
void meet(const Box& box, ViewSampleScratch::Ray& ray) {
    const Vec3 a = (box.centre - box.halfExtents - ray.origin).cwiseProduct(ray.inverse);
    const Vec3 b = (box.centre + box.halfExtents - ray.origin).cwiseProduct(ray.inverse);
    const Vec3 in = a.cwiseMin(b);
    const Vec3 out = a.cwiseMax(b);
    Eigen::Index entry = 0;
    Eigen::Index exit = 0;
    const double tIn = in.maxCoeff(&entry);
    const double tOut = out.minCoeff(&exit);
    if (!(tIn <= tOut) || !(tOut >= 0.0)) return;
    const bool inside = tIn < 0.0;
    const double t = inside ? tOut : tIn;
    if (!(t < ray.nearest)) return;
    const Eigen::Index axis = inside ? exit : entry;
    ray.nearest = t;
    ray.normal = Vec3::Zero();
    ray.normal[axis] = ray.direction[axis] > 0.0 ? -1.0 : 1.0;
}

/// Shortens the ray to the disc if that is nearer, and seen from its front.
void meet(const Surfel& disc, ViewSampleScratch::Ray& ray) {
    const double towards = -ray.direction.dot(disc.normal);
    if (!(towards > 0.0)) return;
    const Vec3 away = ray.origin - disc.centre;
    const double t = away.dot(disc.normal) / towards;
    if (!(t >= 0.0) || !(t < ray.nearest)) return;
    if ((away + t * ray.direction).squaredNorm() > disc.radius * disc.radius) return;
    ray.nearest = t;
    ray.normal = disc.normal;
}

/// One ray through each cell of the picture. Directions have any length.
void castRays(const Mat4& worldFromClip, std::vector<ViewSampleScratch::Ray>& rays) {
    const Vec4 nearMiddle = worldFromClip.col(3) - worldFromClip.col(2);
    const Vec4 farMiddle = worldFromClip.col(3) + worldFromClip.col(2);
    rays.resize(static_cast<std::size_t>(Rows) * Columns);
    std::size_t index = 0;
    for (int row = 0; row < Rows; ++row)
        for (int column = 0; column < Columns; ++column, ++index) {
            // Off the middle, so that rays do not line up with rows of objects.
            const Vec2 cell = Vec2(column, row) + lowDiscrepancy(index);
            ViewSampleScratch::Ray& ray = rays[index];
            ray.ndc = {2.0 * cell.x() / Columns - 1.0, 2.0 * cell.y() / Rows - 1.0};
            const Vec4 across =
                worldFromClip.col(0) * ray.ndc.x() + worldFromClip.col(1) * ray.ndc.y();
            const Vec4 nearPoint = nearMiddle + across;
            const Vec4 farPoint = farMiddle + across;
            ray.origin = nearPoint.head<3>() / nearPoint.w();
            // Also right where the far point is at infinity.
            ray.direction = farPoint.head<3>() - farPoint.w() * ray.origin;
            ray.inverse = ray.direction.cwiseInverse();
            ray.nearest = std::numeric_limits<double>::infinity();
        }
}

/// The rays that may meet a body.
class Reach {
public:
    explicit Reach(const Mat4& clipFromWorld)
        : mClipFromWorld(clipFromWorld), mAbsolute(clipFromWorld.cwiseAbs()) {}

    /// Calls `visit` with each ray through a cell that the box reaches into.
    template <typename Visit>
    void forEach(const Box& box, std::vector<ViewSampleScratch::Ray>& rays,
                 const Visit& visit) const {
        const Vec4 centre = mClipFromWorld * box.centre.homogeneous();
        const Vec4 half = mAbsolute.leftCols<3>() * box.halfExtents;
        const double wLeast = centre.w() - half.w();
        const double wGreatest = centre.w() + half.w();
        if (wGreatest <= 0.0) return;
        if (!(wLeast > 0.0)) {
            for (ViewSampleScratch::Ray& ray : rays)
                visit(ray);
            return;
        }
        const auto [left, right] = bounds(centre.x(), half.x(), wLeast, wGreatest);
        const auto [bottom, top] = bounds(centre.y(), half.y(), wLeast, wGreatest);
        if (left > 1.0 || right < -1.0 || bottom > 1.0 || top < -1.0) return;
        const std::pair<int, int> across = cells(left, right, Columns);
        const std::pair<int, int> up = cells(bottom, top, Rows);
        for (int row = up.first; row <= up.second; ++row)
            for (int column = across.first; column <= across.second; ++column) {
                ViewSampleScratch::Ray& ray =
                    rays[static_cast<std::size_t>(row * Columns + column)];
                // Most small bodies lie beside the one ray of their cell.
                if (ray.ndc.x() < left || ray.ndc.x() > right || ray.ndc.y() < bottom ||
                    ray.ndc.y() > top)
                    continue;
                visit(ray);
            }
    }

private:
    Mat4 mClipFromWorld;
    Mat4 mAbsolute;
};

/// Traces view rays against the receivers: their known surfaces, and the boxes of all others.
void traceReceivers(const ShadowProblem& problem, const Mat4& clipFromWorld,
                    ViewSampleScratch& scratch) {
    castRays(clipFromWorld.inverse(), scratch.rays);
    const Reach reach(clipFromWorld);
    std::size_t next = 0;
    for (std::size_t i = 0; i < problem.receivers->size(); ++i) {
        if (next < problem.surfaces.size() && problem.surfaces[next].receiver == i) {
            ++next;
            continue;
        }
        const Box box = problem.receivers->box(i);
        reach.forEach(box, scratch.rays, [&](ViewSampleScratch::Ray& ray) { meet(box, ray); });
    }
    for (const KnownSurface& surface : problem.surfaces) {
        const Mat3 linear = surface.wsFromCloud.linear();
        // Normals turn with the inverse transpose; discs are as large as the body's volume scales.
        const Mat3 turn = linear.inverse().transpose();
        const double scale = std::cbrt(std::abs(linear.determinant()));
        for (const Surfel& own : surface.cloud->surfels) {
            const Surfel disc{surface.wsFromCloud * own.centre,
                              (turn * own.normal).stableNormalized(), scale * own.radius};
            // Where a disc ends along an axis: its radius by the sine to its normal.
            const Vec3 half =
                disc.radius * (Vec3::Ones() - disc.normal.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
            reach.forEach({disc.centre, half}, scratch.rays,
                          [&](ViewSampleScratch::Ray& ray) { meet(disc, ray); });
        }
    }
}

/// Whether the light may shine on the point from its front, and shadows be cast on it.
bool matters(const ShadowProblem& problem, const LightImage& image, const FocusRegion& region,
             const VisiblePoint& point) {
    const ShadowViewer& viewer = problem.viewer;
    if (viewer.shadowDistance > 0.0 &&
        -viewer.viewFromWorld.row(2).dot(point.ws.homogeneous()) > viewer.shadowDistance)
        return false;
    if (problem.part != nullptr)
        for (const Plane& plane : problem.part->bounds())
            if (plane.distance(point.ws) < 0.0) return false;
    const Vec3 ls = image.lsFromPoint(point.ws);
    const Vec3 lsNormal = image.lsFromDirection(point.wsNormal);
    if (image.directional()) {
        if (lsNormal.z() < LeastFacing) return false;
    } else {
        if (-ls.z() < problem.light.nearDistance) return false;
        if (-lsNormal.dot(ls) < LeastFacing * ls.norm()) return false;
    }
    const Vec2 q = image.project(ls);
    const Polygon2& hull = region.liHull;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2& a = hull[i];
        const Vec2& b = hull[i + 1 < hull.size() ? i + 1 : 0];
        if (cross(b - a, q - a) < 0.0) return false;
    }
    return true;
}

ViewSample sampleAt(const ShadowViewer& viewer, const Mat4& clipFromWorld, const LightImage& image,
                    const VisiblePoint& point) {
    // The tangent's motion for a unit step of each device coordinate u = x / w:
    // du = (row x - u row w) . dx / w, with n . dx = 0.
    const Vec4 clip = clipFromWorld * point.ws.homogeneous();
    Mat3 ndcFromWs;
    for (int axis = 0; axis < 2; ++axis)
        ndcFromWs.row(axis) =
            (clipFromWorld.row(axis) - clip[axis] / clip.w() * clipFromWorld.row(3)).head<3>() /
            clip.w();
    ndcFromWs.row(2) = point.wsNormal.transpose();
    const Vec3 ls = image.lsFromPoint(point.ws);
    ViewSample sample;
    sample.liPoint = image.project(ls);
    sample.vsDepth = -viewer.viewFromWorld.row(2).dot(point.ws.homogeneous());
    Eigen::Matrix<double, 2, 3> liFromLs = Eigen::Matrix<double, 2, 3>::Identity();
    if (!image.directional()) {
        // q = xy / -z, so dq = (dxy + q dz) / -z.
        liFromLs.col(2) = sample.liPoint;
        liFromLs /= -ls.z();
    }
    sample.liFromNdc = liFromLs * image.lsFromWs() * ndcFromWs.inverse().leftCols<2>();
    return sample;
}

} // namespace

void sampleView(const ShadowProblem& problem, const LightImage& image, const FocusRegion& region,
                std::size_t most, ViewSampleScratch& scratch, std::vector<ViewSample>& samples) {
    const Mat4 clipFromWorld = problem.viewer.clipFromView * problem.viewer.viewFromWorld;
    std::vector<VisiblePoint>& points = scratch.points;
    points.clear();
    const auto consider = [&](const Vec3& ws, const Vec3& wsNormal) {
        if (matters(problem, image, region, {ws, wsNormal})) points.push_back({ws, wsNormal});
    };
    if (!problem.visiblePoints.empty()) {
        for (const VisiblePoint& point : problem.visiblePoints)
            consider(point.ws, point.wsNormal);
    } else {
        traceReceivers(problem, clipFromWorld, scratch);
        for (const ViewSampleScratch::Ray& ray : scratch.rays)
            if (std::isfinite(ray.nearest))
                consider(ray.origin + ray.nearest * ray.direction, ray.normal);
    }
    samples.clear();
    const std::size_t kept = std::min(most, points.size());
    for (std::size_t i = 0; i < kept; ++i) {
        const ViewSample sample =
            sampleAt(problem.viewer, clipFromWorld, image, points[i * points.size() / kept]);
        if (sample.liFromNdc.allFinite() && sample.liFromNdc.determinant() != 0.0)
            samples.push_back(sample);
    }
}

} // namespace Lixel

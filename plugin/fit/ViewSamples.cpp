#include "fit/ViewSamples.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <limits>

namespace Lixel {
namespace {

/// View rays in rows and columns, one per cell of the picture: so many that a focus region which
/// fills but a tenth of the picture still gets its samples.
constexpr int Columns = 28;
constexpr int Rows = 24;

/// Least cosine between normal and light.
constexpr double LeastFacing = 0.05;

/// Position of a cell's ray within it, in (0, 1): the R2 low-discrepancy sequence (Roberts 2018),
/// so that rays do not line up with rows of objects.
Vec2 jitter(int index) {
    const Vec2 t = Vec2(0.7548776662466927, 0.5698402909980532) * index;
    return {t.x() - std::floor(t.x()), t.y() - std::floor(t.y())};
}

/// The range of cells, out of `count`, that the device coordinates lower to upper reach into.
std::pair<int, int> cells(double lower, double upper, int count) {
    const auto cell = [&](double ndc) {
        // fmin and fmax take the other argument for a NaN, which a clamp would pass on.
        const double at = std::floor((ndc + 1.0) / 2.0 * count);
        return static_cast<int>(std::fmin(std::fmax(at, 0.0), static_cast<double>(count - 1)));
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

/// Traces view rays against the receivers' boxes.
void traceBoxes(const ShadowProblem& problem, const Mat4& clipFromWorld,
                ViewSampleScratch& scratch) {
    const Mat4 worldFromClip = clipFromWorld.inverse();
    scratch.rays.clear();
    for (int row = 0; row < Rows; ++row)
        for (int column = 0; column < Columns; ++column) {
            const Vec2 cell = Vec2(column, row) + jitter(row * Columns + column);
            const double x = 2.0 * cell.x() / Columns - 1.0;
            const double y = 2.0 * cell.y() / Rows - 1.0;
            const Vec4 nearPoint = worldFromClip * Vec4(x, y, -1.0, 1.0);
            const Vec4 farPoint = worldFromClip * Vec4(x, y, 1.0, 1.0);
            const Vec3 origin = nearPoint.head<3>() / nearPoint.w();
            // Also right where the far point is at infinity.
            const Vec3 direction = (farPoint.head<3>() - farPoint.w() * origin).stableNormalized();
            scratch.rays.push_back({origin, direction, direction.cwiseInverse(),
                                    std::numeric_limits<double>::infinity(), Vec3::Zero()});
        }

    const Mat4 reach = clipFromWorld.cwiseAbs();
    for (const Box& box : problem.receivers->boxes()) {
        const Vec4 centre = clipFromWorld * box.centre.homogeneous();
        const Vec4 half = reach.leftCols<3>() * box.halfExtents;
        const double wLeast = centre.w() - half.w();
        const double wGreatest = centre.w() + half.w();
        if (wGreatest <= 0.0) continue;
        std::pair<int, int> across{0, Columns - 1};
        std::pair<int, int> up{0, Rows - 1};
        if (wLeast > 0.0) {
            const auto [left, right] = bounds(centre.x(), half.x(), wLeast, wGreatest);
            const auto [bottom, top] = bounds(centre.y(), half.y(), wLeast, wGreatest);
            if (left > 1.0 || right < -1.0 || bottom > 1.0 || top < -1.0) continue;
            across = cells(left, right, Columns);
            up = cells(bottom, top, Rows);
        }
        for (int row = up.first; row <= up.second; ++row)
            for (int column = across.first; column <= across.second; ++column)
                meet(box, scratch.rays[static_cast<std::size_t>(row * Columns + column)]);
    }
}

} // namespace

void sampleView(const ShadowProblem& problem, const LightImage& image, const FocusRegion& region,
                std::size_t most, ViewSampleScratch& scratch, std::vector<ViewSample>& samples) {
    samples.clear();
    const Mat4 clipFromWorld = problem.viewer.clipFromView * problem.viewer.viewFromWorld;
    const Eigen::RowVector4d depthRow = -problem.viewer.viewFromWorld.row(2);
    const auto inFocus = [&](const Vec2& q) {
        for (std::size_t i = 0; i < region.liHull.size(); ++i) {
            const Vec2& a = region.liHull[i];
            const Vec2& b = region.liHull[(i + 1) % region.liHull.size()];
            if (cross(b - a, q - a) < 0.0) return false;
        }
        return true;
    };
    const auto add = [&](const Vec3& ws, const Vec3& wsNormal) {
        if (problem.viewer.shadowDistance > 0.0 &&
            depthRow.dot(ws.homogeneous()) > problem.viewer.shadowDistance)
            return;
        const Vec3 ls = image.lsFromPoint(ws);
        if (!image.directional() && -ls.z() < problem.light.nearDistance) return;
        const Vec3 lsToLight = image.directional() ? Vec3(0.0, 0.0, 1.0) : Vec3(-ls.normalized());
        if ((image.lsFromWs() * wsNormal).dot(lsToLight) < LeastFacing) return;
        const Vec2 q = image.project(ls);
        if (!inFocus(q)) return;

        // The tangent's motion for a unit step of each device coordinate u = x / w:
        // du = (row x - u row w) . dx / w, with n . dx = 0.
        const Vec4 clip = clipFromWorld * ws.homogeneous();
        Mat3 ndcFromWs;
        ndcFromWs.row(0) =
            (clipFromWorld.row(0) - clip.x() / clip.w() * clipFromWorld.row(3)).head<3>() /
            clip.w();
        ndcFromWs.row(1) =
            (clipFromWorld.row(1) - clip.y() / clip.w() * clipFromWorld.row(3)).head<3>() /
            clip.w();
        ndcFromWs.row(2) = wsNormal.transpose();
        const Mat3 wsFromNdc = ndcFromWs.inverse();
        Eigen::Matrix<double, 2, 3> liFromLs = Eigen::Matrix<double, 2, 3>::Identity();
        if (!image.directional()) {
            // q = xy / -z, so dq = (dxy + q dz) / -z.
            liFromLs.col(2) = q;
            liFromLs /= -ls.z();
        }
        ViewSample sample;
        sample.liPoint = q;
        sample.liFromNdc = liFromLs * image.lsFromWs() * wsFromNdc.leftCols<2>();
        if (sample.liFromNdc.allFinite() && sample.liFromNdc.determinant() != 0.0)
            samples.push_back(sample);
    };

    if (!problem.visiblePoints.empty()) {
        for (const VisiblePoint& point : problem.visiblePoints)
            add(point.ws, point.wsNormal);
    } else {
        traceBoxes(problem, clipFromWorld, scratch);
        for (const ViewSampleScratch::Ray& ray : scratch.rays)
            if (std::isfinite(ray.nearest))
                add(ray.origin + ray.nearest * ray.direction, ray.normal);
    }
    if (samples.size() > most) {
        for (std::size_t i = 0; i < most; ++i)
            samples[i] = samples[i * samples.size() / most];
        samples.resize(most);
    }
}

} // namespace Lixel

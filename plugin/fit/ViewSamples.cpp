#include "fit/ViewSamples.h"

#include "fit/LowDiscrepancy.h"

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

/// One ray through each cell of the picture.
void castRays(const Mat4& clipFromWorld, std::vector<ViewSampleScratch::Ray>& rays) {
    const Mat4 worldFromClip = clipFromWorld.inverse();
    rays.clear();
    for (int row = 0; row < Rows; ++row)
        for (int column = 0; column < Columns; ++column) {
            // Off the middle, so that rays do not line up with rows of objects.
            const Vec2 cell = Vec2(column, row) +
                              lowDiscrepancy(static_cast<std::size_t>(row * Columns + column));
            const double x = 2.0 * cell.x() / Columns - 1.0;
            const double y = 2.0 * cell.y() / Rows - 1.0;
            const Vec4 nearPoint = worldFromClip * Vec4(x, y, -1.0, 1.0);
            const Vec4 farPoint = worldFromClip * Vec4(x, y, 1.0, 1.0);
            const Vec3 origin = nearPoint.head<3>() / nearPoint.w();
            // Also right where the far point is at infinity.
            const Vec3 direction = (farPoint.head<3>() - farPoint.w() * origin).stableNormalized();
            rays.push_back({origin, direction, direction.cwiseInverse(),
                            std::numeric_limits<double>::infinity(), Vec3::Zero()});
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
        std::pair<int, int> across{0, Columns - 1};
        std::pair<int, int> up{0, Rows - 1};
        if (wLeast > 0.0) {
            const auto [left, right] = bounds(centre.x(), half.x(), wLeast, wGreatest);
            const auto [bottom, top] = bounds(centre.y(), half.y(), wLeast, wGreatest);
            if (left > 1.0 || right < -1.0 || bottom > 1.0 || top < -1.0) return;
            across = cells(left, right, Columns);
            up = cells(bottom, top, Rows);
        }
        for (int row = up.first; row <= up.second; ++row)
            for (int column = across.first; column <= across.second; ++column)
                visit(rays[static_cast<std::size_t>(row * Columns + column)]);
    }

private:
    Mat4 mClipFromWorld;
    Mat4 mAbsolute;
};

/// Traces view rays against the receivers: their known surfaces, and the boxes of all others.
void traceReceivers(const ShadowProblem& problem, const Mat4& clipFromWorld,
                    ViewSampleScratch& scratch) {
    castRays(clipFromWorld, scratch.rays);
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
        traceReceivers(problem, clipFromWorld, scratch);
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

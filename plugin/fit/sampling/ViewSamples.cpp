#include "fit/sampling/ViewSamples.h"

#include "fit/focus/ViewVolume.h"
#include "fit/geometry/Multiversion.h"
#include "fit/geometry/Simd.h"
#include "fit/problem/SeenPicture.h"
#include "fit/problem/ShadowPart.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <numeric>

namespace Lixel {
namespace {

/// So many points of a cell that was seen are tried.
constexpr std::size_t PointRounds = 8;
/// Where as many cells as this were seen, rays through the others need not be as many as points.
constexpr std::size_t MostCells = PictureCells::Count * 9 / 10;

/// Least cosine between normal and light.
constexpr double LeastFacing = 0.05;

/// What is asked of every point, prepared for four at once.
struct Judgement {
    bool directional;
    /// Light space from the world: a rotation and an offset.
    std::array<std::array<double, 4>, 3> lsFromWs;
    /// The same of the viewer's clip space from light space: rows x, y and w.
    std::array<std::array<double, 4>, 3> clipFromLs;
    /// Depth in front of the viewer of a light-space point, and how deep shadows reach.
    std::array<double, 4> depthFromLs;
    double greatestDepth;
    double nearDistance;
    /// Distances from the planes around the problem's part, of light-space points.
    std::array<std::array<double, 4>, ShadowPart::MostBounds> boundsFromLs{};
    std::size_t boundCount = 0;
    std::span<const Vec2> liHull;
};

Judgement judgementOf(const ShadowProblem& problem, const LightImage& image,
                      const Polygon2& liHull) {
    Mat4 lsFromWs = Mat4::Identity();
    lsFromWs.topLeftCorner<3, 3>() = image.lsFromWs();
    lsFromWs.topRightCorner<3, 1>() = -image.lsFromWs() * image.wsEye();
    Mat4 wsFromLs = Mat4::Identity();
    wsFromLs.topLeftCorner<3, 3>() = image.lsFromWs().transpose();
    wsFromLs.topRightCorner<3, 1>() = image.wsEye();
    const Mat4 viewFromLs = problem.viewer.viewFromWorld * wsFromLs;
    const Mat4 clipFromLs = problem.viewer.clipFromView * viewFromLs;
    const double distance = problem.viewer.shadowDistance;
    Judgement result{
        .directional = image.directional(),
        .lsFromWs = {parts(lsFromWs.row(0)), parts(lsFromWs.row(1)), parts(lsFromWs.row(2))},
        .clipFromLs = {parts(clipFromLs.row(0)), parts(clipFromLs.row(1)),
                       parts(clipFromLs.row(3))},
        .depthFromLs = parts(-viewFromLs.row(2)),
        .greatestDepth = distance > 0.0 ? distance : std::numeric_limits<double>::infinity(),
        .nearDistance = problem.light.nearDistance,
        .liHull = liHull};
    if (problem.part != nullptr)
        for (const HalfSpace& plane : problem.part->bounds()) {
            const Vec4 row(plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.offset);
            result.boundsFromLs[result.boundCount++] = parts(row.transpose() * wsFromLs);
        }
    return result;
}

/// Points and their normals, in the world. So many at a time that none is read back in fours while
/// it is still being written one by one, which the processor would wait for.
constexpr std::size_t BatchSize = 16;
struct Points {
    std::array<std::array<double, BatchSize>, 3> ws;
    std::array<std::array<double, BatchSize>, 3> wsNormal;
};

struct FourSamples {
    std::array<double, 4> vsDepth;
    std::array<double, 4> lsDepth;
    std::array<std::array<double, 4>, 2> liPoint;
    /// d(device x, y) / d(light image x, y), by rows.
    std::array<std::array<double, 4>, 4> ndcFromLi;
};

[[gnu::always_inline]] inline void apply(const std::array<double, 4>& row, const FourVectors& x,
                                         Four& result) {
    result = (row[0] * x[0] + row[1] * x[1]) + (row[2] * x[2] + row[3]);
}

[[gnu::always_inline]] inline void turn(const std::array<double, 4>& row, const FourVectors& x,
                                        Four& result) {
    result = (row[0] * x[0] + row[1] * x[1]) + row[2] * x[2];
}

/** Makes samples of four points.
    @return as bits, the lanes of points that face the light and can be in shadow there */
LIXEL_MULTIVERSION
unsigned judge(const Judgement& judgement, const Points& points, std::size_t first,
               FourSamples& samples) {
    FourVectors ws;
    FourVectors wsNormal;
    FourVectors ls;
    FourVectors normal;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        load(&points.ws[axis][first], ws[axis]);
        load(&points.wsNormal[axis][first], wsNormal[axis]);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        apply(judgement.lsFromWs[axis], ws, ls[axis]);
        turn(judgement.lsFromWs[axis], wsNormal, normal[axis]);
    }
    // The ray of light that meets the point, as far as it goes per unit of depth along the light;
    // how that depth scales the light image; and the cosine between it and the normal.
    const Four zero{};
    FourVectors ray = {zero, zero, zero - 1.0};
    Four scale = zero + 1.0;
    FourMask good;
    if (judgement.directional) {
        good = normal[2] >= LeastFacing;
    } else {
        scale = -ls[2];
        good = scale >= judgement.nearDistance;
        ray[0] = ls[0] / scale;
        ray[1] = ls[1] / scale;
        const Four facing = -(normal[0] * ray[0] + normal[1] * ray[1] - normal[2]);
        const Four squared = ray[0] * ray[0] + ray[1] * ray[1] + 1.0;
        good &= (facing > 0.0) & (facing * facing >= LeastFacing * LeastFacing * squared);
    }
    Four depth;
    apply(judgement.depthFromLs, ls, depth);
    good &= depth <= judgement.greatestDepth;
    for (std::size_t i = 0; i < judgement.boundCount; ++i) {
        Four distance;
        apply(judgement.boundsFromLs[i], ls, distance);
        good &= distance >= 0.0;
    }
    const Four x = judgement.directional ? ls[0] : ray[0];
    const Four y = judgement.directional ? ls[1] : ray[1];
    Vec2 from = judgement.liHull.back();
    for (const Vec2& to : judgement.liHull) {
        const double edgeX = to.x() - from.x();
        const double edgeY = to.y() - from.y();
        good &= edgeX * (y - from.y()) - edgeY * (x - from.x()) >= 0.0;
        from = to;
    }
    const unsigned lanes = bitsOf(good);
    if (lanes == 0) return 0;

    // How the viewer's u = x / w changes with the point: (row x - u row w) / w.
    FourVectors clip;
    for (std::size_t i = 0; i < 3; ++i)
        apply(judgement.clipFromLs[i], ls, clip[i]);
    const Four inverse = 1.0 / clip[2];
    std::array<FourVectors, 2> gradient;
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            gradient[i][k] =
                (judgement.clipFromLs[i][k] - clip[i] * inverse * judgement.clipFromLs[2][k]) *
                inverse;
    // A step in the light image moves the point across, and along its ray back to the tangent
    // plane.
    const Four along = 1.0 / (normal[0] * ray[0] + normal[1] * ray[1] + normal[2] * ray[2]);
    std::array<Four, 4> ndcFromLi;
    Four sum = zero;
    for (std::size_t i = 0; i < 2; ++i) {
        const Four alongRay =
            gradient[i][0] * ray[0] + gradient[i][1] * ray[1] + gradient[i][2] * ray[2];
        for (std::size_t k = 0; k < 2; ++k) {
            ndcFromLi[2 * i + k] = scale * (gradient[i][k] - alongRay * (normal[k] * along));
            sum += ndcFromLi[2 * i + k] * 0.0;
            store(ndcFromLi[2 * i + k], samples.ndcFromLi[2 * i + k].data());
        }
    }
    store(depth, samples.vsDepth.data());
    store(-ls[2], samples.lsDepth.data());
    store(x, samples.liPoint[0].data());
    store(y, samples.liPoint[1].data());
    const Four determinant = ndcFromLi[0] * ndcFromLi[3] - ndcFromLi[1] * ndcFromLi[2];
    // What is not finite made the sum not a number.
    return lanes & bitsOf((sum == 0.0) & (determinant != 0.0));
}

/// Collects samples of points until there are enough.
class Collector {
public:
    Collector(const Judgement& judgement, std::size_t wanted, std::vector<ViewSample>& samples)
        : mJudgement(judgement), mWanted(wanted), mSamples(samples) {
        samples.clear();
    }

    bool complete() const { return mSamples.size() >= mWanted; }
    std::size_t count() const { return mSamples.size(); }
    void want(std::size_t samples) { mWanted = samples; }

    void add(const VisiblePoint& point) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            mPoints.ws[axis][mCount] = point.ws[static_cast<Eigen::Index>(axis)];
            mPoints.wsNormal[axis][mCount] = point.wsNormal[static_cast<Eigen::Index>(axis)];
        }
        if (++mCount == BatchSize) flush();
    }

    /// Makes samples of what is left.
    void flush() {
        for (std::size_t first = 0; first < mCount && !complete(); first += 4)
            addFour(first);
        mCount = 0;
    }

private:
    void addFour(std::size_t first) {
        FourSamples samples;
        const unsigned lanes = judge(mJudgement, mPoints, first, samples);
        for (std::size_t lane = 0; first + lane < mCount && lane < 4 && !complete(); ++lane) {
            if ((lanes >> lane & 1) == 0) continue;
            ViewSample& sample = mSamples.emplace_back();
            sample.vsDepth = samples.vsDepth[lane];
            sample.lsDepth = samples.lsDepth[lane];
            sample.liPoint = {samples.liPoint[0][lane], samples.liPoint[1][lane]};
            sample.ndcFromLi << samples.ndcFromLi[0][lane], samples.ndcFromLi[1][lane],
                samples.ndcFromLi[2][lane], samples.ndcFromLi[3][lane];
        }
    }

    const Judgement& mJudgement;
    std::size_t mWanted;
    std::vector<ViewSample>& mSamples;
    Points mPoints{};
    std::size_t mCount = 0;
};

/// Calls `visit` with each index below `count`, in an order whose every beginning is spread
/// evenly, until it returns false.
template <typename Visit>
void visitSpread(std::size_t count, const Visit& visit) {
    if (count == 0) return;
    // Steps by the golden section leave the most even gaps; without a common divisor they come by
    // every index.
    constexpr double Golden = 0.6180339887498949;
    auto step = static_cast<std::size_t>(Golden * static_cast<double>(count));
    while (std::gcd(step, count) > 1)
        ++step;
    for (std::size_t i = 0, at = 0; i < count && visit(at); ++i) {
        at += step;
        if (at >= count) at -= count;
    }
}

/// Whether all rays of the view go through view space's origin, where x, y and w of clip space are
/// 0: as a rule, but not those of an orthographic projection.
bool isFromOrigin(const ShadowViewer& viewer) {
    const Mat4& clip = viewer.clipFromView;
    return clip(0, 3) == 0.0 && clip(1, 3) == 0.0 && clip(3, 3) == 0.0;
}

/// Adds the discs of known surfaces in the world, except those that turn their backs to the viewer.
void placeDiscs(std::span<const KnownSurface> surfaces, const ShadowViewer& viewer,
                std::vector<Surfel>& discs) {
    if (surfaces.empty()) return;
    const bool mayFaceAway = isFromOrigin(viewer);
    const Vec3 wsEye = mayFaceAway ? wsEyeOf(viewer) : Vec3(Vec3::Zero());
    for (const KnownSurface& surface : surfaces) {
        const Mat3 linear = surface.wsFromCloud.linear();
        // Normals turn with the inverse transpose; discs are as large as the body's volume scales.
        const Mat3 turned = linear.inverse().transpose();
        const double scale = std::cbrt(std::abs(linear.determinant()));
        for (const Surfel& own : surface.cloud->surfels) {
            const Vec3 centre = surface.wsFromCloud * own.centre;
            const Vec3 normal = turned * own.normal;
            if (mayFaceAway && normal.dot(wsEye - centre) < 0.0) continue;
            discs.push_back({centre, normal.stableNormalized(), scale * own.radius});
        }
    }
}

/// Sends one round's rays as far as what they meet first.
void castRound(const Mat4& clipFromWorld, std::size_t round, const BoxSet& boxes,
               std::span<const KnownSurface> surfaces, SampleScratch& scratch) {
    scratch.rays.cast(clipFromWorld, round);
    scratch.rays.meet(boxes, surfaces);
    scratch.rays.meet(scratch.discs);
}

/// Collects what an earlier frame showed, or else what view rays see of the receivers: of their
/// known surfaces, and of the boxes of all others.
void traceReceivers(const ShadowProblem& problem, const LightImage& image,
                    const BoxSet& receiversInView, std::size_t enough, SampleScratch& scratch,
                    Collector& collector) {
    const Mat4 clipFromWorld =
        withDepthAhead(problem.viewer.clipFromView) * problem.viewer.viewFromWorld;
    const SeenPicture* const seen = problem.seen;
    const bool traces = seen == nullptr || seen->known() < PictureCells::Count;
    scratch.discs.clear();
    if (traces) placeDiscs(problem.surfaces, problem.viewer, scratch.discs);
    // What is in view but not lit, or in another map's part, hides what is: a directional light
    // without parts has neither.
    const bool allLit = image.directional() && problem.part == nullptr && problem.surfaces.empty();
    const BoxSet& boxes = allLit ? receiversInView : *problem.receivers;
    const Vec3 towards = image.lsFromWs().row(2);
    ViewRays& rays = scratch.rays;
    const bool isSeen = seen != nullptr && seen->known() >= MostCells;
    const std::size_t rounds = isSeen ? PointRounds : ViewRays::Rounds;
    for (std::size_t round = 0; round < rounds && !collector.complete(); ++round) {
        const bool casts =
            traces && (round == 0 || (round < ViewRays::Rounds && collector.count() < enough));
        if (casts) castRound(clipFromWorld, round, boxes, problem.surfaces, scratch);
        visitSpread(ViewRays::Count, [&](std::size_t i) {
            if (seen != nullptr && seen->isKnown(i)) {
                if (const SeenPicture::Point* const point =
                        seen->nearest(i, ViewRays::placeOf(i, round)))
                    collector.add(point->point);
                return !collector.complete();
            }
            if (!casts) return true;
            // Many points face away from a directional light: they need not be found.
            if (!rays.hit(i) || (image.directional() && rays.facing(i, towards) < LeastFacing))
                return true;
            collector.add(rays.point(i));
            return !collector.complete();
        });
        collector.flush();
        // Rays that meet bodies take time, points that are known do not.
        if (!isSeen) collector.want(enough);
    }
}

} // namespace

void traceView(const ShadowViewer& viewer, const BoxSet& boxes,
               std::span<const KnownSurface> surfaces, std::span<const KnownSurface> others,
               SampleScratch& scratch, std::vector<VisiblePoint>& points) {
    const Mat4 clipFromWorld = withDepthAhead(viewer.clipFromView) * viewer.viewFromWorld;
    scratch.discs.clear();
    placeDiscs(surfaces, viewer, scratch.discs);
    placeDiscs(others, viewer, scratch.discs);
    points.clear();
    for (std::size_t round = 0; round < ViewRays::Rounds; ++round) {
        castRound(clipFromWorld, round, boxes, surfaces, scratch);
        for (std::size_t i = 0; i < ViewRays::Count; ++i)
            points.push_back(scratch.rays.hit(i) ? scratch.rays.point(i)
                                                 : VisiblePoint{Vec3::Zero(), Vec3::Zero()});
    }
}

void sampleView(const ShadowProblem& problem, const LightImage& image, const Polygon2& liHull,
                const BoxSet& receiversInView, const SampleCount& count, SampleScratch& scratch,
                std::vector<ViewSample>& samples) {
    const Judgement judgement = judgementOf(problem, image, liHull);
    Collector collector(judgement, count.most, samples);
    const std::span<const VisiblePoint> points = problem.visiblePoints;
    if (points.empty())
        return traceReceivers(problem, image, receiversInView, count.enough, scratch, collector);
    visitSpread(points.size(), [&](std::size_t i) {
        collector.add(points[i]);
        return !collector.complete();
    });
    collector.flush();
}

} // namespace Lixel

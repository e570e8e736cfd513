// How many samples of the view there are, and how they come and go.
#include "fit/Problems.h"

#include "fit/core/FitState.h"
#include "fit/focus/ViewVolume.h"
#include "fit/problem/SeenPicture.h"
#include "fit/technique/Uniform.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/LU>

#include <algorithm>
#include <limits>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

constexpr std::size_t Most = 64;
constexpr std::size_t Enough = 32;

/// A wall across the view, in the light of a sun behind the viewer, that fills a part of the
/// picture's width and of its height.
std::vector<ViewSample> samplesOfWall(double width, double height) {
    constexpr double Distance = 20.0;
    Scene scene;
    scene.viewer.clipFromView = perspective(1.0, 1.5, 0.1, 100.0);
    scene.light.wsDirection = Vec3(0.0, 0.0, -1.0);
    const double tangent = std::tan(0.5);
    const Vec3 half(Distance * 1.5 * tangent * width, Distance * tangent * height, 0.0);
    scene.receivers.add({Vec3(0.0, 0.0, -Distance), half});
    scene.casters.add({Vec3(0.0, 0.0, 10.0), Vec3(100.0, 100.0, 1.0)});
    return samplesOf(scene.problem(), {.most = Most, .enough = Enough});
}

/// How many of `a` are not among `b`.
std::size_t countOthers(const std::vector<ViewSample>& a, const std::vector<ViewSample>& b) {
    return static_cast<std::size_t>(std::ranges::count_if(a, [&](const ViewSample& sample) {
        return std::ranges::none_of(b, [&](const ViewSample& other) {
            return (sample.liPoint - other.liPoint).norm() < 1e-9;
        });
    }));
}

} // namespace

TEST(ViewSamples, AreAsManyAsWantedOfWhatFillsThePicture) {
    EXPECT_EQ(samplesOfWall(1.1, 1.1).size(), Most);
    EXPECT_EQ(samplesOfWall(0.7, 0.7).size(), Most);
}

TEST(ViewSamples, AreEnoughOfWhatFillsATenth) {
    EXPECT_EQ(samplesOfWall(0.32, 0.32).size(), Enough);
    // One round of rays finds more.
    const std::size_t found = samplesOfWall(0.5, 0.5).size();
    EXPECT_GT(found, Enough);
    EXPECT_LT(found, Most);
    // Of a hundredth, two rounds of 180 rays find as many as there are.
    EXPECT_EQ(samplesOfWall(0.1, 0.1).size(), 4U);
    EXPECT_EQ(samplesOfWall(1.0, 0.0).size(), 0U);
}

TEST(ViewSamples, ComeAndGoFewAtATime) {
    std::vector<ViewSample> last = samplesOfWall(0.2, 0.5);
    std::size_t most = 0;
    for (double width = 0.2; width < 0.9; width += 0.0005) {
        const std::vector<ViewSample> samples = samplesOfWall(width, 0.5);
        most = std::max(most, countOthers(samples, last) + countOthers(last, samples));
        last = samples;
    }
    EXPECT_LE(most, 4U);
    EXPECT_GT(last.size(), Enough);
}

namespace {

/// A wall that was seen nearer than the receivers' box says, in the picture's left half; the right
/// half was not seen.
SeenPicture seenLeftOf(double ndcEnd, double distance) {
    SeenSurfaces seen;
    constexpr std::size_t Across = 3 * PictureCells::Columns;
    constexpr std::size_t Up = 3 * PictureCells::Rows;
    for (std::size_t i = 0; i < Across * Up; ++i) {
        const Vec2 ndc(2.0 * (static_cast<double>(i % Across) + 0.5) / Across - 1.0,
                       2.0 * (static_cast<double>(i / Across) + 0.5) / Up - 1.0);
        if (ndc.x() > ndcEnd) continue;
        const Vec3 ahead(1.5 * std::tan(0.5) * ndc.x(), std::tan(0.5) * ndc.y(), -1.0);
        seen.points.push_back({distance * ahead, Vec3::UnitZ()});
    }
    ShadowViewer viewer;
    viewer.clipFromView = perspective(1.0, 1.5, 0.1, 100.0);
    SeenPicture picture;
    picture.take(seen, viewer, Vec3::Zero());
    return picture;
}

std::vector<ViewSample> samplesOfSeenWall(const SeenPicture* seen) {
    Scene scene;
    scene.viewer.clipFromView = perspective(1.0, 1.5, 0.1, 100.0);
    scene.light.wsDirection = Vec3(0.0, 0.0, -1.0);
    scene.receivers.add({Vec3(0.0, 0.0, -20.0), Vec3(100.0, 100.0, 10.0)});
    scene.casters.add({Vec3(0.0, 0.0, 10.0), Vec3(100.0, 100.0, 1.0)});
    ShadowProblem problem = scene.problem();
    problem.seen = seen;
    return samplesOf(problem, {.most = Most, .enough = Enough});
}

} // namespace

TEST(ViewSamples, AreWhatWasSeenWhereThatIsKnown) {
    const SeenPicture all = seenLeftOf(1.0, 15.0);
    const std::vector<ViewSample> samples = samplesOfSeenWall(&all);
    EXPECT_EQ(samples.size(), Most);
    for (const ViewSample& sample : samples)
        EXPECT_NEAR(sample.vsDepth, 15.0, 1e-9);
}

TEST(ViewSamples, AreWhatRaysSeeOfTheRest) {
    const SeenPicture half = seenLeftOf(0.0, 15.0);
    const std::vector<ViewSample> samples = samplesOfSeenWall(&half);
    const auto near = std::ranges::count_if(
        samples, [](const ViewSample& sample) { return std::abs(sample.vsDepth - 15.0) < 1e-9; });
    const auto box = std::ranges::count_if(
        samples, [](const ViewSample& sample) { return std::abs(sample.vsDepth - 10.0) < 1e-9; });
    EXPECT_EQ(near + box, static_cast<std::ptrdiff_t>(samples.size()));
    // Each half of the picture has its share.
    EXPECT_NEAR(static_cast<double>(near), static_cast<double>(samples.size()) / 2.0, 3.0);
}

TEST(ViewSamples, OfAPictureThatKnowsNothingAreThoseOfRays) {
    SeenPicture cut;
    cut.clear();
    const std::vector<ViewSample> rays = samplesOfSeenWall(nullptr);
    const std::vector<ViewSample> samples = samplesOfSeenWall(&cut);
    ASSERT_EQ(samples.size(), rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(samples[i].liPoint, rays[i].liPoint);
        EXPECT_EQ(samples[i].vsDepth, rays[i].vsDepth);
    }
}

TEST(TraceView, GivesAPointOrNoneForEachRay) {
    Scene scene;
    scene.viewer.clipFromView = perspective(1.0, 1.5, 0.1, 100.0);
    scene.receivers.add({Vec3(0.0, 0.0, -20.0), Vec3(5.0, 5.0, 0.0)});
    SampleScratch scratch;
    std::vector<VisiblePoint> points;
    traceView(scene.viewer, scene.receivers, {}, {}, scratch, points);
    ASSERT_EQ(points.size(), ViewRays::Rounds * ViewRays::Count);
    const auto met = [&] {
        return static_cast<double>(std::ranges::count_if(
            points, [](const VisiblePoint& point) { return !point.wsNormal.isZero(0.0); }));
    };
    // As many as the wall fills of the picture.
    const double tangent = std::tan(0.5);
    const double share = 0.25 / tangent * 0.25 / (1.5 * tangent);
    EXPECT_NEAR(met() / static_cast<double>(points.size()), share, 0.03);
    for (const VisiblePoint& point : points) {
        if (point.wsNormal.isZero(0.0)) continue;
        EXPECT_NEAR(point.ws.z(), -20.0, 1e-9);
        EXPECT_EQ(point.wsNormal, Vec3::UnitZ());
    }

    // A surface is met instead of its box, and one that has no box too.
    SurfaceCloud cloud;
    cloud.surfels.push_back({Vec3::Zero(), Vec3::UnitZ(), 1.0});
    KnownSurface surface{.receiver = 0, .cloud = &cloud};
    surface.wsFromCloud.translation() = Vec3(0.0, 0.0, -10.0);
    const double ofBox = met();
    traceView(scene.viewer, scene.receivers, {&surface, 1}, {}, scratch, points);
    EXPECT_GT(met(), 0.0);
    EXPECT_LT(met(), ofBox);
    for (const VisiblePoint& point : points) {
        if (!point.wsNormal.isZero(0.0)) {
            EXPECT_NEAR(point.ws.z(), -10.0, 1e-9);
        }
    }
    traceView(scene.viewer, scene.receivers, {}, {&surface, 1}, scratch, points);
    EXPECT_EQ(met(), ofBox);
    EXPECT_TRUE(std::ranges::any_of(
        points, [](const VisiblePoint& point) { return std::abs(point.ws.z() + 10.0) < 1e-9; }));
}

RC_GTEST_PROP(TraceView, MeetsTheFirstDiscThatFacesTheViewer, ()) {
    const Scene scene = *anyScene();
    const Mat4 clipFromWorld =
        withDepthAhead(scene.viewer.clipFromView) * scene.viewer.viewFromWorld;
    RC_PRE(std::abs(clipFromWorld.determinant()) > 0.0);
    Dice dice(*anySeed());
    // Around the middle of the view.
    const Vec3 middle = eyeOf(scene.viewer) + 5.0 * forwardOf(scene.viewer);
    SurfaceCloud cloud;
    for (int i = 0; i < 60; ++i)
        cloud.surfels.push_back({middle + 4.0 * dice.cube(), dice.direction(), dice.in(0.1, 2.0)});
    const KnownSurface surface{.receiver = 0, .cloud = &cloud};
    SampleScratch scratch;
    std::vector<VisiblePoint> points;
    traceView(scene.viewer, BoxSet(), {}, {&surface, 1}, scratch, points);
    const Mat4 worldFromClip = clipFromWorld.inverse();
    for (std::size_t i = 0; i < points.size(); ++i) {
        scratch.rays.cast(clipFromWorld, i / ViewRays::Count);
        const Vec2 ndc = scratch.rays.ndc(i % ViewRays::Count);
        const Vec4 nearPoint = worldFromClip * Vec4(ndc.x(), ndc.y(), -1.0, 1.0);
        const Vec4 farPoint = worldFromClip * Vec4(ndc.x(), ndc.y(), 1.0, 1.0);
        const Vec3 origin = nearPoint.hnormalized();
        const Vec3 direction = farPoint.head<3>() - farPoint.w() * origin;
        double nearest = std::numeric_limits<double>::infinity();
        bool isClose = false; // to a disc's rim or plane: rounding decides
        for (const Surfel& disc : cloud.surfels) {
            const double towards = -direction.dot(disc.normal);
            const double t = (origin - disc.centre).dot(disc.normal) / towards;
            const double across = (origin + t * direction - disc.centre).norm();
            isClose = isClose || std::abs(across - disc.radius) < 1e-6 ||
                      std::abs(towards) < 1e-6 * direction.norm();
            if (towards > 0.0 && t >= 0.0 && across <= disc.radius) nearest = std::min(nearest, t);
        }
        if (isClose) continue;
        RC_ASSERT(points[i].wsNormal.isZero(0.0) == !std::isfinite(nearest));
        if (!std::isfinite(nearest)) continue;
        const Vec3 expected = origin + nearest * direction;
        RC_ASSERT((points[i].ws - expected).norm() < 1e-6);
    }
}

RC_GTEST_PROP(TraceView, SamplesTheSameAsAFitDoes, ()) {
    // All that both rounds of rays find.
    const Scene scene = *anyScene();
    const ShadowProblem problem = scene.problem();
    FitState state;
    RC_PRE(fitMap(problem, UniformOptions{}, state).hasMap());
    const SampleCount all{.most = 1000, .enough = 1000};
    const std::vector<ViewSample> own = samplesOf(problem, all);
    SampleScratch scratch;
    std::vector<VisiblePoint> points;
    // A fit for a sun asks nothing that is out of view.
    const bool isSun = problem.light.kind == LightKind::Directional;
    traceView(problem.viewer, isSun ? state.region.receiversInView : *problem.receivers,
              problem.surfaces, {}, scratch, points);
    ShadowProblem given = problem;
    given.visiblePoints = points;
    const std::vector<ViewSample> traced = samplesOf(given, all);
    RC_ASSERT(traced.size() == own.size());
    double size = 0.0;
    for (const ViewSample& sample : own)
        size = std::max(size, sample.liPoint.norm());
    for (const ViewSample& sample : own)
        RC_ASSERT(std::ranges::any_of(traced, [&](const ViewSample& other) {
            return (sample.liPoint - other.liPoint).norm() <= 1e-9 * size &&
                   sample.ndcFromLi.isApprox(other.ndcFromLi, 1e-6);
        }));
}

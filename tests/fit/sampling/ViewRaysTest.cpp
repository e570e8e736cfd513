// View rays, tried many at once, against one ray and one box at a time.
#include "fit/Oracle.h"

#include "fit/sampling/ViewRays.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/LU>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

/// Where the ray through a point of the picture starts and goes.
std::pair<Vec3, Vec3> rayThrough(const Vec2& ndc, const Mat4& worldFromClip) {
    const Vec4 nearPoint = worldFromClip * Vec4(ndc.x(), ndc.y(), -1.0, 1.0);
    const Vec4 farPoint = worldFromClip * Vec4(ndc.x(), ndc.y(), 1.0, 1.0);
    const Vec3 origin = nearPoint.head<3>() / nearPoint.w();
    return {origin, farPoint.head<3>() - farPoint.w() * origin};
}

/// The ray's first way into a box, or out of one it starts in; infinite without.
double firstHit(const Scene& scene, const Vec3& origin, const Vec3& direction,
                std::size_t without) {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t index = 0;
    for (const Aabb& box : scene.receivers.boxes()) {
        if (index++ == without) continue;
        const auto hit = rayInBox(box, origin, direction);
        if (!hit || hit->end < 0.0) continue;
        nearest = std::min(nearest, hit->begin > 0.0 ? hit->begin : hit->end);
    }
    return nearest;
}

} // namespace

RC_GTEST_PROP(ViewRays, MeetWhatEachRayMeetsFirst, ()) {
    const Scene scene = *anyScene();
    const Mat4 clipFromWorld = scene.viewer.clipFromView * scene.viewer.viewFromWorld;
    RC_PRE(std::abs(clipFromWorld.determinant()) > 0.0);
    const Mat4 worldFromClip = clipFromWorld.inverse();
    // One receiver's surface is known, and its box no surface then.
    Dice dice(*anySeed());
    const std::size_t known = dice.below(scene.receivers.size() + 1);
    const KnownSurface surface{.receiver = known};
    ViewRays rays;
    rays.cast(clipFromWorld, dice.below(ViewRays::Rounds));
    rays.meet(scene.receivers,
              known < scene.receivers.size() ? std::span(&surface, 1) : std::span(&surface, 0));
    for (std::size_t ray = 0; ray < ViewRays::Count; ++ray) {
        const Vec2 ndc = rays.ndc(ray);
        RC_ASSERT(ndc.cwiseAbs().maxCoeff() <= 1.0);
        const auto [origin, direction] = rayThrough(ndc, worldFromClip);
        const double nearest = firstHit(scene, origin, direction, known);
        // A ray along a box' face may meet it or not.
        double wider = nearest;
        if (rays.hit(ray) != std::isfinite(nearest)) {
            Scene shrunk = scene;
            shrunk.receivers.clear();
            for (const Aabb& box : scene.receivers.boxes())
                shrunk.receivers.add({box.centre, (1.0 - 1e-9) * box.halfExtents});
            wider = firstHit(shrunk, origin, direction, known);
            RC_ASSERT(rays.hit(ray) == std::isfinite(wider));
        }
        if (!rays.hit(ray)) continue;
        const VisiblePoint point = rays.point(ray);
        const Vec3 expected = origin + wider * direction;
        RC_LOG() << "ray " << ray << " met " << point.ws.transpose() << " instead of "
                 << expected.transpose() << "\n";
        RC_ASSERT((point.ws - expected).norm() <=
                  1e-6 * (expected - origin).norm() + 1e-9 * scene.size);
        // Faces are seen from their front, or from within.
        RC_ASSERT(point.wsNormal.norm() == 1.0);
        RC_ASSERT(point.wsNormal.dot(direction) <= 0.0);
    }
}

RC_GTEST_PROP(ViewRays, MeetTheNearestDiscThatFacesThem, ()) {
    const Scene scene = *anyScene();
    const Mat4 clipFromWorld = scene.viewer.clipFromView * scene.viewer.viewFromWorld;
    RC_PRE(std::abs(clipFromWorld.determinant()) > 0.0);
    const Mat4 worldFromClip = clipFromWorld.inverse();
    Dice dice(*anySeed());
    std::vector<Surfel> discs;
    for (std::size_t count = dice.below(12); discs.size() < count;)
        discs.push_back({eyeOf(scene.viewer) + scene.size * (forwardOf(scene.viewer) + dice.cube()),
                         dice.direction(), scene.size * dice.in(0.0, 0.5)});
    ViewRays rays;
    rays.cast(clipFromWorld, dice.below(ViewRays::Rounds));
    rays.meet(discs);
    for (std::size_t ray = 0; ray < ViewRays::Count; ++ray) {
        const Vec2 ndc = rays.ndc(ray);
        const auto [origin, direction] = rayThrough(ndc, worldFromClip);
        double nearest = std::numeric_limits<double>::infinity();
        const Surfel* met = nullptr;
        bool unsure = false;
        for (const Surfel& disc : discs) {
            const double towards = -direction.dot(disc.normal);
            const double t = (origin - disc.centre).dot(disc.normal) / towards;
            const double beside = (origin + t * direction - disc.centre).norm();
            // Rounding decides at the rim, and at an edge that is seen from the side.
            unsure |= std::abs(beside - disc.radius) < 1e-6 * scene.size ||
                      std::abs(towards) < 1e-6 * direction.norm();
            if (!(towards > 0.0 && t >= 0.0 && t < nearest && beside <= disc.radius)) continue;
            nearest = t;
            met = &disc;
        }
        if (unsure) continue;
        RC_ASSERT(rays.hit(ray) == (met != nullptr));
        if (met == nullptr) continue;
        const VisiblePoint point = rays.point(ray);
        RC_ASSERT(point.wsNormal == met->normal);
        RC_ASSERT((point.ws - origin - nearest * direction).norm() <=
                  1e-9 * (nearest * direction.norm() + scene.size));
    }
}

TEST(ViewRays, OfTheNextRoundGoThroughOtherPointsOfTheSameCells) {
    const Mat4 clipFromWorld = perspective(1.0, 1.5, 0.1, 100.0);
    ViewRays first;
    ViewRays second;
    first.cast(clipFromWorld, 0);
    second.cast(clipFromWorld, 1);
    const Vec2 cells(ViewRays::Columns, ViewRays::Rows);
    for (std::size_t ray = 0; ray < ViewRays::Count; ++ray) {
        const Vec2 a = (first.ndc(ray).array() + 1.0) / 2.0 * cells.array();
        const Vec2 b = (second.ndc(ray).array() + 1.0) / 2.0 * cells.array();
        EXPECT_EQ(a.array().floor().matrix(), b.array().floor().matrix());
        EXPECT_NEAR((a - b).cwiseAbs().minCoeff(), 0.5, 1e-9);
        EXPECT_NEAR((a - b).cwiseAbs().maxCoeff(), 0.5, 1e-9);
    }
}

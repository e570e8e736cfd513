#include "Oracle.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>

namespace Lixel::Test {
namespace {

/// What a point must be away from an occluder to be shadowed by it, relative to the scene's size:
/// a body's own lit face is not shadowed by the body.
constexpr double Contact = 1e-7;

/// The bodies of a set: boxes, some of them turned.
struct Bodies {
    const BoxSet& boxes;
    const TurnedBoxes& turned;

    std::size_t size() const { return boxes.size(); }

    std::optional<Interval> meet(std::size_t index, const Vec3& origin,
                                 const Vec3& direction) const {
        const TurnedBox* const body = turned.find(index);
        if (body == nullptr) return rayInBox(boxes.box(index), origin, direction);
        const Mat3 back = body->turn.transpose();
        return rayInBox({Vec3::Zero(), body->box.halfExtents}, back * (origin - body->box.centre),
                        back * direction);
    }

    /// Calls `visit` for each part of a ray on which a relief's surface may be.
    template <typename Visit>
    void meetCells(std::size_t index, const Vec3& origin, const Vec3& direction,
                   const Visit& visit) const {
        const ConvexBox* const body = turned.findRelief(index);
        if (body == nullptr) return;
        const Transform3 bodyFromWs = body->around.wsFromBody.inverse();
        const Vec3 from = bodyFromWs * origin;
        const Vec3 along = bodyFromWs.linear() * direction;
        for (const ReliefCell& cell : body->relief->cells)
            if (const auto hit = rayInBox(boxOf(cell), from, along)) visit(*hit);
    }

    /// The point of a body that is at `at` in the cube -1 to 1.
    Vec3 point(std::size_t index, const Vec3& at) const {
        const TurnedBox* const body = turned.find(index);
        const Aabb box = body != nullptr ? body->box : boxes.box(index);
        const Vec3 offset = at.cwiseProduct(box.halfExtents);
        return box.centre + (body != nullptr ? Vec3(body->turn * offset) : offset);
    }
};

Bodies castersOf(const Scene& scene) {
    return {scene.casters, scene.turnedCasters};
}

Bodies receiversOf(const Scene& scene) {
    return {scene.receivers, scene.turnedReceivers};
}

/// A point of a body, often near one of its corners, where the borders of shadows come from.
Vec3 pointOf(const Bodies& bodies, std::size_t index, Dice& dice) {
    Vec3 at = dice.cube();
    if (dice.chance(0.7)) at = at.cwiseSign();
    constexpr double JustInside = 1.0 - 1e-6;
    return bodies.point(index, JustInside * at);
}

/// A point of a receiver.
struct ReceiverPoint {
    std::size_t receiver;
    Vec3 ws;
};

void appendHits(const Bodies& receivers, const Vec3& origin, const Vec3& direction,
                std::vector<ReceiverPoint>& points) {
    const auto append = [&](std::size_t receiver, double at) {
        if (at > 0.0) points.push_back({receiver, origin + at * direction});
    };
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        if (const auto hit = receivers.meet(i, origin, direction)) {
            append(i, hit->begin);
            append(i, hit->end);
        }
        receivers.meetCells(i, origin, direction,
                            [&](const Interval& hit) { append(i, (hit.begin + hit.end) / 2.0); });
    }
}

std::vector<ReceiverPoint> visibleReceiverPoints(const Scene& scene, Dice& dice, std::size_t rays) {
    std::vector<ReceiverPoint> points;
    const Bodies receivers = receiversOf(scene);
    // Rays of the view. Clip depths -1 and 0 are finite without a far plane too.
    const Mat4 worldFromClip =
        scene.viewer.viewFromWorld.inverse() * scene.viewer.clipFromView.inverse();
    for (std::size_t i = 0; i < rays; ++i) {
        const double x =
            dice.chance(0.2) ? std::copysign(1.0 - 1e-9, dice.in(-1.0, 1.0)) : dice.in(-1.0, 1.0);
        const double y =
            dice.chance(0.2) ? std::copysign(1.0 - 1e-9, dice.in(-1.0, 1.0)) : dice.in(-1.0, 1.0);
        const Vec3 begin = (worldFromClip * Vec4(x, y, -1.0, 1.0)).hnormalized();
        const Vec3 end = (worldFromClip * Vec4(x, y, 0.0, 1.0)).hnormalized();
        appendHits(receivers, begin, end - begin, points);
    }
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        Vec3 at = dice.cube().cwiseSign();
        if (dice.chance(0.5)) at[static_cast<Eigen::Index>(dice.below(3))] = dice.in(-1.0, 1.0);
        points.push_back({i, receivers.point(i, at)});
    }
    std::erase_if(points, [&](const ReceiverPoint& p) { return !sees(scene.viewer, p.ws); });
    return points;
}

} // namespace

std::optional<Interval> rayInBox(const Aabb& box, const Vec3& origin, const Vec3& direction) {
    Interval hit{-Infinity, Infinity};
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const double middle = box.centre[axis] - origin[axis];
        const double half = box.halfExtents[axis];
        if (direction[axis] == 0.0) {
            if (std::abs(middle) > half) return std::nullopt;
            continue;
        }
        const double a = (middle - half) / direction[axis];
        const double b = (middle + half) / direction[axis];
        hit.begin = std::max(hit.begin, std::min(a, b));
        hit.end = std::min(hit.end, std::max(a, b));
    }
    if (hit.begin > hit.end) return std::nullopt;
    return hit;
}

bool sees(const ShadowViewer& viewer, const Vec3& ws) {
    const Vec4 view = viewer.viewFromWorld * ws.homogeneous();
    const Vec4 clip = viewer.clipFromView * view;
    if (clip.head<3>().cwiseAbs().maxCoeff() > clip.w()) return false;
    return !(viewer.shadowDistance > 0.0) || -view.z() <= viewer.shadowDistance;
}

bool shinesOn(const ShadowLight& light, const Vec3& ws) {
    if (light.kind == LightKind::Directional) return true;
    const Vec3 ray = ws - light.wsPosition;
    if (light.kind == LightKind::Point)
        return ray.norm() >= light.nearDistance && ray.norm() <= light.range;
    const double depth = ray.dot(light.wsDirection.normalized());
    return depth >= light.nearDistance && ray.norm() <= light.range &&
           depth >= std::cos(light.outerHalfAngle) * ray.norm();
}

Vec3 towardsLight(const ShadowLight& light, const Vec3& ws) {
    return light.kind == LightKind::Directional ? Vec3(-light.wsDirection.normalized())
                                                : Vec3((light.wsPosition - ws).normalized());
}

std::optional<Vec3> occluder(const Scene& scene, std::size_t receiver, const Vec3& ws) {
    if (!shinesOn(scene.light, ws) || !scene.turnedReceivers.mayBeLit(receiver, scene.light, ws))
        return std::nullopt;
    const Vec3 direction = towardsLight(scene.light, ws);
    double last = Infinity;
    if (scene.light.kind == LightKind::Point) {
        last = (ws - scene.light.wsPosition).norm() - scene.light.nearDistance;
    } else if (scene.light.kind == LightKind::Spot) {
        // Up to the near distance, which is measured along the axis.
        const Vec3 axis = scene.light.wsDirection.normalized();
        const double depth = (ws - scene.light.wsPosition).dot(axis);
        last = (depth - scene.light.nearDistance) / -direction.dot(axis);
    }
    const double first = Contact * scene.size;
    double farthest = first;
    const Bodies casters = castersOf(scene);
    const std::uintptr_t self = scene.turnedReceivers.numberOf(receiver);
    const auto consider = [&](const std::optional<Interval>& hit) {
        if (hit && hit->begin < last) farthest = std::max(farthest, std::min(hit->end, last));
    };
    for (std::size_t i = 0; i < casters.size(); ++i)
        if (self == 0 || scene.turnedCasters.numberOf(i) != self)
            consider(casters.meet(i, ws, direction));
        else
            for (const auto& [box, wsFromBody] : scene.turnedCasters.slopesOf(i, scene.light)) {
                const Transform3 bodyFromWs = wsFromBody.inverse();
                consider(rayInBox(box, bodyFromWs * ws, bodyFromWs.linear() * direction));
            }
    if (farthest == first) return std::nullopt;
    return ws + farthest * direction;
}

std::vector<Vec3> visiblePoints(const Scene& scene, Dice& dice, std::size_t rays) {
    std::vector<Vec3> points;
    for (const ReceiverPoint& p : visibleReceiverPoints(scene, dice, rays))
        points.push_back(p.ws);
    return points;
}

std::vector<ShadowedPoint> shadowedPoints(const Scene& scene, Dice& dice, std::size_t rays) {
    std::vector<ReceiverPoint> points = visibleReceiverPoints(scene, dice, rays);
    const Bodies casters = castersOf(scene);
    for (std::size_t i = 0; i < rays && casters.size() > 0; ++i) {
        const Vec3 through = pointOf(casters, dice.below(casters.size()), dice);
        appendHits(receiversOf(scene), through, -towardsLight(scene.light, through), points);
    }
    std::vector<ShadowedPoint> result;
    for (const ReceiverPoint& p : points)
        if (sees(scene.viewer, p.ws))
            if (const auto by = occluder(scene, p.receiver, p.ws)) result.push_back({p.ws, *by});
    return result;
}

} // namespace Lixel::Test

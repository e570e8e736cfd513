#include "Problems.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <bit>
#include <iomanip>
#include <ostream>

namespace Lixel {

std::ostream& operator<<(std::ostream& out, const Aabb& box) {
    return out << "{" << box.centre.transpose() << " | " << box.halfExtents.transpose() << "}";
}

std::ostream& operator<<(std::ostream& out, FitReason reason) {
    return out << toString(reason);
}

} // namespace Lixel

namespace Lixel::Test {
namespace {

/// Every third to tenth extent vanishes, so that flat, thin and point-like boxes are common.
Aabb randomBox(Dice& dice, const Scene& scene, const Vec3& eye, const Vec3& forward) {
    Aabb box;
    const double spread = scene.size * std::pow(10.0, dice.in(-0.5, 0.5));
    box.centre = eye + spread * dice.cube();
    if (dice.chance(0.5)) box.centre += 1.2 * spread * forward;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        box.halfExtents[axis] =
            dice.chance(0.1) ? 0.0 : scene.size * std::pow(10.0, dice.in(-2.5, -0.3));
    if (dice.chance(0.03)) box.halfExtents.setZero();
    return box;
}

ShadowViewer randomViewer(Dice& dice, double size) {
    ShadowViewer viewer;
    Vec3 forward = dice.direction();
    Vec3 up = Vec3::UnitY();
    switch (dice.below(4)) {
    case 0: // along an axis
        forward = Vec3::Zero();
        forward[static_cast<Eigen::Index>(dice.below(3))] = dice.chance(0.5) ? 1.0 : -1.0;
        break;
    case 1: // a walker
        forward.y() *= 0.2;
        break;
    default:
        break;
    }
    forward.normalize();
    if (std::abs(forward.y()) > 0.999) up = Vec3::UnitX();
    if (dice.chance(0.2)) up = (up + 0.5 * dice.direction()).normalized();
    const Vec3 eye = dice.chance(0.5) ? Vec3(Vec3::Zero()) : Vec3(size * dice.cube());
    viewer.viewFromWorld = lookAlong(eye, forward, up);
    if (dice.chance(0.1)) {
        const Vec4 mirror(-1.0, 1.0, 1.0, 1.0);
        viewer.viewFromWorld = mirror.asDiagonal() * viewer.viewFromWorld;
    }

    const double nearDepth = size * std::pow(10.0, dice.in(-4.0, -1.0));
    const double farDepth = size * std::pow(10.0, dice.in(-0.3, 1.5));
    const double fov = dice.in(15.0, 120.0) * Degree;
    const double aspect = std::pow(3.0, dice.in(-1.0, 1.0));
    switch (dice.below(5)) {
    case 0:
        viewer.clipFromView = perspective(fov, aspect, nearDepth, Infinity);
        break;
    case 1: {
        const double half = nearDepth * std::tan(fov / 2.0);
        const double x = half * dice.in(-1.5, 1.5);
        const double y = half * dice.in(-1.5, 1.5);
        viewer.clipFromView =
            frustum(x - half * aspect, x + half * aspect, y - half, y + half, nearDepth, farDepth);
        break;
    }
    case 2: {
        const double half = size * std::pow(10.0, dice.in(-1.0, 0.5));
        viewer.clipFromView =
            orthographic(half * aspect, half, dice.chance(0.5) ? -size : nearDepth, farDepth);
        break;
    }
    default:
        viewer.clipFromView = perspective(fov, aspect, nearDepth, farDepth);
        break;
    }
    if (dice.chance(0.4)) viewer.shadowDistance = size * std::pow(10.0, dice.in(-0.5, 0.7));
    return viewer;
}

Vec3 randomLightDirection(Dice& dice, const ShadowViewer& viewer) {
    const Vec3 forward = forwardOf(viewer);
    Vec3 axis = Vec3::Zero();
    axis[static_cast<Eigen::Index>(dice.below(3))] = dice.chance(0.5) ? 1.0 : -1.0;
    switch (dice.below(8)) {
    case 0:
        return forward;
    case 1:
        return -forward;
    case 2:
        return -viewer.viewFromWorld.block<1, 3>(1, 0).transpose();
    case 3:
        return -Vec3::UnitY();
    case 4:
        return axis;
    case 5: // nearly along the view, either way
        return (dice.chance(0.5) ? 1.0 : -1.0) * forward +
               std::pow(10.0, dice.in(-9.0, -1.0)) * dice.direction();
    default:
        return dice.direction() * std::pow(10.0, dice.in(-3.0, 3.0));
    }
}

} // namespace

double Dice::in(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(mEngine);
}

std::size_t Dice::below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(mEngine);
}

Vec3 Dice::cube() {
    const double x = in(-1.0, 1.0);
    const double y = in(-1.0, 1.0);
    return {x, y, in(-1.0, 1.0)};
}

Vec3 Dice::direction() {
    for (;;) {
        const Vec3 p = cube();
        if (p.squaredNorm() <= 1.0 && p.squaredNorm() > 1e-4) return p.normalized();
    }
}

const TurnedBox* TurnedBoxes::find(std::size_t index) const {
    const auto found = std::lower_bound(
        all.begin(), all.end(), index,
        [](const TurnedBox& body, std::size_t value) { return body.index < value; });
    return found != all.end() && found->index == index ? &*found : nullptr;
}

const BodyHull* TurnedBoxes::hullOf(std::size_t index, Transform3& wsFromBody) const noexcept {
    const TurnedBox* const body = find(index);
    if (body == nullptr) return nullptr;
    wsFromBody = Eigen::Translation3d(body->box.centre) * Transform3(body->turn);
    return &body->hull;
}

Aabb boxOf(const ReliefCell& cell) {
    const Eigen::AlignedBox3d bounds = cell.bounds.cast<double>();
    return {bounds.center(), bounds.sizes() / 2.0};
}

std::uintptr_t TurnedBoxes::numberOf(std::size_t index) const noexcept {
    const auto found = std::ranges::find(convex, index, &ConvexBox::index);
    return found != convex.end() ? found->number : 0;
}

bool TurnedBoxes::mayBeLit(std::size_t index, const ShadowLight& light, const Vec3& ws) const {
    const auto found = std::ranges::find(convex, index, &ConvexBox::index);
    if (found == convex.end()) return true;
    const bool isRelief = found->relief && !found->relief->cells.empty();
    if (!isRelief && !found->isBox) return true;
    const auto& [box, wsFromBody] = found->around;
    if (box.halfExtents.minCoeff() == 0.0) return true;
    const Vec3 at = (wsFromBody.inverse() * ws - box.centre).cwiseQuotient(box.halfExtents);
    constexpr double OnSide = 1e-6;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        if (std::abs(at[axis]) < 1.0 - OnSide) continue;
        const Vec3 outward = std::copysign(1.0, at[axis]) * Vec3::Unit(axis);
        const bool isTop = isRelief && outward.dot(found->relief->axis) > 0.5;
        const Vec3 towards = light.kind == LightKind::Directional ? Vec3(-light.wsDirection)
                                                                  : Vec3(light.wsPosition - ws);
        if (!isTop && (wsFromBody.linear() * outward).dot(towards) > 0.0) return true;
    }
    return isRelief && std::ranges::any_of(found->relief->cells, [&](const ReliefCell& cell) {
               const Aabb bounds = boxOf(cell);
               const Vec3 offset = wsFromBody.inverse() * ws - bounds.centre;
               return (offset.cwiseAbs().array() <= bounds.halfExtents.array()).all();
           });
}

const ConvexBox* TurnedBoxes::findRelief(std::size_t index) const {
    const auto found = std::ranges::find(convex, index, &ConvexBox::index);
    if (found == convex.end() || !found->relief || found->relief->cells.empty()) return nullptr;
    return &*found;
}

std::vector<PlacedBox> TurnedBoxes::slopesOf(std::size_t index, const ShadowLight& light) const {
    std::vector<PlacedBox> slopes;
    const auto found = std::ranges::find(convex, index, &ConvexBox::index);
    if (found == convex.end() || !found->relief) return slopes;
    const Relief& relief = *found->relief;
    const Transform3& wsFromBody = found->around.wsFromBody;
    const bool isSun = light.kind == LightKind::Directional;
    Vec4 towards = light.wsPosition.homogeneous();
    if (isSun) towards << -light.wsDirection, 0.0;
    towards = wsFromBody.inverse() * towards;
    if (isSun && relief.isBelow(towards.head<3>())) return slopes;
    for (const ReliefCell& cell : relief.cells)
        if (!relief.isLit(cell, towards)) slopes.push_back({boxOf(cell), wsFromBody});
    return slopes;
}

void TurnedBoxes::clear() {
    all.clear();
    convex.clear();
}

const void* TurnedBoxes::identityOf(std::size_t index) const noexcept {
    return reinterpret_cast<const void*>(numberOf(index));
}

bool TurnedBoxes::isSelfShadowFree(std::size_t index, SelfShadowFree& body) const noexcept {
    const auto found = std::ranges::find(convex, index, &ConvexBox::index);
    if (found == convex.end()) return false;
    body = {found->around, found->isBox, found->relief ? &*found->relief : nullptr};
    return true;
}

void addTurned(const Aabb& box, const Mat3& turn, BoxSet& set, TurnedBoxes& turned) {
    const auto own = corners({Vec3::Zero(), box.halfExtents});
    turned.all.push_back({set.size(), box, turn, makeBodyHull(own)});
    set.add({box.centre, turn.cwiseAbs() * box.halfExtents});
}

ShadowProblem Scene::problem() const {
    const auto shapesOf = [](const TurnedBoxes& bodies) {
        return bodies.all.empty() && bodies.convex.empty() ? nullptr : &bodies;
    };
    return {.viewer = viewer,
            .light = light,
            .casters = &casters,
            .receivers = &receivers,
            .casterShapes = shapesOf(turnedCasters),
            .receiverShapes = shapesOf(turnedReceivers),
            .mapWidth = mapWidth,
            .mapHeight = mapHeight,
            .filterRadius = filterRadius,
            .depthClamp = depthClamp};
}

void Scene::addBody(const Aabb& box) {
    casters.add(box);
    receivers.add(box);
}

void Scene::addConvexBody(const Aabb& box) {
    addBody(box);
    setConvex(casters.size() - 1, receivers.size() - 1);
}

void Scene::setConvex(std::size_t caster, std::size_t receiver, const std::optional<Relief>& relief,
                      bool isBox) {
    PlacedBox around{casters.box(caster), Transform3::Identity()};
    if (const TurnedBox* const body = turnedCasters.find(caster))
        around = {{Vec3::Zero(), body->box.halfExtents},
                  Eigen::Translation3d(body->box.centre) * Transform3(body->turn)};
    const std::uintptr_t number = turnedCasters.convex.size() + 1;
    turnedCasters.convex.push_back({caster, number, around, relief, isBox});
    turnedReceivers.convex.push_back({receiver, number, around, relief, isBox});
}

Mat4 frustum(double left, double right, double bottom, double top, double nearDepth,
             double farDepth) {
    Mat4 m = Mat4::Zero();
    m(0, 0) = 2.0 * nearDepth / (right - left);
    m(0, 2) = (right + left) / (right - left);
    m(1, 1) = 2.0 * nearDepth / (top - bottom);
    m(1, 2) = (top + bottom) / (top - bottom);
    const bool endless = std::isinf(farDepth);
    m(2, 2) = endless ? -1.0 : -(farDepth + nearDepth) / (farDepth - nearDepth);
    m(2, 3) = endless ? -2.0 * nearDepth : -2.0 * farDepth * nearDepth / (farDepth - nearDepth);
    m(3, 2) = -1.0;
    return m;
}

Mat4 perspective(double fovY, double aspect, double nearDepth, double farDepth) {
    const double half = nearDepth * std::tan(fovY / 2.0);
    return frustum(-half * aspect, half * aspect, -half, half, nearDepth, farDepth);
}

Mat4 orthographic(double halfWidth, double halfHeight, double nearDepth, double farDepth) {
    Mat4 m = Mat4::Identity();
    m(0, 0) = 1.0 / halfWidth;
    m(1, 1) = 1.0 / halfHeight;
    m(2, 2) = -2.0 / (farDepth - nearDepth);
    m(2, 3) = -(farDepth + nearDepth) / (farDepth - nearDepth);
    return m;
}

Mat4 lookAlong(const Vec3& eye, const Vec3& forward, const Vec3& up) {
    const Vec3 z = -forward.normalized();
    const Vec3 x = up.cross(z).normalized();
    Mat4 m = Mat4::Identity();
    m.block<1, 3>(0, 0) = x.transpose();
    m.block<1, 3>(1, 0) = z.cross(x).transpose();
    m.block<1, 3>(2, 0) = z.transpose();
    m.topRightCorner<3, 1>() = -m.topLeftCorner<3, 3>() * eye;
    return m;
}

Vec3 turned(const Vec3& direction, const Vec3& unitAxis, double angle) {
    return Eigen::AngleAxisd(angle, unitAxis) * direction;
}

Vec3 eyeOf(const ShadowViewer& viewer) {
    return viewer.viewFromWorld.inverse().topRightCorner<3, 1>();
}

Vec3 forwardOf(const ShadowViewer& viewer) {
    return -viewer.viewFromWorld.block<1, 3>(2, 0).transpose();
}

Scene outdoors() {
    Scene scene;
    scene.size = 10.0;
    scene.viewer.viewFromWorld = lookAlong(Vec3::Zero(), Vec3(0.0, -0.15, -1.0));
    scene.viewer.clipFromView = perspective(60.0 * Degree, 16.0 / 9.0, 0.1, 500.0);
    scene.light.wsDirection = Vec3(0.8, -1.0, 0.3);
    const double ground = -2.0;
    scene.receivers.add({Vec3(0.0, ground, 0.0), Vec3(100.0, 0.0, 100.0)});
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            const Vec3 half(0.6, 0.5 + 0.4 * column, 0.6);
            scene.addBody({Vec3(4.0 * (column - 1), ground + half.y(), -4.0 - 12.0 * row), half});
        }
    return scene;
}

Scene scaled(const Scene& scene, double factor) {
    Scene result = scene;
    result.size *= factor;
    result.viewer.viewFromWorld.topRightCorner<3, 1>() *= factor;
    // Clip coordinates of a scaled point stay the same, up to a factor for a perspective matrix:
    // its row w is (0, 0, -1, 0) at every scale.
    result.viewer.clipFromView.leftCols<3>() /= factor;
    if (scene.viewer.clipFromView(3, 3) == 0.0) result.viewer.clipFromView *= factor;
    result.viewer.shadowDistance *= factor;
    result.light.wsPosition *= factor;
    result.light.nearDistance *= factor;
    result.light.range *= factor;
    const auto scaleAll = [&](const BoxSet& from, const TurnedBoxes& turnedFrom, BoxSet& to,
                              TurnedBoxes& turnedTo) {
        to.clear();
        turnedTo.all.clear();
        for (ConvexBox& body : turnedTo.convex) {
            body.around.box.centre *= factor;
            body.around.box.halfExtents *= factor;
            body.around.wsFromBody.translation() *= factor;
            if (!body.relief) continue;
            for (ReliefCell& cell : body.relief->cells)
                cell.bounds = {cell.bounds.min() * static_cast<float>(factor),
                               cell.bounds.max() * static_cast<float>(factor)};
        }
        const auto scaledBox = [&](const Aabb& box) {
            return Aabb{box.centre * factor, box.halfExtents * factor};
        };
        for (std::size_t i = 0; i < from.size(); ++i) {
            if (const TurnedBox* const body = turnedFrom.find(i))
                addTurned(scaledBox(body->box), body->turn, to, turnedTo);
            else
                to.add(scaledBox(from.box(i)));
        }
    };
    scaleAll(scene.casters, scene.turnedCasters, result.casters, result.turnedCasters);
    scaleAll(scene.receivers, scene.turnedReceivers, result.receivers, result.turnedReceivers);
    return result;
}

rc::Gen<std::uint64_t> anySeed() {
    return rc::gen::noShrink(
        rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
}

Dice anyDice() {
    return Dice(*anySeed());
}

double insideBorder(const Vec2& texel, const Scene& scene) {
    const Vec2 size(scene.mapWidth, scene.mapHeight);
    return std::min(texel.minCoeff(), (size - texel).minCoeff());
}

rc::Gen<Scene> anyScene() {
    const auto build = rc::gen::exec([] {
        Scene scene;
        Dice dice(*anySeed());
        constexpr std::array<double, 4> Sizes = {1e-2, 1.0, 30.0, 5e3};
        scene.size = Sizes[dice.below(Sizes.size())];
        scene.viewer = randomViewer(dice, scene.size);
        const Vec3 eye = eyeOf(scene.viewer);
        const Vec3 forward = forwardOf(scene.viewer);
        scene.light.wsDirection = randomLightDirection(dice, scene.viewer);
        if (dice.chance(0.4)) {
            scene.light.kind = LightKind::Spot;
            scene.light.wsPosition = eye + scene.size * dice.cube();
            if (dice.chance(0.5)) // towards what the viewer looks at
                scene.light.wsDirection = eye + scene.size * forward - scene.light.wsPosition;
            scene.light.outerHalfAngle = dice.in(5.0, 80.0) * Degree;
            scene.light.nearDistance = scene.size * std::pow(10.0, dice.in(-3.0, -1.0));
            if (dice.chance(0.5)) scene.light.range = scene.size * dice.in(0.5, 5.0);
        }
        constexpr std::array<int, 3> MapSizes = {256, 1024, 2048};
        scene.mapWidth = MapSizes[dice.below(MapSizes.size())];
        scene.mapHeight = dice.chance(0.7) ? scene.mapWidth : MapSizes[dice.below(3)];
        constexpr std::array<double, 3> Radii = {0.0, 1.0, 2.5};
        scene.filterRadius = Radii[dice.below(Radii.size())];
        scene.depthClamp = dice.chance(0.6);
        if (dice.chance(0.5)) {
            const Vec3 half(20.0, dice.chance(0.5) ? 0.0 : 0.05, 20.0);
            const Aabb ground{eye - 0.3 * scene.size * Vec3::UnitY(), half * scene.size};
            scene.receivers.add(ground);
            if (dice.chance(0.5)) scene.casters.add(ground);
        }

        const auto bodies =
            *rc::gen::nonEmpty(rc::gen::container<std::vector<std::uint64_t>>(anySeed()));
        for (std::size_t i = 0; i < std::min<std::size_t>(bodies.size(), 60); ++i) {
            Dice body(bodies[i]);
            const Aabb box = randomBox(body, scene, eye, forward);
            const double role = body.in(0.0, 1.0);
            if (role < 0.8) scene.casters.add(box);
            if (role > 0.2) scene.receivers.add(box);
        }
        return scene;
    });
    return build;
}

namespace {

/// Slopes somewhere in a body's box.
Relief anyRelief(const Aabb& box, Dice& dice) {
    const bool isGround = dice.chance(0.5);
    Relief relief{isGround ? Vec3::UnitY() : Vec3(-Vec3::UnitX()), dice.in(0.0, 0.9)};
    const double steepest = relief.steepness / std::sqrt(1.0 - relief.steepness * relief.steepness);
    for (int i = dice.chance(0.7) ? 8 : 0; i > 0; --i) {
        ReliefCell cell;
        for (int corner = 0; corner < 2; ++corner) {
            // Within it in single precision too.
            const Vec3 at(dice.in(-0.99, 0.99), dice.in(-0.99, 0.99), dice.in(-0.99, 0.99));
            cell.bounds.extend((box.centre + box.halfExtents.cwiseProduct(at)).cast<float>());
        }
        for (float& rise : cell.rise)
            rise = static_cast<float>(dice.in(-0.2, 1.0) * steepest);
        relief.cells.push_back(cell);
    }
    return relief;
}

/// Has some or all of the bodies that cast and receive say that they are convex.
void sayConvex(Scene& scene, Dice& dice) {
    if (dice.chance(0.3)) return;
    const double share = dice.chance(0.5) ? 1.0 : dice.in(0.1, 1.0);
    for (std::size_t i = 0; i < scene.casters.size(); ++i)
        for (std::size_t k = 0; k < scene.receivers.size(); ++k) {
            const Aabb caster = scene.casters.box(i);
            const Aabb receiver = scene.receivers.box(k);
            if (caster.centre != receiver.centre || caster.halfExtents != receiver.halfExtents ||
                !dice.chance(share))
                continue;
            // Some say so of some lights alone.
            std::optional<Relief> relief;
            const TurnedBox* const turned = scene.turnedCasters.find(i);
            if (dice.chance(0.5))
                relief = anyRelief(
                    turned != nullptr ? Aabb{Vec3::Zero(), turned->box.halfExtents} : caster, dice);
            scene.setConvex(i, k, relief, !relief && dice.chance(0.7));
        }
}

} // namespace

rc::Gen<Scene> anySceneOfHulls() {
    return rc::gen::exec([] {
        Scene scene = *anyScene();
        Dice dice(*anySeed());
        if (dice.chance(0.5)) {
            sayConvex(scene, dice);
            return scene;
        }
        const double turns = dice.in(0.2, 1.0);
        const std::uint64_t seed = dice.below(1U << 30);
        const auto turnSome = [&](BoxSet& set, TurnedBoxes& turned) {
            const BoxSet plain = set;
            set.clear();
            for (const Aabb& box : plain.boxes()) {
                // A body that casts and receives is turned alike.
                Dice body(seed + std::bit_cast<std::uint64_t>(box.centre.x()));
                if (body.chance(turns))
                    addTurned(
                        box,
                        Eigen::AngleAxisd(body.in(-3.0, 3.0), body.direction()).toRotationMatrix(),
                        set, turned);
                else
                    set.add(box);
            }
        };
        turnSome(scene.casters, scene.turnedCasters);
        turnSome(scene.receivers, scene.turnedReceivers);
        sayConvex(scene, dice);
        return scene;
    });
}

bool isLostInRounding(const Scene& scene, const FitState& state) {
    const FocusRegion& region = state.region;
    double reach = std::max(
        {std::abs(region.lsReceiverNear), std::abs(region.lsReceiverFar), region.liCentre.norm()});
    if (scene.light.kind != LightKind::Directional)
        reach = std::max(region.lsReceiverFar, scene.light.wsPosition.norm()) /
                std::max(region.lsReceiverNear, region.lsReceiverFar / 64.0);
    Vec2 least = Vec2::Constant(Infinity);
    Vec2 greatest = -least;
    for (const Vec2& q : region.liHull) {
        least = least.cwiseMin(q);
        greatest = greatest.cwiseMax(q);
    }
    // A hundred texels of 2^-19: what a warp with denominators of 1 to 32 must not be wrong by.
    return (greatest - least).norm() < 100.0 * 0x1p-19 * reach;
}

std::vector<ViewSample> samplesOf(const ShadowProblem& problem, const SampleCount& count) {
    const LightImage image(problem.light);
    FocusScratch scratch;
    FocusRegion region;
    findFocusRegion(problem, image, scratch, region);
    SampleScratch sampling;
    std::vector<ViewSample> samples;
    sampleView(problem, image, region.liHull, region.receiversInView, count, sampling, samples);
    return samples;
}

Vec4 clipOf(const Mat4& clipFromWorld, const Vec3& ws) {
    return clipFromWorld * ws.homogeneous();
}

Vec4 homogeneousLight(const ShadowLight& light) {
    Vec4 result;
    if (light.kind == LightKind::Directional)
        result << -light.wsDirection.normalized(), 0.0;
    else
        result << light.wsPosition, 1.0;
    return result;
}

Vec2 derivative(const Mat4& clipFromWorld, const Vec2& size, const Vec3& x, const Vec3& d) {
    const Vec4 clip = clipOf(clipFromWorld, x);
    const Vec4 step = clipFromWorld * Vec4(d.x(), d.y(), d.z(), 0.0);
    const Vec2 ndc =
        (step.head<2>() * clip.w() - clip.head<2>() * step.w()) / (clip.w() * clip.w());
    return ndc.cwiseProduct(size) / 2.0;
}

Vec2 texelOf(const Mat4& clipFromWorld, const Scene& scene, const Vec3& ws) {
    const Vec4 clip = clipOf(clipFromWorld, ws);
    const Vec2 size(scene.mapWidth, scene.mapHeight);
    return (clip.head<2>() / clip.w() + Vec2::Ones()).cwiseProduct(size) / 2.0;
}

double servedMargin(const ShadowFit& fit, const Vec3& ws) {
    double margin = Infinity;
    for (std::size_t i = 0; i < fit.servedCount; ++i)
        margin = std::min(margin, fit.wsServed[i].dot(ws.homogeneous()));
    return margin;
}

Mat4 roundedToFloat(const Mat4& m) {
    return m.cast<float>().cast<double>();
}

double inside(const ConvexVolume& volume, const Vec3& p) {
    double result = Infinity;
    for (const HalfSpace& plane : volume.planes())
        result = std::min(result, plane.distance(p));
    return result;
}

double support3(const std::vector<Vec3>& points, const Vec3& d) {
    double result = -Infinity;
    for (const Vec3& p : points)
        result = std::max(result, d.dot(p));
    return result;
}

std::ostream& operator<<(std::ostream& out, const Scene& scene) {
    const ShadowLight& light = scene.light;
    out << std::setprecision(17) << "viewFromWorld\n"
        << scene.viewer.viewFromWorld << "\nclipFromView\n"
        << scene.viewer.clipFromView << "\nshadowDistance " << scene.viewer.shadowDistance
        << (light.kind == LightKind::Directional ? "\ndirectional "
            : light.kind == LightKind::Spot      ? "\nspot "
                                                 : "\npoint ")
        << light.wsDirection.transpose();
    if (light.kind != LightKind::Directional)
        out << " at " << light.wsPosition.transpose() << ", half angle " << light.outerHalfAngle
            << ", near " << light.nearDistance << ", range " << light.range;
    out << "\nmap " << scene.mapWidth << " x " << scene.mapHeight << ", filter radius "
        << scene.filterRadius << ", depth clamp " << scene.depthClamp;
    const auto list = [&](const char* title, const BoxSet& set, const TurnedBoxes& turned) {
        out << "\n" << title << " (centre | half extents)";
        for (std::size_t i = 0; i < set.size(); ++i) {
            const TurnedBox* const body = turned.find(i);
            out << "\n  " << (body != nullptr ? body->box : set.box(i));
            if (body != nullptr) out << " turned by\n" << body->turn;
            if (turned.numberOf(i) != 0) out << " convex, number " << turned.numberOf(i);
        }
        if (set.unbounded() > 0) out << "\n  unbounded: " << set.unbounded();
        if (set.invalid() > 0) out << "\n  invalid: " << set.invalid();
    };
    list("casters", scene.casters, scene.turnedCasters);
    list("receivers", scene.receivers, scene.turnedReceivers);
    return out;
}

} // namespace Lixel::Test

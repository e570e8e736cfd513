#include "Judge.h"

#include "common/OracleView.h"

#include <Eigen/QR>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace Lixel::Tests {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using namespace Samples;

/// Pixels of the picture that is judged.
constexpr int Width = 128;
constexpr int Height = 96;

/// A visible point in shadow and what shadows it, relative to the scene's origin.
struct ShadowedPoint {
    Vector3d receiver;
    Vector3d caster;
    Vector3d alongLight; ///< unit vector, away from the light
    double tolerance;    ///< how exactly the caster's point is known, in world units
};

Vector3d positionOf(const Ogre::Vector3& v) {
    return Eigen::Vector3f(v.x, v.y, v.z).cast<double>();
}

OracleView viewOf(HardScene& scene, const Vector3d& wsOrigin) {
    const Ogre::Camera& viewer = scene.viewer();
    OracleView view = oracleView(
        viewer, Width, Height, static_cast<double>(scene.light->getShadowFarDistance()), wsOrigin);
    if (!viewer.isReflected()) return view;
    // Which the oracle's own view leaves out.
    const Ogre::Affine3& matrix = viewer.getViewMatrix(true);
    Matrix4d vsFromWorld = Matrix4d::Identity();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            vsFromWorld(row, column) = static_cast<double>(matrix[row][column]);
    Eigen::Affine3d fromOrigin = Eigen::Affine3d::Identity();
    fromOrigin.translation() = wsOrigin;
    view.vsFromWs = vsFromWorld * fromOrigin.matrix();
    return view;
}

std::vector<ShadowedPoint> findShadowed(HardScene& scene, const Vector3d& wsOrigin) {
    const ShadowOracle oracle(collectTriangles(scene.manager(), wsOrigin));
    // The ray starts one offset beside the point.
    const double tolerance = 2.0 * oracle.rayOffset();
    const OracleView view = viewOf(scene, wsOrigin);
    const OracleLight light = oracleLight(*scene.light, wsOrigin);
    const VisiblePoints points = oracle.visiblePoints(view);
    const ShadowTruth truth = oracle.classify(points, view, light);

    std::vector<ShadowedPoint> shadowed;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        if (truth.pixels[i] != PixelClass::Shadowed &&
            truth.pixels[i] != PixelClass::GrazingShadowed)
            continue;
        const SurfacePoint& point = *points.pixels[i];
        const bool sun = light.kind == OracleLight::Kind::Directional;
        const Vector3d towards = sun ? Vector3d(-light.direction)
                                     : Vector3d((light.position - point.position).normalized());
        CasterRay ray{point.position + oracle.rayOffset() * point.normal, towards,
                      sun ? std::numeric_limits<double>::infinity()
                          : (light.position - point.position).norm()};
        // Drawn are the sides that face away from the light: those that this ray sees in front.
        double distance = 0.0;
        oracle.firstCasters({&ray, 1}, CasterFaces::Fronts, {&distance, 1});
        if (!std::isfinite(distance)) continue;
        // In a map of small texels or a scene of a million units the offset is a visible length.
        // What counts is the caster on the point's very own ray.
        ray.origin = point.position + oracle.rayOffset() * towards;
        oracle.firstCasters({&ray, 1}, CasterFaces::Fronts, {&distance, 1});
        if (!std::isfinite(distance)) continue;
        shadowed.push_back({point.position, ray.origin + distance * towards, -towards, tolerance});
    }
    return shadowed;
}

/// Texels; meaningless unless w > 0.
Vector2d texel(const ProbedMap& map, const Vector4d& clip) {
    return {(0.5 + 0.5 * clip.x() / clip.w()) * map.width,
            (0.5 + 0.5 * clip.y() / clip.w()) * map.height};
}

/** How far rounding may move a point in the map, in texels.

    A coordinate x and each product with it are known to 2^-24 |x|: twice that for the rounding of
    the matrix and of its translation, and as much again for the product of two matrices.
    @param position relative to what programs are given positions relative to
*/
double rounding(const ProbedMap& map, const Matrix4d& clipFromWs, const Vector4d& clip,
                const Vector3d& position) {
    const Vector3d error = 4.0 * 0x1p-24 * position.cwiseAbs();
    const auto moved = [&](int row) {
        const Eigen::RowVector3d gradient =
            (clipFromWs.row(row) - clip[row] / clip.w() * clipFromWs.row(3)).head<3>() / clip.w();
        return gradient.cwiseAbs().dot(error.transpose());
    };
    return std::hypot(0.5 * map.width * moved(0), 0.5 * map.height * moved(1));
}

/// Whether the map shows a small triangle, counter-clockwise seen from the light, clockwise.
bool isMirrored(const Matrix4d& clipFromWs, const ShadowedPoint& point) {
    // The direction in which each point moves: w grad(x) - x grad(w).
    const Vector4d clip = clipFromWs * point.caster.homogeneous();
    const Vector3d first = point.alongLight.unitOrthogonal();
    const Vector3d second = first.cross(point.alongLight);
    const auto moved = [&](const Vector3d& direction) {
        const Vector4d change = clipFromWs.leftCols<3>() * direction;
        return Vector2d(clip.w() * change.x() - clip.x() * change.w(),
                        clip.w() * change.y() - clip.y() * change.w());
    };
    const Vector2d a = moved(first);
    const Vector2d b = moved(second);
    return !(a.x() * b.y() - a.y() * b.x() > 0.0);
}

/// Whether the first of two casters whose boxes share a point is rather meant.
bool tighter(const ProbedCaster& one, const ProbedCaster& other) {
    if (one.drawn != other.drawn) return one.drawn;
    return one.wsBox.volume() < other.wsBox.volume();
}

/** The caster that the point is on: one that is drawn, if there are several. Null: none.
    @param distance from its box that the point may have, in world units
*/
const ProbedCaster* casterAt(const ProbedMap& map, const Vector3d& ws, double distance) {
    const ProbedCaster* found = nullptr;
    for (const ProbedCaster& caster : map.casters)
        if (caster.wsBox.squaredExteriorDistance(ws) <= distance * distance &&
            (found == nullptr || tighter(caster, *found)))
            found = &caster;
    return found;
}

bool isServed(const ProbedMap& map, const Vector3d& ws) {
    const Vector4d position = (ws - map.wsFitOrigin).homogeneous();
    return std::all_of(map.wsServed.begin(), map.wsServed.end(),
                       [&](const Vector4d& half) { return half.dot(position) >= 0.0; });
}

/// OpenGL clip space from positions relative to wsOrigin, as the caster is drawn.
Matrix4d clipOf(const ProbedCaster& caster, const Vector3d& wsOrigin) {
    // Of a flat body too, where a matrix has no inverse.
    Eigen::Affine3d objectFromWs = Eigen::Affine3d::Identity();
    objectFromWs.linear() =
        caster.wsFromObject.linear().completeOrthogonalDecomposition().pseudoInverse();
    objectFromWs.translate(wsOrigin - caster.wsFromObject.translation());
    return caster.clipFromObject * objectFromWs.matrix();
}

} // namespace

std::size_t countShadowed(HardScene& scene) {
    return findShadowed(scene, positionOf(scene.origin)).size();
}

Losses judge(HardScene& scene, const std::vector<ProbedMap>& maps, const MapUse& use) {
    const Vector3d wsOrigin = positionOf(scene.origin);
    Losses losses;
    for (const ProbedMap& map : maps) {
        losses.finite = losses.finite && map.receivers.clipFromBase.allFinite();
        for (const ProbedCaster& caster : map.casters)
            losses.finite = losses.finite && caster.clipFromObject.allFinite();
    }
    const std::vector<ShadowedPoint> points = findShadowed(scene, wsOrigin);
    losses.shadowed = points.size();
    if (points.empty() || !losses.finite) return losses;

    const double share = 100.0 / static_cast<double>(points.size());
    for (const ShadowedPoint& point : points) {
        const ProbedMap& map = maps[servingMap(maps, wsOrigin + point.receiver)];
        if (!hasMap(map.reason)) {
            losses.outside += share;
            continue;
        }
        const Matrix4d receivers = map.receivers.relativeTo(wsOrigin);
        if (!isServed(map, wsOrigin + point.receiver)) {
            losses.unserved += share;
            continue;
        }
        const Vector4d receiver = receivers * point.receiver.homogeneous();
        const bool inFront = receiver.w() > 0.0;
        const bool inside = inFront && std::abs(receiver.x()) <= receiver.w() &&
                            std::abs(receiver.y()) <= receiver.w();
        if (!inFront) losses.behind += share;
        if (inFront && !inside) {
            const double beside =
                std::max((std::abs(receiver.x()) / receiver.w() - 1.0) * 0.5 * map.width,
                         (std::abs(receiver.y()) / receiver.w() - 1.0) * 0.5 * map.height);
            const double floats =
                rounding(map, receivers, receiver, wsOrigin + point.receiver - map.wsBase);
            (beside <= floats ? losses.coarse : losses.outside) += share;
        }

        const Vector3d wsCaster = wsOrigin + point.caster;
        const ProbedCaster* const found = casterAt(map, wsCaster, point.tolerance);
        if (found == nullptr) throw std::logic_error("a shadow without a caster");
        if (!found->drawn) losses.culled += share;
        const Matrix4d casters = clipOf(*found, wsOrigin);
        const Vector4d caster = casters * point.caster.homogeneous();
        const bool inRange = use.clampsDepth || std::abs(caster.z()) <= caster.w();
        if (!(caster.w() > 0.0) || !inRange) losses.clipped += share;
        if (!inside || !(caster.w() > 0.0)) continue;
        const double apart = (texel(map, receiver) - texel(map, caster)).norm();
        losses.worstApart = std::max(losses.worstApart, apart);
        const double floats =
            rounding(map, receivers, receiver, wsOrigin + point.receiver - map.wsBase) +
            rounding(map, casters, caster, wsCaster - map.wsBase);
        if (!(apart <= use.greatestApart))
            (apart <= floats ? losses.coarse : losses.apart) += share;
        if (isMirrored(casters, point)) losses.mirrored += share;
    }
    return losses;
}

std::string describe(const Losses& losses) {
    if (!losses.finite) return "not finite";
    std::string text;
    const std::array<std::pair<const char*, double>, 6> kinds{{{"out", losses.outside},
                                                               {"w<=0", losses.behind},
                                                               {"clip", losses.clipped},
                                                               {"cull", losses.culled},
                                                               {"apart", losses.apart},
                                                               {"mirror", losses.mirrored}}};
    for (const auto& [name, percent] : kinds)
        if (percent > 0.0)
            text += fmt::format("{}{} {:.{}f}", text.empty() ? "" : ", ", name, percent,
                                percent < 9.95 ? 1 : 0);
    if (!text.empty()) return text;
    if (losses.unserved > 0.0) return fmt::format("ok but serves {:.1f}", 100.0 - losses.unserved);
    if (losses.coarse > 0.0)
        return fmt::format("ok within floats ({:.1f} texels)", losses.worstApart);
    return "ok";
}

} // namespace Lixel::Tests

#include "fit/core/Validity.h"

#include "fit/core/MapPlacement.h"

#include <Eigen/LU>

#include <algorithm>
#include <numbers>

namespace Lixel {
namespace {

/// Whether the matrix has an inverse, whatever unit its columns are in.
bool invertible(const Mat4& m) {
    const Eigen::RowVector4d norms = m.colwise().norm();
    if (!(norms.minCoeff() > 0.0)) return false;
    constexpr double Singular = 1e-12; // some thousand roundings of a determinant of unit columns
    return std::abs((m.array().rowwise() / norms.array()).matrix().determinant()) > Singular;
}

/// Whether the view matrix is a rigid motion, or one with a mirror: depths are measured with it.
bool isRigid(const Mat4& viewFromWorld) {
    // Far beyond what a float's quaternion drifts by until its owner normalises it.
    constexpr double Distortion = 0.01;
    const Mat3 rotation = viewFromWorld.topLeftCorner<3, 3>();
    const Mat3 product = rotation * rotation.transpose();
    return (product - Mat3::Identity()).cwiseAbs().maxCoeff() <= Distortion &&
           viewFromWorld.row(3) == Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0);
}

InvalidInput invalidLightInput(const ShadowLight& light) {
    if (!light.wsDirection.allFinite() || light.wsDirection.isZero(0.0))
        return InvalidInput::LightDirection;
    if (light.kind == LightKind::Directional) return InvalidInput::None;
    if (!light.wsPosition.allFinite() || light.wsPosition.cwiseAbs().maxCoeff() > GreatestExtent)
        return InvalidInput::LightPosition;
    if (!(light.nearDistance > 0.0) || !(light.nearDistance <= GreatestExtent))
        return InvalidInput::NearDistance;
    if (!(light.range > light.nearDistance)) return InvalidInput::Range;
    if (!(light.outerHalfAngle > 0.0) || !(light.outerHalfAngle < std::numbers::pi))
        return InvalidInput::Angle;
    return InvalidInput::None;
}

bool hasRoom(const ShadowProblem& problem) {
    return problem.mapWidth >= 1 && problem.mapHeight >= 1 && problem.filterRadius >= 0.0 &&
           2.0 * (leastBorder(problem.filterRadius) + GreatestBorderRounding) <
               std::min(problem.mapWidth, problem.mapHeight);
}

} // namespace

InvalidInput invalidInputOf(const ShadowProblem& problem) {
    const ShadowViewer& viewer = problem.viewer;
    if (problem.casters == nullptr || problem.receivers == nullptr) return InvalidInput::Bodies;
    if (!hasRoom(problem)) return InvalidInput::Map;
    if (!(viewer.shadowDistance >= 0.0)) return InvalidInput::ShadowDistance;
    if (const InvalidInput found = invalidLightInput(problem.light); found != InvalidInput::None)
        return found;
    if (problem.casters->invalid() != 0) return InvalidInput::CasterBox;
    if (problem.receivers->invalid() != 0) return InvalidInput::ReceiverBox;
    if (!viewer.viewFromWorld.allFinite() || !viewer.clipFromView.allFinite() ||
        !isRigid(viewer.viewFromWorld) || !invertible(viewer.clipFromView))
        return InvalidInput::View;
    return InvalidInput::None;
}

} // namespace Lixel

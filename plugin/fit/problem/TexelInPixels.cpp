#include "fit/problem/TexelInPixels.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Lixel {
namespace {

using Mat2 = Eigen::Matrix2d;

/// d(texel or pixel) / d(steps along two directions) as factor times a matrix.
struct Derivative {
    Mat2 matrix;
    double factor;
};

/// None where the point is not in front of the projection.
std::optional<Derivative> derivativeOf(const Mat4& clipFromWorld, const Vec2& size, const Vec3& ws,
                                       const Eigen::Matrix<double, 3, 2>& wsSteps) {
    const Vec4 clip = clipFromWorld * ws.homogeneous();
    if (!(clip.w() > 0.0)) return std::nullopt;
    const Eigen::Matrix<double, 4, 2> steps = clipFromWorld.leftCols<3>() * wsSteps;
    // x / w has the derivative (dx - x / w dw) / w.
    const Mat2 ndc = steps.topRows<2>() - (clip.head<2>() / clip.w()) * steps.row(3);
    return Derivative{size.asDiagonal() * ndc, 0.5 / clip.w()};
}

/// The greater singular value: in closed form, from the norm and the determinant.
double largestStretch(const Mat2& matrix) {
    const double squares = matrix.squaredNorm();
    const double twice = 2.0 * std::abs(matrix.determinant());
    return 0.5 * (std::sqrt(squares + twice) + std::sqrt(std::max(0.0, squares - twice)));
}

} // namespace

std::optional<double> texelInPixels(const ShadowFit& fit, const Vec2& mapSize,
                                    const ShadowViewer& viewer, const Vec2& pictureSize,
                                    const Vec3& ws, const Vec3& wsNormal) noexcept {
    if (!fit.hasMap() || wsNormal.isZero(0.0)) return std::nullopt;
    const Vec3 normal = wsNormal.stableNormalized();
    Eigen::Matrix<double, 3, 2> wsSteps;
    wsSteps.col(0) = normal.unitOrthogonal();
    wsSteps.col(1) = normal.cross(wsSteps.col(0));
    const auto texel = derivativeOf(fit.clipFromWorld, mapSize, ws, wsSteps);
    const auto pixel =
        derivativeOf(viewer.clipFromView * viewer.viewFromWorld, pictureSize, ws, wsSteps);
    if (!texel || !pixel) return std::nullopt;
    // 1 / σ_min(T P⁻¹) = σ_max(P T⁻¹), which needs no inverse of P. T is divided by its size, so
    // that neither under- nor overflows, whatever the unit.
    const double size = texel->matrix.norm();
    const Mat2 unit = texel->matrix / size;
    Mat2 adjugate;
    adjugate << unit(1, 1), -unit(0, 1), -unit(1, 0), unit(0, 0);
    const double determinant = std::abs(unit.determinant());
    if (determinant == 0.0) return std::numeric_limits<double>::infinity();
    const double m = largestStretch(pixel->matrix * adjugate) / determinant *
                     (pixel->factor / (texel->factor * size));
    if (std::isnan(m)) return std::nullopt;
    return m;
}

} // namespace Lixel

#include "OracleScenes.h"

#include <algorithm>
#include <cmath>

namespace Lixel::Samples {

using Eigen::Matrix4d;
using Eigen::Vector3d;

void addGround(TriangleScene& scene, const Vector3d& centre, double half, Triangle flags) {
    const Vector3d x(half, 0.0, 0.0);
    const Vector3d z(0.0, 0.0, half);
    scene.add(centre - x - z, centre - x + z, centre + x + z, flags);
    scene.add(centre - x - z, centre + x + z, centre + x - z, flags);
}

void addBox(TriangleScene& scene, const Vector3d& low, const Vector3d& high, Triangle flags) {
    const auto corner = [&](int i) {
        return Vector3d((i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                        (i & 4) != 0 ? high.z() : low.z());
    };
    const int sides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& side : sides) {
        scene.add(corner(side[0]), corner(side[1]), corner(side[2]), flags);
        scene.add(corner(side[0]), corner(side[2]), corner(side[3]), flags);
    }
}

Matrix4d lookAt(const Vector3d& eye, const Vector3d& target) {
    const Vector3d back = (eye - target).normalized();
    const Vector3d up = std::abs(back.y()) > 0.99 ? Vector3d(0, 0, -1) : Vector3d(0, 1, 0);
    const Vector3d right = up.cross(back).normalized();
    Matrix4d view = Matrix4d::Identity();
    view.block<1, 3>(0, 0) = right.transpose();
    view.block<1, 3>(1, 0) = back.cross(right).transpose();
    view.block<1, 3>(2, 0) = back.transpose();
    view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * eye;
    return view;
}

Matrix4d perspective(double fovY, double aspect, double near, double far) {
    const double f = 1.0 / std::tan(0.5 * fovY);
    Matrix4d projection = Matrix4d::Zero();
    projection(0, 0) = f / aspect;
    projection(1, 1) = f;
    projection(2, 2) = std::isinf(far) ? -1.0 : (far + near) / (near - far);
    projection(2, 3) = std::isinf(far) ? -2.0 * near : 2.0 * far * near / (near - far);
    projection(3, 2) = -1.0;
    return projection;
}

OracleView viewFrom(const Vector3d& eye, const Vector3d& target, double far) {
    OracleView view;
    view.width = 160;
    view.height = 120;
    view.vsFromWs = lookAt(eye, target);
    view.clipFromVs = perspective(1.0, 160.0 / 120.0, 0.1, far);
    return view;
}

OracleLight directional(const Vector3d& direction) {
    OracleLight light;
    light.direction = direction.normalized();
    return light;
}

std::optional<Vector3d> groundPoint(const OracleView& view, int column, int row) {
    const Matrix4d wsFromClip = (view.clipFromVs * view.vsFromWs).inverse();
    const double x = (column + 0.5) / view.width * 2.0 - 1.0;
    const double y = 1.0 - (row + 0.5) / view.height * 2.0;
    const Vector3d a = (wsFromClip * Eigen::Vector4d(x, y, -1.0, 1.0)).hnormalized();
    const Vector3d b = (wsFromClip * Eigen::Vector4d(x, y, 0.0, 1.0)).hnormalized();
    const double t = a.y() / (a.y() - b.y());
    return t > 0.0 ? std::optional<Vector3d>(a + t * (b - a)) : std::nullopt;
}

std::size_t count(const ShadowTruth& truth, PixelClass wanted) {
    return static_cast<std::size_t>(std::count(truth.pixels.begin(), truth.pixels.end(), wanted));
}

} // namespace Lixel::Samples

#include "fit/focus/LightImage.h"

#include <Eigen/Geometry>

namespace Lixel {

LightImage::LightImage(const ShadowLight& light)
    : mWsEye(light.kind == LightKind::Directional ? Vec3(Vec3::Zero()) : light.wsPosition),
      mDirectional(light.kind == LightKind::Directional) {
    // Orthonormal basis from one vector: Duff et al., "Building an Orthonormal Basis, Revisited"
    // (2017), listing 3. Continuous, except for one jump where z of the direction changes its sign.
    const Vec3 z = -light.wsDirection.stableNormalized();
    const double sign = std::copysign(1.0, z.z());
    const double a = -1.0 / (sign + z.z());
    const double b = z.x() * z.y() * a;
    mLsFromWs.row(0) = Vec3(1.0 + sign * z.x() * z.x() * a, sign * b, -sign * z.x());
    mLsFromWs.row(1) = Vec3(b, sign + z.y() * z.y() * a, -z.y());
    mLsFromWs.row(2) = z;
}

Vec4 LightImage::wsLight() const {
    if (mDirectional) return Vec4(mLsFromWs(2, 0), mLsFromWs(2, 1), mLsFromWs(2, 2), 0.0);
    return mWsEye.homogeneous();
}

Eigen::Matrix<double, 4, 3> LightImage::wsFromOriented() const {
    Eigen::Matrix<double, 4, 3> result;
    result.topRows<3>() = mLsFromWs.transpose();
    result.row(3).setZero();
    if (mDirectional) {
        // In the plane through light space's origin.
        result.col(2) = mWsEye.homogeneous();
    } else {
        // At infinity, along the ray.
        result.col(2) *= -1.0;
    }
    return result;
}

} // namespace Lixel

#pragma once

#include "fit/problem/ShadowProblem.h"

namespace Lixel {

/** The light image: the plane in which every light ray is one point.

    ℓ(x) = Λx for world points x, with the light as the kernel of Λ: (X, Y, 1) for a directional
    light, (X, Y, -Z) for a local one, both in light space (`ls`, looking along -z).
*/
class LightImage {
public:
    LightImage() = default;
    /// Light space is turned about the light's axis by an arbitrary but fixed rule of the
    /// direction alone: a fit chooses its own axes in the image, so the roll never shows.
    explicit LightImage(const ShadowLight& light);

    bool directional() const { return mDirectional; }
    const Mat3& lsFromWs() const { return mLsFromWs; }
    const Vec3& wsEye() const { return mWsEye; }

    Vec3 lsFromPoint(const Vec3& ws) const { return mLsFromWs * (ws - mWsEye); }
    Vec3 lsFromDirection(const Vec3& ws) const { return mLsFromWs * ws; }

    /// The light as a homogeneous point, in world axes: the kernel of Λ. Towards the light, of
    /// length 1, for a directional one.
    Vec4 wsLight() const;
    /// A right inverse of Λ: homogeneous points, in world axes, on the rays ℓ. A linear map that is
    /// zero at the light, times this, is that map as a function of ℓ.
    Eigen::Matrix<double, 4, 3> wsFromOriented() const;

    /// ℓ of a light-space point.
    Vec3 oriented(const Vec3& ls) const { return {ls.x(), ls.y(), mDirectional ? 1.0 : -ls.z()}; }
    /// ℓ of a light-space direction: what the point gains per unit of travel.
    Vec3 orientedDirection(const Vec3& ls) const {
        return {ls.x(), ls.y(), mDirectional ? 0.0 : -ls.z()};
    }
    /// The image of a light-space point; a local light's points must have -z > 0.
    Vec2 project(const Vec3& ls) const {
        return mDirectional ? Vec2(ls.head<2>()) : Vec2(ls.head<2>() / -ls.z());
    }

private:
    Mat3 mLsFromWs = Mat3::Identity();
    Vec3 mWsEye = Vec3::Zero();
    bool mDirectional = true;
};

} // namespace Lixel

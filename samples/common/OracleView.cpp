#include "common/OracleView.h"

#include <Ogre.h>

namespace Lixel::Samples {
namespace {

Eigen::Vector3d toEigen(const Ogre::Vector3& v) {
    return Eigen::Vector3f(v.x, v.y, v.z).cast<double>();
}

template <typename Matrix>
Eigen::Matrix4d toEigen(const Matrix& m) {
    Eigen::Matrix4d matrix;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix(row, column) = static_cast<double>(m[row][column]);
    return matrix;
}

} // namespace

OracleView oracleView(const Ogre::Camera& camera, int width, int height, double shadowDistance,
                      const Eigen::Vector3d& wsOrigin) {
    OracleView view;
    view.width = width;
    view.height = height;
    view.shadowDistance = shadowDistance;
    view.clipFromVs = toEigen(camera.getProjectionMatrix());
    Eigen::Affine3d fromOrigin = Eigen::Affine3d::Identity();
    if (camera.isCustomViewMatrixEnabled()) {
        fromOrigin.translation() = wsOrigin;
        view.vsFromWs = toEigen(camera.getViewMatrix()) * fromOrigin.matrix();
        return view;
    }
    const Ogre::Quaternion& q = camera.getDerivedOrientation();
    const Eigen::Quaterniond wsFromVs =
        Eigen::Quaternionf(q.w, q.x, q.y, q.z).cast<double>().normalized();
    fromOrigin.translation() = wsOrigin - toEigen(camera.getDerivedPosition());
    view.vsFromWs = (Eigen::Affine3d(wsFromVs.conjugate()) * fromOrigin).matrix();
    return view;
}

OracleLight oracleLight(const Ogre::Light& light, const Eigen::Vector3d& wsOrigin) {
    OracleLight result;
    switch (light.getType()) {
    case Ogre::Light::LT_DIRECTIONAL:
        result.kind = OracleLight::Kind::Directional;
        break;
    case Ogre::Light::LT_SPOTLIGHT:
        result.kind = OracleLight::Kind::Spot;
        break;
    case Ogre::Light::LT_POINT:
        result.kind = OracleLight::Kind::Point;
        break;
    default:
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS, "the oracle knows no light with an extent",
                    "oracleLight");
    }
    result.direction = toEigen(light.getDerivedDirection()).normalized();
    result.position = toEigen(light.getDerivedPosition()) - wsOrigin;
    result.innerAngle = static_cast<double>(light.getSpotlightInnerAngle().valueRadians());
    result.outerAngle = static_cast<double>(light.getSpotlightOuterAngle().valueRadians());
    if (result.kind != OracleLight::Kind::Directional)
        result.range = static_cast<double>(light.getAttenuationRange());
    return result;
}

} // namespace Lixel::Samples

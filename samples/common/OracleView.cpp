#include "common/OracleView.h"

#include <Lixel/scene/OgreMath.h>

#include <Ogre.h>

namespace Lixel::Samples {

OracleView oracleView(const Ogre::Camera& camera, int width, int height, double shadowDistance,
                      const Eigen::Vector3d& wsOrigin) {
    OracleView view;
    view.width = width;
    view.height = height;
    view.shadowDistance = shadowDistance;
    view.clipFromVs = toDouble(camera.getProjectionMatrix());
    Eigen::Affine3d fromOrigin = Eigen::Affine3d::Identity();
    if (camera.isCustomViewMatrixEnabled()) {
        fromOrigin.translation() = wsOrigin;
        view.vsFromWs = toDouble(camera.getViewMatrix()) * fromOrigin.matrix();
        return view;
    }
    const Ogre::Quaternion& q = camera.getDerivedOrientation();
    const Eigen::Quaterniond wsFromVs =
        Eigen::Quaternionf(q.w, q.x, q.y, q.z).cast<double>().normalized();
    fromOrigin.translation() = wsOrigin - toDouble(camera.getDerivedPosition());
    view.vsFromWs = (Eigen::Affine3d(wsFromVs.conjugate()) * fromOrigin).matrix();
    return view;
}

OracleLight oracleLight(const Ogre::Light& light, const Eigen::Vector3d& wsOrigin) {
    // A light hears that its node was moved when the node is asked where it is.
    if (const Ogre::Node* const node = light.getParentNode()) node->_getDerivedPosition();
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
    result.direction = toDouble(light.getDerivedDirection()).normalized();
    result.position = toDouble(light.getDerivedPosition()) - wsOrigin;
    result.outerAngle = static_cast<double>(light.getSpotlightOuterAngle().valueRadians());
    if (result.kind != OracleLight::Kind::Directional)
        result.range = static_cast<double>(light.getAttenuationRange());
    return result;
}

CasterFaces casterFaces(const Ogre::SceneManager& sceneManager) {
    return sceneManager.getShadowCasterRenderBackFaces() ? CasterFaces::Backs : CasterFaces::Fronts;
}

} // namespace Lixel::Samples

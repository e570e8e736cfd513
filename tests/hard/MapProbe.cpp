#include "MapProbe.h"

namespace Lixel::Tests {
namespace {

Eigen::Vector3d toEigen(const Ogre::Vector3& v) {
    return Eigen::Vector3f(v.x, v.y, v.z).cast<double>();
}

Eigen::Matrix4f toEigen(const Ogre::Matrix4& m) {
    Eigen::Matrix4f matrix;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix(row, column) = m[row][column];
    return matrix;
}

/// Multiplied in floats, as OGRE does.
Eigen::Matrix4d product(const Ogre::Matrix4& projection, const Ogre::Affine3& view) {
    return (toEigen(projection) * toEigen(Ogre::Matrix4(view))).cast<double>();
}

DrawnMatrix casterMatrix(const Ogre::Camera& camera, bool cameraRelative) {
    Ogre::Affine3 view = camera.getViewMatrix(true);
    if (!cameraRelative) return {product(camera.getProjectionMatrix(), view), {0, 0, 0}};
    // What OGRE draws is then relative to the camera that draws it.
    view.setTrans(Ogre::Vector3::ZERO);
    return {product(camera.getProjectionMatrix(), view), toEigen(camera.getDerivedPosition())};
}

/// OGRE's texture_viewproj_matrix, without its last step from clip space to the picture.
DrawnMatrix projectorMatrix(const Ogre::Camera& camera, const Ogre::Camera& viewer,
                            bool cameraRelative) {
    if (!cameraRelative)
        return {product(camera.getProjectionMatrix(), camera.getViewMatrix(true)), {0, 0, 0}};
    Ogre::Matrix4 relative;
    camera.calcViewMatrixRelative(viewer.getDerivedPosition(), relative);
    return {(toEigen(camera.getProjectionMatrix()) * toEigen(relative)).cast<double>(),
            toEigen(viewer.getDerivedPosition())};
}

/// What Lixel's receivers are handed.
DrawnMatrix fittedMatrix(const ShadowMap& fitted, bool cameraRelative) {
    DrawnMatrix drawn;
    if (cameraRelative) drawn.wsBase = toEigen(fitted.viewer.getDerivedPosition());
    Eigen::Affine3d originFromBase = Eigen::Affine3d::Identity();
    originFromBase.translation() = drawn.wsBase - fitted.wsOrigin;
    drawn.clipFromBase =
        (fitted.fit.clipFromWorld * originFromBase.matrix()).cast<float>().cast<double>();
    return drawn;
}

} // namespace

Eigen::Matrix4d DrawnMatrix::relativeTo(const Eigen::Vector3d& wsOrigin) const {
    Eigen::Affine3d baseFromOrigin = Eigen::Affine3d::Identity();
    baseFromOrigin.translation() = wsOrigin - wsBase;
    return clipFromBase * baseFromOrigin.matrix();
}

MapProbe::MapProbe(HardScene& scene, bool lixel) : mScene(scene), mLixel(lixel) {
    // Among no render queues at all: objects are found, and none is drawn.
    scene.manager().setSpecialCaseRenderQueueMode(Ogre::SceneManager::SCRQM_INCLUDE);
    addShadowMapObserver(*this);
}

MapProbe::~MapProbe() {
    removeShadowMapObserver(*this);
}

void MapProbe::shadowMapFitted(const ShadowMap& fitted) {
    if (&fitted.light != mScene.light || fitted.iteration != 0) return;
    ProbedMap& probed = map.emplace();
    probed.reason = fitted.fit.reason;
    probed.width = fitted.width;
    probed.height = fitted.height;
    const bool relative = mScene.manager().getCameraRelativeRendering();
    probed.casters = casterMatrix(fitted.shadowCamera, relative);
    probed.receivers = mLixel ? fittedMatrix(fitted, relative)
                              : projectorMatrix(fitted.shadowCamera, fitted.viewer, relative);
    if (!fitted.fit.hasMap()) return;
    for (const char* const type : {"Entity", "ManualObject"})
        for (const auto& [name, object] : mScene.manager().getMovableObjects(type)) {
            if (!object->getCastShadows() || !object->isInScene()) continue;
            const Ogre::AxisAlignedBox& box = object->getWorldBoundingBox(true);
            const bool drawn = fitted.shadowCamera.isVisible(box);
            if (!box.isFinite()) continue;
            Eigen::AlignedBox3d grown(toEigen(box.getMinimum()), toEigen(box.getMaximum()));
            const Eigen::Vector3d margin =
                Eigen::Vector3d::Constant(1e-3 * grown.diagonal().norm());
            grown = Eigen::AlignedBox3d(grown.min() - margin, grown.max() + margin);
            (drawn ? probed.wsDrawn : probed.wsCulled).push_back(grown);
        }
}

} // namespace Lixel::Tests

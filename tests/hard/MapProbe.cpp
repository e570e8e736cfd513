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

/// Clip space from object: what OGRE hands to caster programs, multiplied in floats in its order.
Eigen::Matrix4d casterMatrix(const Ogre::Camera& camera, const Ogre::Matrix4& wsFromObject,
                             bool cameraRelative) {
    Ogre::Affine3 view = camera.getViewMatrix(true);
    Ogre::Matrix4 world = wsFromObject;
    if (cameraRelative) {
        // Then all is relative to the camera that draws.
        view.setTrans(Ogre::Vector3::ZERO);
        world.setTrans(world.getTrans() - camera.getDerivedPosition());
    }
    const Eigen::Matrix4f vsFromObject = toEigen(Ogre::Matrix4(view)) * toEigen(world);
    return (toEigen(camera.getProjectionMatrix()) * vsFromObject).cast<double>();
}

ProbedCaster probeCaster(const Ogre::MovableObject& object, const Ogre::Camera& camera,
                         bool cameraRelative) {
    ProbedCaster caster;
    const Ogre::AxisAlignedBox& box = object.getWorldBoundingBox(true);
    caster.drawn = camera.isVisible(box);
    const Eigen::Vector3d infinite =
        Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    caster.wsBox = {-infinite, infinite};
    if (box.isFinite()) caster.wsBox = {toEigen(box.getMinimum()), toEigen(box.getMaximum())};
    const Ogre::Matrix4 wsFromObject = object.getParentSceneNode()->_getFullTransform();
    caster.wsFromObject.matrix() = toEigen(wsFromObject).cast<double>();
    caster.clipFromObject = casterMatrix(camera, wsFromObject, cameraRelative);
    return caster;
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

/// A fit's rows, as Lixel's receivers are handed them: for positions relative to `wsBase`.
template <typename Rows>
Rows drawnRows(const Rows& rows, const ShadowMap& fitted, const Eigen::Vector3d& wsBase) {
    Eigen::Affine3d originFromBase = Eigen::Affine3d::Identity();
    originFromBase.translation() = wsBase - fitted.wsOrigin;
    return Rows(rows * originFromBase.matrix()).template cast<float>().template cast<double>();
}

} // namespace

Eigen::Matrix4d DrawnMatrix::relativeTo(const Eigen::Vector3d& wsOrigin) const {
    Eigen::Affine3d baseFromOrigin = Eigen::Affine3d::Identity();
    baseFromOrigin.translation() = wsOrigin - wsBase;
    return clipFromBase * baseFromOrigin.matrix();
}

std::size_t servingMap(const std::vector<ProbedMap>& maps, const Eigen::Vector3d& ws) {
    const auto share = [&](const ProbedMap& map) {
        return map.wsShare.dot((ws - map.wsBase).homogeneous().transpose());
    };
    std::size_t serving = 0;
    for (std::size_t i = 1; i < maps.size(); ++i)
        if (share(maps[i]) > share(maps[serving])) serving = i;
    return serving;
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
    if (&fitted.light != mScene.light) return;
    if (fitted.iteration == 0) maps.clear();
    ProbedMap& probed = maps.emplace_back();
    probed.reason = fitted.fit.reason;
    probed.wsServed.assign(fitted.fit.wsServed.begin(),
                           fitted.fit.wsServed.begin() +
                               static_cast<std::ptrdiff_t>(fitted.fit.servedCount));
    probed.wsFitOrigin = fitted.wsOrigin;
    probed.width = fitted.width;
    probed.height = fitted.height;
    const bool relative = mScene.manager().getCameraRelativeRendering();
    if (relative) probed.wsBase = toEigen(fitted.viewer.getDerivedPosition());
    probed.wsShare =
        drawnRows<Eigen::RowVector4d>(fitted.part.wsRow.transpose(), fitted, probed.wsBase);
    probed.receivers =
        mLixel
            ? DrawnMatrix{drawnRows(fitted.fit.clipFromWorld, fitted, probed.wsBase), probed.wsBase}
            : projectorMatrix(fitted.shadowCamera, fitted.viewer, relative);
    if (!fitted.fit.hasMap()) return;
    for (const char* const type : {"Entity", "ManualObject"})
        for (const auto& [name, object] : mScene.manager().getMovableObjects(type))
            if (object->getCastShadows() && object->isInScene())
                probed.casters.push_back(probeCaster(*object, fitted.shadowCamera, relative));
}

} // namespace Lixel::Tests

#include "common/MapCapture.h"

#include <Lixel/scene/OgreVersions.h>
#include <Lixel/setup/ShadowPass.h>

#include <OgreCamera.h>
#include <OgreRenderSystem.h>

#include <cmath>

namespace Lixel::Samples {
namespace {

/** Frames until OGRE's setups have settled: the first finds what the viewer sees, the second what
    the shadow camera sees that is set up from it, the third is set up from both. */
constexpr int SettlingFrames = 3;

/// Rows that programs multiply world positions with, as rows for positions relative to `wsOrigin`.
/// Programs get them as floats.
template <typename Rows>
Rows fromOrigin(const Rows& rows, const ShadowMap& map, const Eigen::Vector3d& wsOrigin) {
    Eigen::Affine3d fitFromWorld = Eigen::Affine3d::Identity();
    fitFromWorld.translation() = -map.wsOrigin;
    Eigen::Affine3d worldFromOrigin = Eigen::Affine3d::Identity();
    worldFromOrigin.translation() = wsOrigin;
    const Rows drawn =
        (rows * fitFromWorld.matrix()).template cast<float>().template cast<double>();
    return drawn * worldFromOrigin.matrix();
}

} // namespace

MapCapture::MapCapture(Stage& stage) : mStage(stage), mClock(stage), mWork(mClock) {
    setDrawing(false);
    addSceneManagerListener(mStage.sceneManager(), *this);
    addShadowMapObserver(*this);
}

MapCapture::~MapCapture() {
    removeShadowMapObserver(*this);
    removeSceneManagerListener(mStage.sceneManager(), *this);
    setDrawing(true);
    if (mMapSize > 0) setMaps(mMapSize, 1); // else nothing was captured, and nothing changed
}

void MapCapture::setDrawing(bool on) {
    // Among no render queues at all: objects are found, and none is drawn.
    mStage.sceneManager().setSpecialCaseRenderQueueMode(on ? Ogre::SceneManager::SCRQM_EXCLUDE
                                                           : Ogre::SceneManager::SCRQM_INCLUDE);
}

void MapCapture::setMaps(int mapSize, std::size_t count) {
    if (mapSize == mMapSize && count == mMapCount) return;
    mWork.leaveTargets();
    Ogre::SceneManager& manager = mStage.sceneManager();
    // Elsewhere OGRE draws one map a light.
    manager.setShadowTechnique(count > 1 ? Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED
                                         : Ogre::SHADOWTYPE_TEXTURE_ADDITIVE);
    const double side = mapSize / std::sqrt(static_cast<double>(count));
    for (const auto type :
         {Ogre::Light::LT_DIRECTIONAL, Ogre::Light::LT_SPOTLIGHT, Ogre::Light::LT_POINT})
        manager.setShadowTextureCountPerLightType(type, count);
    manager.setShadowTextureSettings(static_cast<Ogre::ushort>(std::lround(side)),
                                     static_cast<Ogre::ushort>(count), Ogre::PF_FLOAT32_R);
    mMapSize = mapSize;
    mMapCount = count;
}

std::vector<EmulatedMap> MapCapture::capture(const NamedSetup& setup, int mapSize,
                                             double shadowDistance,
                                             const Eigen::Vector3d& wsOrigin) {
    begin(setup, mapSize, shadowDistance, wsOrigin);
    return nextFrame().maps;
}

void MapCapture::begin(const NamedSetup& setup, int mapSize, double shadowDistance,
                       const Eigen::Vector3d& wsOrigin) {
    mSetup = setup;
    mShadowDistance = shadowDistance;
    mOrigin = wsOrigin;
    const Ogre::ShadowCameraSetupPtr instance = setup.create();
    const bool fitted = dynamic_cast<FittedShadowCameraSetup*>(instance.get()) != nullptr;
    // Lixel's setups clamp where the render system can.
    mClampsDepth = (fitted || ogreClampsDepth(mStage.light())) && canClampDepth();
    setMaps(mapSize, setup.maps);
    mStage.setShadowSetup(instance);
    const int frames = fitted ? 0 : SettlingFrames - 1;
    for (int i = 0; i < frames; ++i)
        nextFrame();
}

CapturedFrame MapCapture::nextFrame(Draws draws) {
    return takeFrame(draws, [this] { mStage.drawFrame(); });
}

std::vector<std::uint8_t> MapCapture::nextVisibility() {
    std::vector<std::uint8_t> visibility;
    takeFrame(Draws::Everything, [&] { visibility = mStage.drawVisibility(); });
    return visibility;
}

CapturedFrame MapCapture::takeFrame(Draws draws, const std::function<void()>& draw) {
    mFrame = {};
    mReason = FitReason::None;
    mFrame.maps.assign(mSetup.maps, EmulatedMap{});
    mWork.beginFrame();
    // Maps are planned alike whether they are drawn or not: it is switched off after that.
    mDraws = draws;
    setDrawing(true);
    draw();
    setDrawing(false);
    mFrame.surveyMicroseconds = mWork.survey;
    mFrame.fitMicroseconds = mWork.fit;
    mFrame.casterMilliseconds = mWork.caster;
    if (mSetup.splitDepths) {
        const std::vector<double> depths = mSetup.splitDepths(mStage.camera(), mShadowDistance);
        for (std::size_t i = 0; i < mSetup.maps; ++i) {
            mFrame.maps[i].beginDepth = i == 0 ? 0.0 : depths.at(i);
            mFrame.maps[i].endDepth = depths.at(i + 1);
        }
    }
    return mFrame;
}

void MapCapture::shadowMapFitted(const ShadowMap& map) {
    if (mDraws == Draws::Nothing) setDrawing(false);
    if (&map.light != &mStage.light() || map.iteration >= mFrame.maps.size()) return;
    if (mReason == FitReason::None) mReason = map.fit.reason;
    const bool isDrawn =
        map.decision.plan == MapPlan::Draw || map.decision.plan == MapPlan::DrawMoving;
    mFrame.mapsDrawn += isDrawn ? 1 : 0;
    EmulatedMap& emulated = mFrame.maps[map.iteration];
    emulated.width = map.width;
    emulated.height = map.height;
    emulated.clampsDepth = mClampsDepth;
    emulated.depthPerWorldUnit = map.fit.depthPerWorldUnit;
    emulated.wsShare = fromOrigin<Eigen::RowVector4d>(map.part.wsRow.transpose(), map, mOrigin);
    if (map.fit.hasMap()) emulated.clipFromWs = fromOrigin(map.fit.clipFromWorld, map, mOrigin);
}

} // namespace Lixel::Samples

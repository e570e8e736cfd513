#include "BenchWatch.h"

#include "FinishDrawing.h"

#include <OgreHardwarePixelBuffer.h>
#include <OgreRenderTexture.h>

namespace Lixel::Tests {
namespace {

template <typename TimePoint>
double microsecondsSince(TimePoint begin) {
    return std::chrono::duration<double, std::micro>(TimePoint::clock::now() - begin).count();
}

} // namespace

BenchWatch::BenchWatch(BenchScene& scene) : mScene(scene), mMap(scene.shadowMap()) {
    addSceneManagerListener(scene.manager(), *this);
    addShadowMapObserver(*this);
    mMap->getBuffer()->getRenderTarget()->addListener(this);
}

BenchWatch::~BenchWatch() {
    mMap->getBuffer()->getRenderTarget()->removeListener(this);
    removeSceneManagerListener(mScene.manager(), *this);
}

void BenchWatch::begin() {
    finishIfAsked();
    mTimes = {};
    mFrameBegin = Clock::now();
}

BenchTimes BenchWatch::end() {
    finishIfAsked();
    mTimes.frame = microsecondsSince(mFrameBegin);
    return mTimes;
}

void BenchWatch::preFindVisibleObjects(Ogre::SceneManager*,
                                       Ogre::SceneManager::IlluminationRenderStage,
                                       Ogre::Viewport*) {
    mFindBegin = Clock::now();
}

void BenchWatch::postFindVisibleObjects(Ogre::SceneManager*,
                                        Ogre::SceneManager::IlluminationRenderStage stage,
                                        Ogre::Viewport*) {
    const bool isMap = stage == Ogre::SceneManager::IRS_RENDER_TO_TEXTURE;
    (isMap ? mTimes.findMap : mTimes.find) += microsecondsSince(mFindBegin);
}

void BenchWatch::shadowMapFitted(const ShadowMap& map) {
    if (&map.sceneManager != &mScene.manager()) return;
    mTimes.survey += map.surveyMicroseconds;
    mTimes.casters += map.casterMicroseconds;
    mTimes.fit += map.fitMicroseconds;
    mTimes.plan = map.decision.plan;
}

void BenchWatch::preRenderTargetUpdate(const Ogre::RenderTargetEvent&) {
    mTimes.untilMap = microsecondsSince(mFrameBegin);
    finishIfAsked();
    mMapBegin = Clock::now();
}

void BenchWatch::postRenderTargetUpdate(const Ogre::RenderTargetEvent&) {
    mTimes.mapCalls += microsecondsSince(mMapBegin);
    finishIfAsked();
    if (mFinishes) mTimes.map += microsecondsSince(mMapBegin);
}

void BenchWatch::finishIfAsked() const {
    if (mFinishes) finishDrawing();
}

} // namespace Lixel::Tests

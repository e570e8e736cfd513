#include "common/ShadowWork.h"

#include <Ogre.h>

#include <algorithm>

namespace Lixel::Samples {

RenderClock::RenderClock(Stage& stage)
    : mStage(stage),
      mClock(stage.glRenderer().find("llvmpipe") != std::string::npos ||
                     stage.glRenderer().find("softpipe") != std::string::npos
                 ? CLOCK_PROCESS_CPUTIME_ID
                 : CLOCK_MONOTONIC) {}

double RenderClock::now() {
    mStage.finish();
    timespec time{};
    clock_gettime(mClock, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

ShadowWork::ShadowWork(RenderClock& clock) : mClock(clock) {
    addShadowMapObserver(*this);
}

ShadowWork::~ShadowWork() {
    removeShadowMapObserver(*this);
    leaveTargets();
}

void ShadowWork::leaveTargets() {
    for (Ogre::RenderTarget* target : mTargets)
        target->removeListener(this);
    mTargets.clear();
}

void ShadowWork::shadowMapFitted(const ShadowMap& map) {
    survey += map.surveyMicroseconds + map.casterMicroseconds;
    fit += map.fitMicroseconds;
    reason = toString(map.fit.reason);
    Ogre::RenderTarget* const target = map.shadowCamera.getViewport()->getTarget();
    if (std::find(mTargets.begin(), mTargets.end(), target) == mTargets.end()) {
        mTargets.push_back(target);
        target->addListener(this);
    }
}

} // namespace Lixel::Samples

// Whether and how a map that is fitted and placed is drawn.
#include "setup/FittedSetupRequest.h"

#include "fit/focus/ViewVolume.h"
#include "setup/MapProof.h"
#include "setup/MapQueue.h"
#include "setup/PlannedMap.h"
#include "setup/SetupMemory.h"
#include "setup/ShadowCameraPlacement.h"
#include "setup/ShadowMapObserver.h"
#include "setup/ShadowPass.h"
#include "setup/StillLayer.h"

#include <OgreCamera.h>
#include <OgreLight.h>
#include <OgreRoot.h>

#include <cmath>
#include <utility>

namespace Lixel {
namespace {

/// From the viewer to the middle of the slice that was fitted last, or to the lamp; 0 for a sun's
/// whole view and for strips of its image.
double distanceTo(const LightMemory& memory, const ShadowProblem& problem) {
    if (problem.light.kind != LightKind::Directional)
        return (problem.light.wsPosition - wsEyeOf(problem.viewer)).norm();
    const auto end = [&](std::size_t part) { return memory.parts.parts[part].vsEnd; };
    const std::size_t part = memory.nextPart - 1;
    const double vsBegin = part == 0 ? 0.0 : end(part - 1);
    if (!std::isfinite(vsBegin)) return 0.0;
    return std::isfinite(end(part)) ? (vsBegin + end(part)) / 2.0 : 2.0 * vsBegin;
}

/// A map is not drawn in layers this time.
void restLayer(LightMemory& memory, std::size_t iteration) {
    if (StillLayer* const layer = memory.layers.at(iteration).get()) layer->rest();
}

} // namespace

void FittedShadowCameraSetup::publish(const Request& request, const ShadowProblem& problem,
                                      const ShownMap& shown, const MapDecision& decision,
                                      const FitTimes& times) const {
    publishShadowMap({.sceneManager = *request.viewer.getSceneManager(),
                      .viewer = request.viewer,
                      // OGRE hands out its own, mutable light as const.
                      .light = const_cast<Ogre::Light&>(request.light),
                      .shadowCamera = request.shadowCamera,
                      .iteration = request.iteration,
                      .part = shown.part,
                      .fit = shown.fit,
                      .decision = decision,
                      .wsOrigin = shown.wsOrigin,
                      .width = problem.mapWidth,
                      .height = problem.mapHeight,
                      .depthBias = mCommon.depthBias,
                      .surveyMicroseconds = times.survey,
                      .casterMicroseconds = times.casters,
                      .fitMicroseconds = times.fit});
}

bool FittedShadowCameraSetup::isBelieved(const Request& request, const ShadowTarget& target,
                                         const LightMemory& memory) const {
    const StillMap* const map = memory.still.believed(request.iteration);
    if (map == nullptr) return false;
    const ShownMap& shown = map->shown;
    if (!shown.fit.hasMap()) {
        const MapContent* const content = contentOf(target);
        return content != nullptr && content->empty;
    }
    const auto readCasters = [&]() -> const CasterFingerprint& { return map->casters; };
    placeShadowCamera(request.shadowCamera, shown.fit, shown.wsOrigin);
    return mCommon.reuseMaps &&
           planMap(request.shadowCamera, request.viewport, shown.fit, target, true, readCasters)
                   .decision.plan == MapPlan::Reuse;
}

bool FittedShadowCameraSetup::postpones(const Request& request, const ShadowProblem& problem,
                                        const ShadowTarget& target, const PlannedMap& planned,
                                        LightMemory& memory, const ShownMap& wanted) const {
    if (!mapBudget().isLimited() || !planned.content) return false;
    const MapQueue::Key key(&memory, request.iteration);
    const unsigned long frame = Ogre::Root::getSingleton().getNextFrameNumber();
    std::unique_ptr<DrawnMap>& drawn = memory.drawn.at(request.iteration);
    if (planned.decision.plan == MapPlan::Reuse) {
        mapQueue().rest(key, frame, mapBudget());
        return false;
    }
    Fingerprint light;
    addLight(problem, light);
    const MapContent* const content = contentOf(target);
    const bool isKept = drawn && content != nullptr && !content->empty &&
                        content->matrices == drawn->matrices &&
                        content->settings == planned.content->settings;
    MapQueue::Wish wish;
    // The queue forgets maps that are not asked for in each frame.
    wish.must = !isKept || frame - drawn->frame > mapBudget().oldest;
    wish.distance = distanceTo(memory, problem);
    wish.milliseconds = drawingTimeOf(target);
    if (isKept)
        wish.wrongness =
            wrongnessOf(*drawn, wanted, light, planned.decision.reason != PlanReason::MapChanged);
    if (!mapQueue().ask(key, frame, wish, mapBudget())) return true;
    if (!drawn) drawn = std::make_unique<DrawnMap>();
    *drawn = {wanted, planned.content->matrices, light, frame};
    return false;
}

StillLayer* FittedShadowCameraSetup::planLayer(const Request& request, const ShadowTarget& target,
                                               PlannedMap& planned, LightMemory& memory,
                                               const MapCasters& casters) const {
    std::unique_ptr<StillLayer>& layer = memory.layers.at(request.iteration);
    MapDecision& decision = planned.decision;
    const bool isForCasters =
        decision.plan == MapPlan::Draw && (decision.reason == PlanReason::CastersChanged ||
                                           decision.reason == PlanReason::RestlessCaster);
    if (!mCommon.movingApart || !canDrawInLayers(*request.shadowCamera.getSceneManager(), target)) {
        layer.reset();
        return nullptr;
    }
    if (!isForCasters || casters.each == nullptr) {
        restLayer(memory, request.iteration);
        return nullptr;
    }
    if (!layer) layer = std::make_unique<StillLayer>();
    // As they were read for these reasons.
    switch (layer->plan(*casters.each, memory.volumes.at(request.iteration), *planned.content)) {
    case MapDrawing::Whole:
        return nullptr;
    case MapDrawing::Fill:
        break;
    case MapDrawing::Moving:
        decision.plan = MapPlan::DrawMoving;
        break;
    }
    return layer.get();
}

MapDecision FittedShadowCameraSetup::draw(const Request& request, const ShadowProblem& problem,
                                          const ShadowTarget& target, LightMemory& memory,
                                          const MapCasters& casters, bool believed,
                                          ShownMap& shown) const {
    if (!shown.fit.hasMap()) {
        if (mapBudget().isLimited())
            mapQueue().rest({&memory, request.iteration},
                            Ogre::Root::getSingleton().getNextFrameNumber(), mapBudget());
        restLayer(memory, request.iteration);
        skipShadowPass(request.shadowCamera, target, believed);
        return {MapPlan::Skip, PlanReason::NothingShadowed, {}};
    }
    CasterVolume& volume = memory.volumes.at(request.iteration);
    volume.set(shown.fit, shown.wsOrigin);
    PlannedMap planned = mCommon.reuseMaps
                             ? planMap(request.shadowCamera, request.viewport, shown.fit, target,
                                       casters.readsAtOnce, casters.read)
                             : PlannedMap{{MapPlan::Draw, PlanReason::Forbidden, {}}, {}};
    if (postpones(request, problem, target, planned, memory, shown)) {
        shown = memory.drawn.at(request.iteration)->shown;
        placeShadowCamera(request.shadowCamera, shown.fit, shown.wsOrigin);
        volume.set(shown.fit, shown.wsOrigin);
        keepShadowPass(request.shadowCamera, volume);
        restLayer(memory, request.iteration);
        return {MapPlan::Reuse, PlanReason::Postponed, {}};
    }
    StillLayer* const layer = planLayer(request, target, planned, memory, casters);
    const bool keeps = planned.decision.plan == MapPlan::Reuse;
    if (isProofMode() && (keeps || believed))
        proveShadowPass(request.shadowCamera, volume, planned.content, target);
    else if (keeps)
        keepShadowPass(request.shadowCamera, volume);
    else
        armShadowPass(request.shadowCamera, volume, planned.content, layer);
    return std::move(planned.decision);
}

} // namespace Lixel

#include "setup/FittedShadowCameraSetup.h"

#include "scene/CasterSearch.h"
#include "scene/CasterVolume.h"
#include "scene/OgreMath.h"
#include "scene/SurveyCache.h"
#include "setup/LightGuard.h"
#include "setup/ShadowMapObserver.h"
#include "setup/ShadowPass.h"

#include <OgreCamera.h>
#include <OgreException.h>
#include <OgreLight.h>
#include <OgreLogManager.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreViewport.h>

#include <chrono>
#include <cmath>
#include <map>
#include <tuple>

namespace Lixel {
namespace {

using Clock = std::chrono::steady_clock;

/// Microseconds.
double since(Clock::time_point begin) {
    return std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
}

/// What is remembered of one light, viewer and map.
struct MapMemory {
    FitState state;
    CasterSearch casters;
    CasterVolume volume;
    FitReason lastReason = FitReason::None;
    bool warnedUnbounded = false;
    unsigned long lastFrame = 0;
};

/// Memories unused for this many frames are dropped: their light or camera may be gone.
constexpr unsigned long ForgetAfterFrames = 600;

ShadowLight describe(const Ogre::Light& light, const Ogre::Camera& viewer, const Vec3& wsOrigin) {
    ShadowLight result;
    switch (light.getType()) {
    case Ogre::Light::LT_DIRECTIONAL:
        result.kind = LightKind::Directional;
        break;
    case Ogre::Light::LT_SPOTLIGHT:
        result.kind = LightKind::Spot;
        break;
    default:
        result.kind = LightKind::Point;
        break;
    }
    result.wsDirection = toDouble(light.getDerivedDirection());
    result.wsPosition = toDouble(light.getDerivedPosition()) - wsOrigin;
    result.outerHalfAngle = light.getSpotlightOuterAngle().valueRadians() / 2.0;
    result.nearDistance = light._deriveShadowNearClipDistance(&viewer);
    result.range = light.getAttenuationRange();
    return result;
}

/// Puts the fit's matrices into the shadow camera.
void place(Ogre::Camera& camera, const ShadowFit& fit, const Vec3& wsOrigin) {
    // With camera-relative rendering OGRE subtracts the camera's position and drops the view
    // matrix' translation: the camera stands where the fit has its eye, so both are exact.
    const Vec3 wsEye = wsOrigin + fit.wsEye;
    camera.getParentSceneNode()->setPosition(toOgre(wsEye));
    Mat4 view = Mat4::Identity();
    view.topLeftCorner<3, 3>() = fit.lsFromWs;
    view.topRightCorner<3, 1>() = -fit.lsFromWs * wsEye;
    camera.setCustomViewMatrix(true, Ogre::Affine3(toOgre(view)));
    camera.setCustomProjectionMatrix(true, toOgre(fit.clipFromLight));
    // Neither is used by the matrices; but the octree skips the far end's test where far is 0.
    camera.setNearClipDistance(1);
    camera.setFarClipDistance(2);
}

} // namespace

struct FittedShadowCameraSetup::Memory {
    using Key = std::tuple<const Ogre::Light*, const Ogre::Camera*, std::size_t>;
    std::map<Key, std::unique_ptr<MapMemory>> maps;
    unsigned long lastSweep = 0;

    MapMemory& of(const Key& key, unsigned long frame) {
        if (frame - lastSweep > ForgetAfterFrames) {
            std::erase_if(maps, [&](const auto& entry) {
                return frame - entry.second->lastFrame > ForgetAfterFrames;
            });
            lastSweep = frame;
        }
        std::unique_ptr<MapMemory>& memory = maps[key];
        if (!memory) memory = std::make_unique<MapMemory>();
        memory->lastFrame = frame;
        return *memory;
    }
};

FittedShadowCameraSetup::FittedShadowCameraSetup() : mMemory(std::make_unique<Memory>()) {}
FittedShadowCameraSetup::~FittedShadowCameraSetup() = default;

void FittedShadowCameraSetup::setFilterRadius(Ogre::Real texels) {
    if (!(texels >= 0) || texels > 64)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "texels: the filter radius must be between 0 and 64 texels",
                    "FittedShadowCameraSetup::setFilterRadius");
    mFilterRadius = texels;
}

void FittedShadowCameraSetup::setDepthBias(Ogre::Real worldUnits) {
    if (!(worldUnits >= 0) || !std::isfinite(worldUnits))
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "worldUnits: the depth bias must be finite and not negative",
                    "FittedShadowCameraSetup::setDepthBias");
    mDepthBias = worldUnits;
}

void FittedShadowCameraSetup::getShadowCamera(const Ogre::SceneManager*, const Ogre::Camera* viewer,
                                              const Ogre::Viewport* viewport,
                                              const Ogre::Light* light, Ogre::Camera* shadowCamera,
                                              std::size_t iteration) const {
    // The camera's scene manager is the one we were handed, and not const.
    Ogre::SceneManager& sceneManager = *viewer->getSceneManager();
    guardLights(sceneManager);

    const double shadowDistance = light->getShadowFarDistance();
    const TimedSurvey& timed = surveyFor(*viewer, *viewport, shadowDistance);
    const Survey& survey = timed.survey;
    MapMemory& memory =
        mMemory->of({light, viewer, iteration}, Ogre::Root::getSingleton().getNextFrameNumber());

    const Ogre::Viewport& map = *shadowCamera->getViewport();
    ShadowProblem problem;
    problem.viewer = survey.viewer();
    problem.viewer.shadowDistance = shadowDistance;
    problem.light = describe(*light, *viewer, survey.wsOrigin());
    const auto searchBegin = Clock::now();
    problem.casters = &memory.casters.find(survey, problem.light, shadowDistance);
    const double searchTime = since(searchBegin);
    problem.receivers = &survey.receivers();
    problem.surfaces = survey.surfaces();
    problem.mapWidth = map.getActualWidth();
    problem.mapHeight = map.getActualHeight();
    problem.filterRadius = mFilterRadius;
    problem.depthClamp = canClampDepth();
    problem.wsOrigin = survey.wsOrigin();

    const auto fitBegin = Clock::now();
    const ShadowFit result = fit(problem, memory.state);
    const double fitTime = since(fitBegin);

    place(*shadowCamera, result, survey.wsOrigin());
    if (result.hasMap()) {
        memory.volume.set(result, survey.wsOrigin());
        shadowCamera->setCullingFrustum(&memory.volume);
        armShadowPass(*shadowCamera);
    } else {
        skipShadowPass(*shadowCamera);
    }

    // A light that happens to shadow nothing is no news; input that cannot be drawn is.
    if (result.reason != memory.lastReason && result.reason >= FitReason::Unbounded)
        Ogre::LogManager::getSingleton().logWarning("Lixel: no shadow map for light '" +
                                                    light->getName() +
                                                    "': " + toString(result.reason));
    memory.lastReason = result.reason;
    const bool unbounded = !survey.unboundedName().empty();
    if (unbounded && result.hasMap() && !memory.warnedUnbounded)
        Ogre::LogManager::getSingleton().logWarning(
            "Lixel: '" + survey.unboundedName() + "' has no bounds; the shadow map of light '" +
            light->getName() + "' is focused as if it were everywhere in view");
    memory.warnedUnbounded = unbounded;

    publishShadowMap({.sceneManager = sceneManager,
                      .viewer = *viewer,
                      // OGRE hands out its own, mutable light as const.
                      .light = const_cast<Ogre::Light&>(*light),
                      .shadowCamera = *shadowCamera,
                      .iteration = iteration,
                      .fit = result,
                      .wsOrigin = survey.wsOrigin(),
                      .width = problem.mapWidth,
                      .height = problem.mapHeight,
                      .depthBias = static_cast<double>(mDepthBias),
                      .surveyMicroseconds = timed.microseconds,
                      .casterMicroseconds = searchTime,
                      .fitMicroseconds = fitTime});
}

} // namespace Lixel

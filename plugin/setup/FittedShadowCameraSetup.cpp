#include "setup/FittedShadowCameraSetup.h"

#include "scene/CasterSearch.h"
#include "scene/CasterVolume.h"
#include "scene/Identity.h"
#include "scene/OgreMath.h"
#include "scene/OgreVersions.h"
#include "scene/SceneWatch.h"
#include "scene/SurveyCache.h"
#include "setup/DivisionMemory.h"
#include "setup/InvalidInput.h"
#include "setup/LightGuard.h"
#include "setup/News.h"
#include "setup/ShadowMapObserver.h"
#include "setup/ShadowPass.h"

#include <Eigen/LU>

#include <OgreCamera.h>
#include <OgreException.h>
#include <OgreGpuProgramManager.h>
#include <OgreHardwarePixelBuffer.h>
#include <OgreLight.h>
#include <OgreLogManager.h>
#include <OgreMaterialManager.h>
#include <OgreRenderTexture.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreTexture.h>
#include <OgreViewport.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>

namespace Lixel {
namespace {

using Clock = std::chrono::steady_clock;

/// Microseconds.
double since(Clock::time_point begin) {
    return std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
}

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
    default: // rectangles too, which OGRE has since 14: as if all of their light came from the
             // middle
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

void logWarning(const Ogre::String& message) {
    Ogre::LogManager::getSingleton().logWarning("Lixel: " + message);
}

/// Says once that Lixel's scripts are there and the plugin is not, which fills their parameters.
void warnWithoutPlugin() {
    static bool isTold = false;
    if (isTold || Ogre::GpuProgramManager::getSingleton().getAvailableSharedParameters().count(
                      "Lixel/Caster") != 0)
        return;
    if (!Ogre::MaterialManager::getSingleton().resourceExists("Lixel/Caster")) return;
    isTold = true;
    logWarning("Lixel's materials are loaded and Plugin_Lixel is not: they show no shadows without "
               "it. Name it in plugins.cfg, or call Root::loadPlugin before the resource groups "
               "are initialised");
}

/// What the log is told of a light beside reasons, as kinds of news behind these.
enum Trouble : unsigned {
    TooFewTextures = 24,
    NoMapsOfItsOwn,
    BodyWithoutBounds,
    MapsDrawnTogether,
    MapsLeftOver,
    OneMapToDivide
};
static_assert(static_cast<unsigned>(FitReason::TooFewMaps) < TooFewTextures);

void logReason(const Ogre::Light& light, FitReason reason, const ShadowProblem& problem) {
    Ogre::String message = "no shadow map for light '" + light.getName() + "': " + toString(reason);
    if (reason == FitReason::TooFewMaps)
        message +=
            "; six are enough for any light (SceneManager::setShadowTextureCountPerLightType, "
            "an integrated shadow technique, and a material that reads as many)";
    if (reason == FitReason::InvalidInput)
        if (const std::string which = describeInvalidInput(problem); !which.empty())
            message += ": " + which;
    logWarning(message);
}

/// Whether a light is a sun, and no other casts shadows: textures are counted for a type of lights,
/// so of several one may have more than it takes. The number that a lamp takes is not its setup's.
bool isOnlySun(const Ogre::Light& light, const Ogre::SceneManager& sceneManager) {
    const auto isOther = [&](const Ogre::Light* other) {
        return other != &light && other->getType() == Ogre::Light::LT_DIRECTIONAL &&
               other->getCastShadows();
    };
    return light.getType() == Ogre::Light::LT_DIRECTIONAL &&
           std::ranges::none_of(sceneManager._getLightsAffectingFrustum(), isOther);
}

/// What serves no point at all.
const ShadowPart Nowhere = [] {
    ShadowPart part;
    part.wsRow = Vec4(0.0, 0.0, 0.0, -1e30);
    return part;
}();

/// A float's exponents end at 2⁻¹²⁶: what is multiplied on the way to a determinant like this, or
/// like its inverse, is well within.
constexpr double GreatestDeterminant = 0x1p96;

/** The unit of length in which the shadow camera sees, in world units: 1 but for worlds of some 10⁹
    units and more, or 10⁻⁹ and less.

    OGRE inverts the projection in floats, and asserts that what comes out is a number: of a sun's
    the determinant is that of a map's sides and depth, an inverse volume. A power of two, so that
    the product of projection and view stays the same to the last bit. */
double unitOf(const ShadowFit& fit) {
    const double determinant = std::abs(fit.clipFromLight.determinant());
    const bool isFar = determinant > GreatestDeterminant || determinant < 1.0 / GreatestDeterminant;
    if (!isFar || !fit.hasMap()) return 1.0;
    return std::exp2(std::round(-std::log2(determinant) / 3.0));
}

/** Near and far distance of the shadow camera.

    The matrices do not use them, but casters and receivers of others may. A sun's camera stands at
    the viewer, with casters behind it: there is no distance to give. Without a map what is white
    has to be beyond everything. Never 0: the octree skips the far end's test then. */
Vec2 clipDistances(const ShadowFit& fit) {
    constexpr double Endless = 1e9;
    if (!fit.hasMap()) return {1.0, Endless};
    const bool isLocal = !fit.directional && fit.lsNear > 0.0 && fit.lsFar > fit.lsNear;
    return isLocal ? Vec2(fit.lsNear, fit.lsFar) : Vec2(1.0, 2.0);
}

/// Puts the fit's matrices into the shadow camera.
void place(Ogre::Camera& camera, const ShadowFit& fit, const Vec3& wsOrigin) {
    // With camera-relative rendering OGRE subtracts the camera's position and drops the view
    // matrix' translation: the camera stands where the fit has its eye, so both are exact.
    const Vec3 wsEye = wsOrigin + fit.wsEye;
    if (Ogre::SceneNode* const node = camera.getParentSceneNode()) node->setPosition(toOgre(wsEye));
    const double unit = unitOf(fit);
    Mat4 view = Mat4::Identity();
    view.topLeftCorner<3, 3>() = fit.lsFromWs / unit;
    view.topRightCorner<3, 1>() = -fit.lsFromWs * wsEye / unit;
    camera.setCustomViewMatrix(true, Ogre::Affine3(toOgre(view)));
    Mat4 clipFromView = fit.clipFromLight;
    clipFromView.leftCols<3>() *= unit;
    camera.setCustomProjectionMatrix(true, toOgre(clipFromView));
    const Vec2 clip = clipDistances(fit) / unit;
    camera.setNearClipDistance(static_cast<Ogre::Real>(clip[0]));
    camera.setFarClipDistance(static_cast<Ogre::Real>(clip[1]));
}

} // namespace

/// What the log was told of one light.
struct FittedShadowCameraSetup::LightNews : News {
    /// Once for good: to find it out costs the fits of what is left over.
    bool toldOfParts = false;
};

/// What is remembered of one light and viewer.
struct FittedShadowCameraSetup::LightMemory {
    DivisionMemory division;
    /// The application's, relative to the viewer.
    std::vector<VisiblePoint> visiblePoints;
    CasterSearch search;
    /// This preparation's, from its first map on.
    LightPartition parts;
    const BoxSet* casters = nullptr;
    std::size_t maps = 0;
    /// The first part that no map was asked for yet.
    std::size_t nextPart = 0;
    /// Of each part.
    std::array<FitState, LightPartition::Capacity> states;
    /// Of each map.
    std::array<CasterVolume, LightPartition::Capacity> volumes;
    unsigned long lastFrame = 0;

    LightMemory() = default;
    LightMemory(const LightMemory&) = delete;
    LightMemory& operator=(const LightMemory&) = delete;
    /// The last reference to a setup may go between the preparation of its map and the pass.
    ~LightMemory() {
        for (const CasterVolume& volume : volumes)
            releaseShadowPass(volume);
    }
};

/// Goes with its scene manager: caster volumes are OGRE's own frustums, which must not outlive it.
struct FittedShadowCameraSetup::Memory : SceneWatcher {
    using LightAndViewer = std::pair<Identity, Identity>;
    struct Scene {
        std::map<LightAndViewer, std::unique_ptr<LightMemory>> lights;
        std::map<Identity, LightNews> news;
        unsigned long lastSweep = 0;
    };
    std::map<const Ogre::SceneManager*, Scene> scenes;

    void sceneGone(Ogre::SceneManager& sceneManager) override { scenes.erase(&sceneManager); }

    Scene& of(Ogre::SceneManager& sceneManager, unsigned long frame) {
        watchScene(sceneManager);
        Scene& scene = scenes[&sceneManager];
        if (frame - scene.lastSweep > ForgetAfterFrames) {
            std::erase_if(scene.lights, [&](const auto& entry) {
                return frame - entry.second->lastFrame > ForgetAfterFrames;
            });
            std::erase_if(scene.news, [&](const auto& entry) {
                return entry.second.isOver(frame) && !entry.second.toldOfParts;
            });
            scene.lastSweep = frame;
        }
        return scene;
    }

    static LightMemory& of(Scene& scene, const LightAndViewer& key, unsigned long frame) {
        std::unique_ptr<LightMemory>& memory = scene.lights[key];
        if (!memory) {
            memory = std::make_unique<LightMemory>();
            warnWithoutPlugin();
        }
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

std::size_t FittedShadowCameraSetup::mapsOf(const Ogre::Light& light,
                                            const std::vector<ShadowTarget>& targets,
                                            const Ogre::SceneManager& sceneManager,
                                            LightNews& news) const {
    const unsigned long frame = Ogre::Root::getSingleton().getNextFrameNumber();
    if (!targets.empty() && drawsMapsTogether(*targets.front().texture)) {
        if (news.isNew(MapsDrawnTogether, frame))
            logWarning("no shadow map for light '" + light.getName() +
                       "': its shadow texture draws all of its layers in one pass "
                       "(TU_TARGET_ALL_LAYERS), and each of Lixel's maps has casters of its own");
        return 0;
    }
    const std::size_t wanted = sceneManager.getShadowTextureCountPerLightType(light.getType());
    if (wanted <= 1) {
        if (isOnlySun(light, sceneManager) && mapsOfSun(2) > 1 && news.isNew(OneMapToDivide, frame))
            logWarning("light '" + light.getName() +
                       "' has one shadow texture, and a setup that divides it among several: "
                       "SceneManager::setShadowTextureCountPerLightType gives it more, under an "
                       "integrated shadow technique");
        return 1;
    }
    if (!sceneManager.isShadowTechniqueIntegrated()) {
        if (news.isNew(NoMapsOfItsOwn, frame))
            Ogre::LogManager::getSingleton().logError(
                "Lixel: light '" + light.getName() + "' has " + std::to_string(wanted) +
                " shadow textures, and OGRE uses more than one of a light only under an "
                "integrated shadow technique, such as SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED; it "
                "gets one map");
        return 1;
    }
    const std::size_t left = targets.empty() ? wanted : targets.size();
    if (left < wanted && news.isNew(TooFewTextures, frame))
        logWarning("light '" + light.getName() + "' should have " + std::to_string(wanted) +
                   " shadow maps, and there are textures for " + std::to_string(left) +
                   " (SceneManager::setShadowTextureCount)");
    const std::size_t maps =
        std::clamp<std::size_t>(std::min(wanted, left), 1, LightPartition::Capacity);
    if (isOnlySun(light, sceneManager) && mapsOfSun(maps) < maps && news.isNew(MapsLeftOver, frame))
        logWarning("light '" + light.getName() + "' has " + std::to_string(maps) +
                   " shadow textures, and its setup fills " + std::to_string(mapsOfSun(maps)) +
                   ": CascadesShadowCameraSetup fills one for each slice of the view");
    return maps;
}

void FittedShadowCameraSetup::setVisiblePoints(const std::vector<VisiblePoint>& wsPoints) {
    for (const VisiblePoint& point : wsPoints)
        if (!point.ws.allFinite() || !point.wsNormal.allFinite() || point.wsNormal.isZero(0.0))
            OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                        "wsPoints: points must be finite, and normals not zero",
                        "FittedShadowCameraSetup::setVisiblePoints");
    // As many as there can be samples; of more, every so many.
    constexpr std::size_t Most = 4096;
    const std::size_t kept = std::min(wsPoints.size(), Most);
    mWsVisiblePoints.clear();
    for (std::size_t i = 0; i < kept; ++i)
        mWsVisiblePoints.push_back(wsPoints[i * wsPoints.size() / kept]);
    for (VisiblePoint& point : mWsVisiblePoints)
        point.wsNormal.stableNormalize();
}

LightPartition FittedShadowCameraSetup::divide(const ShadowProblem& problem, std::size_t maps,
                                               DivisionMemory& memory) const noexcept {
    if (!needsParts(problem.light)) return wholeLight(problem.light);
    constexpr std::size_t CubeFaces = 6;
    if (maps < CubeFaces) {
        const LightPartition aimed = aimedSpot(problem, memory.aim);
        if (aimed.count > 0 || maps == 1) return aimed;
    }
    return cubeAround(problem.light);
}

ShadowFit FittedShadowCameraSetup::fitNext(const ShadowProblem& problem, const Ogre::Light& light,
                                           std::size_t mapsLeft, LightMemory& memory,
                                           LightNews& news, const ShadowPart*& part) const {
    ShadowFit result;
    result.reason = memory.parts.count == 0 ? FitReason::TooFewMaps : FitReason::NothingShadowed;
    part = &Nowhere;
    const auto fitPart = [&](std::size_t i) {
        return fit(problemOf(problem, memory.parts.parts[i]), memory.states[i]);
    };
    while (memory.nextPart < memory.parts.count) {
        part = &memory.parts.parts[memory.nextPart];
        result = fitPart(memory.nextPart);
        ++memory.nextPart;
        // With maps for all parts each has its own; else those without shadows go without.
        if (result.hasMap() || memory.parts.count - memory.nextPart < mapsLeft) break;
    }
    if (mapsLeft > 1) return result;

    for (; memory.nextPart < memory.parts.count && !news.toldOfParts; ++memory.nextPart) {
        if (!fitPart(memory.nextPart).hasMap()) continue;
        logWarning("light '" + light.getName() +
                   "' needs more shadow maps than it has: some of its shadows are missing");
        news.toldOfParts = true;
    }
    return result;
}

void FittedShadowCameraSetup::getShadowCamera(const Ogre::SceneManager*, const Ogre::Camera* viewer,
                                              const Ogre::Viewport* viewport,
                                              const Ogre::Light* light, Ogre::Camera* shadowCamera,
                                              std::size_t iteration) const {
    // The camera's scene manager is the one we were handed, and not const.
    Ogre::SceneManager& sceneManager = *viewer->getSceneManager();
    guardLights(sceneManager);
    const unsigned long frame = Ogre::Root::getSingleton().getNextFrameNumber();
    Memory::Scene& scene = mMemory->of(sceneManager, frame);
    const Identity identity = identityOf(*light);
    LightMemory& memory = Memory::of(scene, {identity, identityOf(*viewer)}, frame);
    LightNews& news = scene.news[identity];
    const std::vector<ShadowTarget> targets = shadowTargetsFrom(*shadowCamera, sceneManager);
    const bool isDrawn = !targets.empty();
    if (iteration == 0) memory.maps = mapsOf(*light, targets, sceneManager, news);
    const std::size_t maps = memory.maps;
    if (iteration >= maps) {
        // Under modulative shadows OGRE may take this camera for another light's, and adds a
        // texture of its own to the receiver where a spot's camera has no projection of ours.
        place(*shadowCamera, ShadowFit{}, toDouble(viewer->getDerivedPosition()));
        if (isDrawn) skipShadowPass(*shadowCamera);
        return;
    }

    const double shadowDistance = light->getShadowFarDistance();
    const TimedSurvey& timed = surveyFor(*viewer, *viewport, shadowDistance);
    const Survey& survey = timed.survey;

    ShadowProblem problem;
    problem.viewer = survey.viewer();
    problem.viewer.shadowDistance = shadowDistance;
    problem.light = describe(*light, *viewer, survey.wsOrigin());
    problem.receivers = &survey.receivers();
    if (mMeshHulls) {
        problem.receiverShapes = &survey.receiverShapes();
        problem.casterShapes = &memory.search.shapes();
    }
    problem.surfaces = survey.surfaces();
    if (const Ogre::Viewport* const map = shadowCamera->getViewport()) {
        problem.mapWidth = map->getActualWidth();
        problem.mapHeight = map->getActualHeight();
    }
    problem.filterRadius = mFilterRadius;
    problem.depthClamp = canClampDepth();
    problem.wsOrigin = survey.wsOrigin();

    double searchTime = 0.0;
    if (iteration == 0) {
        memory.visiblePoints = mWsVisiblePoints;
        for (VisiblePoint& point : memory.visiblePoints)
            point.ws -= survey.wsOrigin();
        const auto searchBegin = Clock::now();
        memory.casters = &memory.search.find(survey, problem.light, shadowDistance);
        searchTime = since(searchBegin);
    }
    problem.visiblePoints = memory.visiblePoints;
    problem.casters = memory.casters;
    const auto fitBegin = Clock::now();
    if (iteration == 0) {
        memory.parts = divide(problem, maps, memory.division);
        memory.nextPart = 0;
    }
    const ShadowPart* part = nullptr;
    const ShadowFit result = fitNext(problem, *light, maps - iteration, memory, news, part);
    const double fitTime = since(fitBegin);

    place(*shadowCamera, result, survey.wsOrigin());
    if (isDrawn && result.hasMap()) {
        CasterVolume& volume = memory.volumes.at(iteration);
        volume.set(result, survey.wsOrigin());
        armShadowPass(*shadowCamera, volume);
    } else if (isDrawn) {
        skipShadowPass(*shadowCamera);
    }
    // A light that happens to shadow nothing is no news; input that cannot be drawn is.
    if (result.reason >= FitReason::Unbounded &&
        news.isNew(static_cast<unsigned>(result.reason), frame))
        logReason(*light, result.reason, problem);
    if (!survey.unboundedName().empty() && result.hasMap() && news.isNew(BodyWithoutBounds, frame))
        logWarning("'" + survey.unboundedName() + "' has no bounds; the shadow map of light '" +
                   light->getName() + "' is focused as if it were everywhere in view");

    if (!isDrawn) return; // nobody sees it
    publishShadowMap({.sceneManager = sceneManager,
                      .viewer = *viewer,
                      // OGRE hands out its own, mutable light as const.
                      .light = const_cast<Ogre::Light&>(*light),
                      .shadowCamera = *shadowCamera,
                      .iteration = iteration,
                      .part = *part,
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

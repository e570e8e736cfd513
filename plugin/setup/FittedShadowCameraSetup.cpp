#include "setup/FittedSetupRequest.h"

#include "fit/focus/ViewVolume.h"
#include "scene/Log.h"
#include "scene/NodeStore.h"
#include "scene/OgreMath.h"
#include "scene/OgreVersions.h"
#include "scene/SurveyCache.h"
#include "setup/LightGuard.h"
#include "setup/MapCount.h"
#include "setup/MapProof.h"
#include "setup/SetupMemory.h"
#include "setup/ShadowCameraPlacement.h"
#include "setup/ShadowPass.h"
#include "setup/StillLayer.h"
#include "setup/ViewerFeedback.h"

#include <OgreCamera.h>
#include <OgreGpuProgramManager.h>
#include <OgreLight.h>
#include <OgreMaterialManager.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreViewport.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace Lixel {
namespace {

using Clock = std::chrono::steady_clock;

/// Microseconds.
double since(Clock::time_point begin) {
    return std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
}

/// What serves no point at all.
const ShadowPart Nowhere = [] {
    ShadowPart part;
    part.wsRow = Vec4(0.0, 0.0, 0.0, -1e30);
    return part;
}();

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

/// Of lasting_maps: the widest margin around what is seen, the least that is tried, and by how much
/// a new map's texels may be coarser for it.
constexpr double MarginShare = 0.5;
constexpr double LeastMargin = 0.05;
constexpr double FreshShare = 0.7;

/// Fewer parts of a mesh are too coarse for what is gained by them: a grid of at most so many may have
/// a quarter of them, and of fewer than MeshShapes::LeastParts nothing is made.
constexpr int FewestMeshParts = 256;

double widestMargin(const CommonOptions& options) {
    return MarginShare * options.lastingMaps;
}

/// As Survey::take wants them.
std::size_t wantedParts(const CommonOptions& options) {
    if (!options.meshHulls || options.meshParts <= 0) return 0;
    return static_cast<std::size_t>(std::max(options.meshParts, FewestMeshParts));
}

/// The fingerprint of the casters found, read once.
/// @param each as CasterFingerprint::take
const CasterFingerprint& castersOf(LightMemory& memory, bool each) {
    if (!memory.hasFingerprint) memory.fingerprint.take(memory.search, each);
    memory.hasFingerprint = true;
    return memory.fingerprint;
}

/// Without what does not outlive a frame.
ShadowProblem withoutBodies(const ShadowProblem& problem) {
    ShadowProblem rest = problem;
    rest.casters = rest.receivers = nullptr;
    rest.casterShapes = rest.receiverShapes = nullptr;
    rest.surfaces = {};
    rest.visiblePoints = {};
    rest.seen = nullptr;
    return rest;
}

} // namespace

FittedShadowCameraSetup::FittedShadowCameraSetup() : FittedShadowCameraSetup("", {}, nullptr) {}

FittedShadowCameraSetup::FittedShadowCameraSetup(std::string_view name,
                                                 std::span<const Option> declared, void* options)
    : mMemory(std::make_unique<SetupMemory>()),
      mName(name),
      mDeclared(declared),
      mOptions(options) {
    declareParameters();
}

FittedShadowCameraSetup::~FittedShadowCameraSetup() = default;

LightPartition FittedShadowCameraSetup::divide(const ShadowProblem& problem, std::size_t maps,
                                               DivisionMemory& memory) const noexcept {
    if (!needsParts(problem.light)) return wholeLight(problem.light);
    constexpr std::size_t CubeFaces = 6;
    // Fewer maps than these show less as faces than one does as a cone: in rooms with one lamp, two and
    // three faces left out four times as much as they showed better.
    constexpr std::size_t FewestFaces = 4;
    if (maps < FewestFaces) return widestPart(problem, memory.aim, memory.wsAimAxis);
    if (maps < CubeFaces) {
        const LightPartition aimed = aimedSpot(problem, memory.aim);
        if (aimed.count > 0) return aimed;
    }
    return cubeAround(problem.light);
}

std::unique_ptr<DivisionMemory> FittedShadowCameraSetup::makeDivisionMemory() const {
    return std::make_unique<DivisionMemory>();
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
    if (!memory.parts.servesAll && result.hasMap()) result.reason = FitReason::PartOfLight;
    if (mapsLeft > 1) return result;

    for (; memory.nextPart < memory.parts.count && !news.toldOfParts; ++memory.nextPart) {
        if (!fitPart(memory.nextPart).hasMap()) continue;
        logWarning("light '" + light.getName() +
                   "' needs more shadow maps than it has: some of its shadows are missing");
        news.toldOfParts = true;
    }
    return result;
}

ShadowProblem FittedShadowCameraSetup::describe(const Request& request, const Survey& survey,
                                                const LightMemory& memory) const {
    ShadowProblem problem;
    problem.viewer = survey.viewer();
    problem.viewer.shadowDistance = request.light.getShadowFarDistance();
    problem.light = shadowLightOf(request.light, request.viewer, survey.wsOrigin());
    problem.receivers = &survey.receivers();
    if (mCommon.meshHulls) {
        problem.receiverShapes = &survey.receiverShapes();
        problem.casterShapes = &memory.search.shapes();
    }
    problem.surfaces = survey.surfaces();
    if (const Ogre::Viewport* const map = request.shadowCamera.getViewport()) {
        problem.mapWidth = map->getActualWidth();
        problem.mapHeight = map->getActualHeight();
    }
    problem.filterRadius = mCommon.filterRadius;
    problem.depthClamp = canClampDepth();
    problem.wsOrigin = survey.wsOrigin();
    return problem;
}

void FittedShadowCameraSetup::findCasters(const ShadowProblem& problem, const Survey& survey,
                                          LightMemory& memory) const {
    memory.visiblePoints = mWsVisiblePoints;
    for (VisiblePoint& point : memory.visiblePoints)
        point.ws -= survey.wsOrigin();
    memory.hasFingerprint = false;
    memory.casters = &memory.search.find(survey, problem.light, problem.viewer.shadowDistance,
                                         widestMargin(mCommon));
}

/*  1. Count the light's maps, from its first one on.
    2. Ask whether they are those of the frame before, without a look at the scene.
    3. Repeat the map, or fit it. */
void FittedShadowCameraSetup::getShadowCamera(const Ogre::SceneManager*, const Ogre::Camera* viewer,
                                              const Ogre::Viewport* viewport,
                                              const Ogre::Light* light, Ogre::Camera* shadowCamera,
                                              std::size_t iteration) const {
    const Request request{*viewer, *viewport, *light, *shadowCamera, iteration};
    // The camera's scene manager is the one we were handed, and not const.
    Ogre::SceneManager& sceneManager = *viewer->getSceneManager();
    guardLights(sceneManager);
    const auto [memory, news] = mMemory->of(sceneManager, *light, *viewer);
    if (!memory.division) {
        memory.division = makeDivisionMemory();
        warnWithoutPlugin();
    }
    const std::vector<ShadowTarget> targets = shadowTargetsFrom(*shadowCamera, sceneManager);
    const bool isDrawn = !targets.empty();
    if (iteration == 0)
        memory.maps = mapCountOf(
            *light, targets, sceneManager, [this](std::size_t maps) { return mapsOfSun(maps); },
            news);
    if (iteration >= memory.maps) {
        // Under modulative shadows OGRE may take this camera for another light's, and adds a
        // texture of its own to the receiver where a spot's camera has no projection of ours.
        placeShadowCamera(*shadowCamera, ShadowFit{}, toDouble(viewer->getDerivedPosition()));
        if (isDrawn) skipShadowPass(*shadowCamera, targets.front());
        return;
    }

    if (iteration == 0) {
        memory.still.begin(isDrawn ? situationOf(request, targets, memory) : std::nullopt, memory);
        if (memory.still.rests() && isProofMode()) memory.still.fitNevertheless(memory);
    }
    if (memory.still.rests() && isDrawn)
        repeatMap(request, targets.front(), memory);
    else
        prepareMap(request, isDrawn ? &targets.front() : nullptr, memory, news);
    if (!isDrawn) endSurvey(sceneManager); // asked for the matrices alone
}

std::optional<Fingerprint>
FittedShadowCameraSetup::situationOf(const Request& request,
                                     const std::vector<ShadowTarget>& targets,
                                     const LightMemory& memory) const {
    const NodeStore* const store = findStore(*request.viewer.getSceneManager());
    if (store == nullptr || !store->areChangesAnnounced()) return std::nullopt;
    for (const FittedShadowCameraSetup* setup = this; setup != nullptr; setup = setup->technique())
        if (!setup->dependsOnlyOnOptions()) return std::nullopt;
    Fingerprint situation;
    addSettings(situation);
    situation.add(mVisiblePointsSet);
    if (mCommon.feedback) situation.add(feedbackVersion(request.viewer));
    situation.add(std::uint64_t{memory.maps});
    addSituation(request.light, request.viewer, request.viewport,
                 std::span(targets).first(std::min(memory.maps, targets.size())), situation);
    return situation;
}

/*  1. Survey what the viewer sees, and find the light's casters and its parts: once for all maps.
    2. Fit the next part.
    3. Place the shadow camera, and have the map drawn, kept or skipped.
    4. Tell the log and the observers.
    5. Note whether any of it may be otherwise in the next frame. */
void FittedShadowCameraSetup::prepareMap(const Request& request, const ShadowTarget* target,
                                         LightMemory& memory, LightNews& news) const {
    const auto& [viewer, viewport, light, shadowCamera, iteration] = request;
    NodeStore* const store = findStore(*viewer.getSceneManager());
    // Whoever proves takes nothing for granted: what was read of objects is forgotten.
    if (iteration == 0 && store != nullptr && isProofMode()) store->beginReading({});
    const TimedSurvey& timed = surveyFor(viewer, viewport, light.getShadowFarDistance(),
                                         widestMargin(mCommon), wantedParts(mCommon));
    const Survey& survey = timed.survey;
    ShadowProblem problem = describe(request, survey, memory);
    const auto searchBegin = Clock::now();
    if (iteration == 0) findCasters(problem, survey, memory);
    const double searchTime = iteration == 0 ? since(searchBegin) : 0.0;
    if (mCommon.feedback && memory.visiblePoints.empty())
        problem.seen = feedbackFor(viewer, survey.viewer(), survey.wsOrigin()).seen;
    const bool isSeen = problem.seen != nullptr && problem.seen->known() > 0;
    problem.visiblePoints =
        memory.visiblePoints.empty() && !isSeen ? survey.visiblePoints() : memory.visiblePoints;
    problem.casters = memory.casters;

    const auto fitBegin = Clock::now();
    if (iteration == 0) {
        memory.parts = divide(problem, memory.maps, *memory.division);
        memory.nextPart = 0;
    }
    const ShadowPart* part = nullptr;
    const ShadowFit result = fitNext(problem, light, memory.maps - iteration, memory, news, part);
    LastingMap* const lasting = mCommon.lastingMaps > 0.0 && result.hasMap()
                                    ? &lastingMap(request, problem, *part, result, memory)
                                    : nullptr;
    const double fitTime = since(fitBegin);
    const Vec3 wsOrigin = lasting != nullptr ? lasting->wsOrigin : survey.wsOrigin();
    ShownMap shown{lasting != nullptr ? lasting->fit : result,
                   relocated(*part, survey.wsOrigin() - wsOrigin), wsOrigin};
    const bool readsEach = mCommon.movingApart && drawsLayers(*viewer.getSceneManager());
    bool isRead = false;
    const auto readCasters = [&]() -> const CasterFingerprint& {
        if (lasting == nullptr) return castersOf(memory, readsEach);
        if (std::exchange(isRead, true)) return lasting->fingerprint;
        // It was drawn for a region of its own, and other casters reach into that.
        lasting->search.findIn(survey, memory.volumes.at(iteration).volume());
        lasting->fingerprint.take(lasting->search, readsEach);
        return lasting->fingerprint;
    };
    const MapCasters casters{.readsAtOnce = lasting != nullptr,
                             .read = readCasters,
                             .each =
                                 lasting != nullptr ? &lasting->fingerprint : &memory.fingerprint};
    const ShownMap fitted = shown;
    const bool believed = target != nullptr && isBelieved(request, *target, memory);
    placeShadowCamera(shadowCamera, shown.fit, shown.wsOrigin);
    MapDecision decision;
    if (target != nullptr)
        decision = draw(request, problem, *target, memory, casters, believed, shown);
    news.tell(light, result.reason, problem);
    if (!survey.unboundedName().empty() && result.hasMap())
        news.tellWithoutBounds(light, survey.unboundedName());
    if (target == nullptr) return;
    publish(request, problem, shown, decision, {timed.microseconds, searchTime, fitTime});

    if (!memory.still.isWatched()) return;
    const CasterFingerprint& read = readCasters();
    memory.still.note(
        {fitted, withoutBodies(problem), CasterFingerprint(read.value()), memory.nextPart});
    if ((iteration == 0 && !tellChanges(survey.receiverObjects())) ||
        !survey.unboundedName().empty() || isTrouble(result.reason) ||
        !castersOf(memory, readsEach).unknownName().empty() || !read.unknownName().empty())
        memory.still.doubt();
}

void FittedShadowCameraSetup::repeatMap(const Request& request, const ShadowTarget& target,
                                        LightMemory& memory) const {
    const StillMap& still = memory.still.map(request.iteration);
    memory.nextPart = still.nextPart;
    ShownMap shown = still.shown;
    placeShadowCamera(request.shadowCamera, shown.fit, shown.wsOrigin);
    const auto readCasters = [&]() -> const CasterFingerprint& { return still.casters; };
    const MapDecision decision = draw(request, still.problem, target, memory,
                                      {.readsAtOnce = true, .read = readCasters}, false, shown);
    publish(request, still.problem, shown, decision, {});
}

LastingMap& FittedShadowCameraSetup::lastingMap(const Request& request,
                                                const ShadowProblem& problem,
                                                const ShadowPart& part, const ShadowFit& fresh,
                                                LightMemory& memory) const {
    std::unique_ptr<LastingMap>& kept = memory.lasting.at(request.iteration);
    if (!kept) kept = std::make_unique<LastingMap>();
    Fingerprint settings;
    addLight(problemOf(problem, part), settings);
    addSettings(settings);
    if (serves(*kept, settings, fresh, problem, mCommon.lastingMaps)) return *kept;

    const auto at = [&](double margin, const auto& attempt) {
        const ShadowPart widePart = widened(part, margin);
        return attempt(problemOf(widened(problem, margin), widePart));
    };
    // The same texels, if they serve, leave shadows' edges where they are.
    const auto moveTo = [&](const ShadowProblem& wide) {
        return move(*kept, settings, fresh, wide, mCommon.lastingMaps);
    };
    if (at(widestMargin(mCommon), moveTo) || at(0.0, moveTo)) return *kept;

    kept->settings = settings;
    kept->wsOrigin = problem.wsOrigin;
    const auto fitAnew = [&](const ShadowProblem& wide) {
        keep(*kept, fit(wide, kept->state));
        return serves(*kept, settings, fresh, problem, FreshShare * mCommon.lastingMaps);
    };
    // What a margin costs depends on the view: the widest one is taken that leaves the map to last.
    for (double margin = widestMargin(mCommon); margin > LeastMargin * mCommon.lastingMaps;
         margin /= 2.0)
        if (at(margin, fitAnew)) return *kept;
    keep(*kept, fresh);
    return *kept;
}

} // namespace Lixel

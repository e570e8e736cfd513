#pragma once

#include "fit/core/FitState.h"
#include "scene/CasterFingerprint.h"
#include "scene/CasterSearch.h"
#include "scene/CasterVolume.h"
#include "scene/Identity.h"
#include "scene/SceneWatch.h"
#include "setup/DivisionMemory.h"
#include "setup/DrawnMap.h"
#include "setup/LastingMap.h"
#include "setup/LightNews.h"
#include "setup/StillLayer.h"
#include "setup/StillLight.h"

#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace Lixel {

/// What is kept of one light and viewer.
struct LightMemory {
    // What outlives a frame.
    /// Null until the light's setup made it.
    std::unique_ptr<DivisionMemory> division;
    CasterSearch search;
    /// Of each part.
    std::array<FitState, LightPartition::Capacity> states;
    /// Of each map.
    std::array<CasterVolume, LightPartition::Capacity> volumes;
    /// Null until the setup's maps are to last.
    std::array<std::unique_ptr<LastingMap>, LightPartition::Capacity> lasting;
    /// Null without a budget.
    std::array<std::unique_ptr<DrawnMap>, LightPartition::Capacity> drawn;
    /// Null until a map is drawn that may have layers.
    std::array<std::unique_ptr<StillLayer>, LightPartition::Capacity> layers;
    StillLight still;
    unsigned long lastFrame = 0;

    // Valid for one preparation of shadow textures: set for the light's first map.
    /// The points given to setVisiblePoints, relative to the viewer.
    std::vector<VisiblePoint> visiblePoints;
    LightPartition parts;
    const BoxSet* casters = nullptr;
    /// Of the casters found, where it was asked for.
    CasterFingerprint fingerprint;
    bool hasFingerprint = false;
    std::size_t maps = 0;
    /// The first part that no map was asked for yet.
    std::size_t nextPart = 0;

    LightMemory() = default;
    LightMemory(const LightMemory&) = delete;
    LightMemory& operator=(const LightMemory&) = delete;
    ~LightMemory();
};

/// What a setup keeps of all lights and viewers. A scene manager's part is dropped with it: caster
/// volumes derive from Ogre::Frustum and must not outlive the scene manager.
class SetupMemory : SceneWatcher {
public:
    struct Kept {
        LightMemory& memory;
        /// All viewers'.
        LightNews& news;
    };

    /// What is kept of a light and viewer, in this frame.
    Kept of(Ogre::SceneManager& sceneManager, const Ogre::Light& light, const Ogre::Camera& viewer);

private:
    using LightAndViewer = std::pair<Identity, Identity>;
    struct Scene {
        std::map<LightAndViewer, std::unique_ptr<LightMemory>> lights;
        std::map<Identity, LightNews> news;
        unsigned long lastSweep = 0;
    };

    /// Drops what was not used for long.
    static void sweep(Scene& scene, unsigned long frame);
    void sceneGone(Ogre::SceneManager& sceneManager) override;

    std::map<const Ogre::SceneManager*, Scene> mScenes;
};

} // namespace Lixel

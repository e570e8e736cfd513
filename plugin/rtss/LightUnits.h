#pragma once

#include "rtss/MapLayout.h"

#include <Lixel/scene/PerScene.h>

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace Lixel {

class AllLightUnits;

/** Which shadow units have each light's maps in a scene manager, frame by frame.

    OGRE deals them out in the order of the lights that cast shadows here, and gives the k-th
    texture to the k-th unit of content_type shadow, whatever is drawn.
*/
class LightUnits : public SceneManagerListener {
public:
    LightUnits(Ogre::SceneManager& manager, AllLightUnits& all);

    const MapLayout& layout() const { return mLayout; }

    /// The shadow unit that has a light's first map; negative where none has.
    /// @param startLight The pass's start_light. OGRE binds shadow textures from that light on.
    int firstUnit(const Ogre::Light& light, std::size_t startLight) const;

    void preUpdateSceneGraph(Ogre::SceneManager* source, Ogre::Camera* camera) override;
    void postFindVisibleObjects(Ogre::SceneManager* source,
                                Ogre::SceneManager::IlluminationRenderStage stage,
                                Ogre::Viewport* viewport) override;

private:
    void dealOut();

    Ogre::SceneManager& mManager;
    AllLightUnits& mAll;
    MapLayout mLayout;
    std::map<const Ogre::Light*, std::size_t> mFirstTextures;
    /// The same by the light's place among those that cast shadows.
    std::vector<std::size_t> mStarts;
};

/// Those of all scene managers that may draw with the shader system.
class AllLightUnits {
public:
    /// @param changed called at the beginning of a frame where layout() is another than in the one
    /// before. Deferred, because a scene manager may be registered during program generation.
    explicit AllLightUnits(std::function<void()> changed) : mChanged(std::move(changed)) {}

    /// From now on the scene manager counts, until it is destroyed.
    LightUnits& watch(Ogre::SceneManager& manager);
    /// The least that serves all of them.
    const MapLayout& layout() const { return mLayout; }
    /// Forgets all scene managers.
    void clear();

private:
    friend class LightUnits;
    void update();
    void beginFrame();

    std::function<void()> mChanged;
    PerScene<LightUnits> mScenes;
    MapLayout mLayout;
    bool mLayoutChanged = false;
};

} // namespace Lixel

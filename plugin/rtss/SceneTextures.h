#pragma once

#include "rtss/MapLayout.h"

#include <Lixel/scene/PerScene.h>

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace Lixel {

class AllSceneTextures;

/** Which of a scene manager's shadow textures each light has, frame by frame.

    OGRE deals them out in the order of the lights that cast shadows here, and gives the k-th
    texture to the k-th unit of content_type shadow, whatever is drawn.
*/
class SceneTextures : public SceneManagerListener {
public:
    SceneTextures(Ogre::SceneManager& manager, AllSceneTextures& all);

    const MapLayout& layout() const { return mLayout; }

    /// The shadow unit that has a light's first map; negative where none has.
    /// @param startLight that of the pass: OGRE begins with this light's textures there
    int firstUnit(const Ogre::Light& light, std::size_t startLight) const;

    void preUpdateSceneGraph(Ogre::SceneManager* source, Ogre::Camera* camera) override;
    void postFindVisibleObjects(Ogre::SceneManager* source,
                                Ogre::SceneManager::IlluminationRenderStage stage,
                                Ogre::Viewport* viewport) override;

private:
    void dealOut();

    Ogre::SceneManager& mManager;
    AllSceneTextures& mAll;
    MapLayout mLayout;
    std::map<const Ogre::Light*, std::size_t> mFirstTextures;
    /// The same by the light's place among those that cast shadows.
    std::vector<std::size_t> mStarts;
};

/// Those of all scene managers that may draw with the shader system.
class AllSceneTextures {
public:
    /// @param changed called at the beginning of a frame where layout() is another than in the one
    /// before. Not at once: a scene manager may be new to this while programs are made.
    explicit AllSceneTextures(std::function<void()> changed) : mChanged(std::move(changed)) {}

    /// From now on the scene manager counts, until it is destroyed.
    SceneTextures& of(Ogre::SceneManager& manager);
    /// The least that serves all of them.
    const MapLayout& layout() const { return mLayout; }
    /// Forgets all scene managers.
    void clear();

private:
    friend class SceneTextures;
    void update();
    void beginFrame();

    std::function<void()> mChanged;
    PerScene<SceneTextures> mScenes;
    MapLayout mLayout;
    bool mIsNew = false;
};

} // namespace Lixel

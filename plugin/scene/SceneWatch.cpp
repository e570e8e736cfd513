#include "scene/SceneWatch.h"

#include <OgreSceneManager.h>

#include <algorithm>
#include <set>
#include <vector>

namespace Lixel {
namespace {

/// One for all scene managers, which never goes before them: OGRE tells its listeners from a copy
/// of their list, so one that another listener destroys would be called nevertheless.
class Watch : public Ogre::SceneManager::Listener {
public:
    void sceneManagerDestroyed(Ogre::SceneManager* source) override { tell(*source); }

    void watch(Ogre::SceneManager& sceneManager) {
        if (mScenes.insert(&sceneManager).second) sceneManager.addListener(this);
    }

    void tell(Ogre::SceneManager& sceneManager) {
        mScenes.erase(&sceneManager);
        const std::vector<SceneWatcher*> told = watchers;
        for (SceneWatcher* watcher : told)
            if (std::ranges::find(watchers, watcher) != watchers.end())
                watcher->sceneGone(sceneManager);
    }

    void end() {
        while (!mScenes.empty()) {
            Ogre::SceneManager& sceneManager = **mScenes.begin();
            sceneManager.removeListener(this);
            tell(sceneManager);
        }
    }

    std::vector<SceneWatcher*> watchers;

private:
    std::set<Ogre::SceneManager*> mScenes;
};

Watch& theWatch() {
    static Watch instance;
    return instance;
}

} // namespace

SceneWatcher::SceneWatcher() {
    theWatch().watchers.push_back(this);
}

SceneWatcher::~SceneWatcher() {
    std::erase(theWatch().watchers, this);
}

void watchScene(Ogre::SceneManager& sceneManager) {
    theWatch().watch(sceneManager);
}

void unwatchScenes() {
    theWatch().end();
}

} // namespace Lixel

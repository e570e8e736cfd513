#pragma once

#include "scene/OgreVersions.h"

#include <OgreSceneManager.h>

#include <map>
#include <memory>
#include <utility>

namespace Lixel {

/** One listener for each scene manager, made when it is first asked for; it goes with the scene
    manager.

    @tparam Listener derived from SceneManagerListener, which leaves sceneManagerDestroyed alone
*/
template <typename Listener>
class PerScene {
public:
    struct Result {
        Listener& listener;
        bool isNew;
    };

    /// @param arguments of its constructor, where it has to be made
    template <typename... Arguments>
    Result of(Ogre::SceneManager& sceneManager, Arguments&&... arguments) {
        std::unique_ptr<Entry>& entry = mEntries[&sceneManager];
        const bool isNew = entry == nullptr;
        if (isNew)
            entry =
                std::make_unique<Entry>(*this, sceneManager, std::forward<Arguments>(arguments)...);
        return {*entry, isNew};
    }

    /// Null where it was not made.
    Listener* find(Ogre::SceneManager& sceneManager) const {
        const auto found = mEntries.find(&sceneManager);
        return found == mEntries.end() ? nullptr : found->second.get();
    }

    template <typename Visit>
    void forEach(const Visit& visit) const {
        for (const auto& [sceneManager, entry] : mEntries)
            visit(*sceneManager, static_cast<Listener&>(*entry));
    }

    void clear() { mEntries.clear(); }

private:
    class Entry final : public Listener {
    public:
        template <typename... Arguments>
        Entry(PerScene& all, Ogre::SceneManager& sceneManager, Arguments&&... arguments)
            : Listener(std::forward<Arguments>(arguments)...),
              mAll(all),
              mSceneManager(sceneManager) {
            addSceneManagerListener(mSceneManager, *this);
        }
        ~Entry() override { removeSceneManagerListener(mSceneManager, *this); }
        Entry(const Entry&) = delete;
        Entry& operator=(const Entry&) = delete;

        void sceneManagerDestroyed(Ogre::SceneManager* source) override {
            mAll.mEntries.erase(source); // destroys this
        }

    private:
        PerScene& mAll;
        Ogre::SceneManager& mSceneManager;
    };

    std::map<Ogre::SceneManager*, std::unique_ptr<Entry>> mEntries;
};

} // namespace Lixel

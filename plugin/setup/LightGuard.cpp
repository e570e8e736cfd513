#include "setup/LightGuard.h"

#include "scene/OgreVersions.h"

#include <OgreLight.h>
#include <OgreLogManager.h>
#include <OgreSceneManager.h>

#include <cmath>
#include <map>
#include <memory>
#include <set>

namespace Lixel {
namespace {

bool isFinite(const Ogre::Vector3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isUsable(const Ogre::Light& light) {
    return (light.getType() == Ogre::Light::LT_POINT || isFinite(light.getDerivedDirection())) &&
           (light.getType() == Ogre::Light::LT_DIRECTIONAL || isFinite(light.getDerivedPosition()));
}

class Guard : public Ogre::SceneManager::Listener {
public:
    void preUpdateSceneGraph(Ogre::SceneManager* source, Ogre::Camera*) override {
        for (const auto& [name, object] :
             source->getMovableObjects(LightTypeName)) {
            Ogre::Light& light = static_cast<Ogre::Light&>(*object);
            const bool usable = isUsable(light);
            if (!usable && light.getVisible()) {
                light.setVisible(false);
                mHidden.insert(name);
                Ogre::LogManager::getSingleton().logWarning(
                    "Lixel: light '" + name +
                    "' has a direction or position that is not finite; it neither shines nor "
                    "casts shadows until it has");
            } else if (usable && mHidden.erase(name) != 0) {
                light.setVisible(true);
            }
        }
    }

    void sceneManagerDestroyed(Ogre::SceneManager* source) override;

private:
    std::set<Ogre::String> mHidden;
};

std::map<Ogre::SceneManager*, std::unique_ptr<Guard>>& guards() {
    static std::map<Ogre::SceneManager*, std::unique_ptr<Guard>> map;
    return map;
}

void Guard::sceneManagerDestroyed(Ogre::SceneManager* source) {
    guards().erase(source); // destroys this
}

} // namespace

void guardLights(Ogre::SceneManager& sceneManager) {
    std::unique_ptr<Guard>& guard = guards()[&sceneManager];
    if (guard) return;
    guard = std::make_unique<Guard>();
    sceneManager.addListener(guard.get());
}

} // namespace Lixel

#include "scene/Identity.h"

#include "scene/OgreVersions.h"

#include <OgreAny.h>
#include <OgreCamera.h>
#include <OgreLight.h>
#include <OgreSceneManager.h>
#include <OgreUserObjectBindings.h>

namespace Lixel {
namespace {

const Ogre::String Key = "Lixel/Identity";

} // namespace

Identity identityOf(const Ogre::MovableObject& object) {
    const Ogre::Any& known = object.getUserObjectBindings().getUserAny(Key);
    if (known.has_value()) return Ogre::any_cast<Identity>(known);
    static Identity last = 0;
    ++last;
    // What is remembered of an object is not the object: nobody else can see a difference.
    const_cast<Ogre::MovableObject&>(object).getUserObjectBindings().setUserAny(Key,
                                                                                Ogre::Any(last));
    return last;
}

void forgetIdentities(Ogre::SceneManager& sceneManager) {
    // A camera is a renderable too, which has user objects of its own.
    const auto forget = [](Ogre::MovableObject& object) {
        object.getUserObjectBindings().eraseUserAny(Key);
    };
    for (const auto& [name, light] :
         sceneManager.getMovableObjects(LightTypeName))
        forget(*light);
    for (const auto& [name, camera] : sceneManager.getCameras())
        forget(*camera);
}

} // namespace Lixel

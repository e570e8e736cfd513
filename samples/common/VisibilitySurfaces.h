#pragma once

#include <Ogre.h>

#include <utility>
#include <vector>

namespace Lixel::Samples {

/** While it lives, all entities of a scene manager show how much of their light each pixel gets:
    white where it is lit, black in shadow, by the nearest texel.

    For integrated shadow techniques, under which surfaces read shadow maps themselves, up to six of
    a light. Additive ones have a receiver for that, Lixel/Receiver/Visibility. What is drawn is
    covered without holes, as clones of Lixel/Surface are; ambient light is added.
*/
class VisibilitySurfaces {
public:
    explicit VisibilitySurfaces(Ogre::SceneManager& sceneManager);
    ~VisibilitySurfaces();
    VisibilitySurfaces(const VisibilitySurfaces&) = delete;
    VisibilitySurfaces& operator=(const VisibilitySurfaces&) = delete;

private:
    /// What each part of an entity wore.
    std::vector<std::pair<Ogre::SubEntity*, Ogre::MaterialPtr>> mSurfaces;
};

} // namespace Lixel::Samples

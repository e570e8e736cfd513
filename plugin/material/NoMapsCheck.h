#pragma once

namespace Ogre {
class SceneManager;
class Viewport;
} // namespace Ogre

namespace Lixel {

/** Says in the log that a scene manager draws with Lixel's materials where no map is ever fitted.

    Each of these is logged once: there are no shadow textures; no light has a setup that tells
    observers of its maps. Both are normal while a scene is being built. So the check waits for some
    views without maps in a row, and is repeated after every so many.
*/
class NoMapsCheck {
public:
    explicit NoMapsCheck(Ogre::SceneManager& manager) : mManager(manager) {}

    void mapFitted() { mViews = 0; }
    /// What is queued for a viewport is about to be drawn, and no map was fitted for it.
    void checkQueue(const Ogre::Viewport& viewport);

private:
    bool drawsLixelsMaterials() const;
    void check();

    Ogre::SceneManager& mManager;
    /// Drawn since a map was fitted.
    unsigned mViews = 0;
    bool mSaidNoTextures = false;
    bool mSaidNoSetup = false; ///< or none of the lights' types
};

} // namespace Lixel

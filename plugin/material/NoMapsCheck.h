#pragma once

namespace Ogre {
class SceneManager;
class Viewport;
} // namespace Ogre

namespace Lixel {

/** Says in the log that a scene manager draws with Lixel's materials where no map is ever fitted.

    Each is said once: that there are no shadow textures; that no light has a setup which tells of
    its maps. Both are how things look while a scene is being made, so it is not before some views
    without maps have been drawn in a row, and then every so many, that it looks.
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
    bool mSaidNoSetup = false;
};

} // namespace Lixel

#pragma once

#include "scene/Fingerprint.h"

#include <OgreTexture.h>

#include <memory>
#include <optional>

namespace Ogre {
class Camera;
class RenderTarget;
class SceneManager;
class Viewport;
} // namespace Ogre

namespace Lixel {

struct ShadowFit;

/// What a shadow map's texture shows.
struct MapContent {
    /// No caster at all: cleared.
    bool empty = false;
    /// Where it was drawn from. @see matricesOf
    Fingerprint matrices;
    /// How it was drawn.
    Fingerprint settings;
    /// What was drawn, where that was asked for.
    std::optional<Fingerprint> casters;
    /// The texture, and how often it had been loaded or unloaded then.
    std::weak_ptr<Ogre::Texture> texture;
    std::size_t textureState = 0;
};

/// Adds a camera's own view and projection matrix, not those of a culling frustum.
void addMatrices(const Ogre::Camera& camera, Fingerprint& fingerprint);

/// A placed shadow camera's matrices, the depths that its casters store, and the volume that culls
/// them.
Fingerprint matricesOf(const Ogre::Camera& shadowCamera, const ShadowFit& fit);

/// All that decides on how casters are drawn, except the casters.
/// @param view the viewport that the viewer's picture is drawn in
Fingerprint settingsOf(Ogre::SceneManager& manager, const Ogre::Camera& shadowCamera,
                       const Ogre::Viewport& view);

/// Whether casters are drawn in a caster material that is known to draw them alike each time.
bool hasKnownCasterMaterial(Ogre::SceneManager& manager);

/// Whether casters store depths by Lixel's fragment program in this target's colours.
bool storesDepthAsColour(Ogre::SceneManager& manager, const Ogre::RenderTarget& target);

/// Whether an application's listener takes part in what is drawn.
bool hasForeignListener(const Ogre::SceneManager& manager);

} // namespace Lixel

#pragma once

#include "fit/geometry/Types.h"
#include "setup/MapContent.h"

#include <optional>
#include <vector>

namespace Ogre {
class Camera;
class Frustum;
class RenderTarget;
class SceneManager;
} // namespace Ogre

namespace Lixel {

struct ShadowTarget;
class StillLayer;

/** Prepares the next drawing of a shadow camera's texture, and undoes it right afterwards.

    Shadow textures and their cameras are shared with whatever setup comes next, OGRE's own
    included, so nothing may stay behind: the culling frustum, depth clamping and the viewport's
    auto-update are all set back when the texture has been drawn; or, where an exception has ended
    the frame, before the next one.
*/

/// Casters nearer than the near plane are clamped onto it instead of clipped, where the render
/// system can; and until after the pass another frustum decides what the camera draws.
/// @param content what its texture shows afterwards, if it is worth knowing
/// @param layer in which it is drawn, planned for this; null where it is drawn at once
void armShadowPass(Ogre::Camera& shadowCamera, Ogre::Frustum& cullingFrustum,
                   const std::optional<MapContent>& content, StillLayer* layer = nullptr);

/// The same for a map that could have been kept: it is compared with what was kept.
void proveShadowPass(Ogre::Camera& shadowCamera, Ogre::Frustum& cullingFrustum,
                     const std::optional<MapContent>& content, const ShadowTarget& target);

/// A culling frustum is about to go: no camera that waits for its pass keeps it.
void releaseShadowPass(const Ogre::Frustum& cullingFrustum);

/// The scene manager's shadow maps, from the one that this camera draws into to the last. Empty
/// where the camera draws into none of them: applications also ask setups for the matrices alone,
/// with a camera of their own.
std::vector<ShadowTarget> shadowTargetsFrom(const Ogre::Camera& camera,
                                            Ogre::SceneManager& sceneManager);

/// No caster is drawn into the texture, which is cleared to "lit" if it is not known to be.
/// @param believed whether the texture could have been kept: proof mode compares
void skipShadowPass(Ogre::Camera& shadowCamera, const ShadowTarget& target, bool believed = false);

/// The texture keeps what it shows. The camera has its culling frustum as if it were drawn.
void keepShadowPass(Ogre::Camera& shadowCamera, Ogre::Frustum& cullingFrustum);

/// What the texture shows. Null where it is new, was made anew, or something else has been drawn
/// into it since.
const MapContent* contentOf(const ShadowTarget& target);

/// The layer in which a shadow camera's map is to be drawn now. Null where it is drawn at once.
StillLayer* layerOf(const Ogre::Camera& shadowCamera, const Ogre::RenderTarget& target);

/// How long the texture's last drawing took, in milliseconds of this thread; 0 where it was not drawn
/// by a setup of Lixel's.
double drawingTimeOf(const ShadowTarget& target);

/// No texture's content is known any more, layers' included.
void forgetContents();
/// How often they were forgotten.
unsigned long contentGeneration();

/// Leaves nothing behind in render targets.
void forgetShadowPasses();

/// Whether the render system clamps depth.
LIXEL_API bool canClampDepth();

} // namespace Lixel

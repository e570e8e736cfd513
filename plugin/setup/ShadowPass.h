#pragma once

#include "fit/geometry/Types.h"

#include <vector>

namespace Ogre {
class Camera;
class Frustum;
class SceneManager;
} // namespace Ogre

namespace Lixel {

struct ShadowTarget;

/** Prepares the next drawing of a shadow camera's texture, and undoes it right afterwards.

    Shadow textures and their cameras are shared with whatever setup comes next, OGRE's own
    included, so nothing may stay behind: the culling frustum, depth clamping and the viewport's
    auto-update are all set back when the texture has been drawn.
*/

/// Casters nearer than the near plane are clamped onto it instead of clipped, where the render
/// system can; and until after the pass another frustum decides what the camera draws.
void armShadowPass(Ogre::Camera& shadowCamera, Ogre::Frustum& cullingFrustum);

/// A culling frustum is about to go: no camera that waits for its pass keeps it.
void releaseShadowPass(const Ogre::Frustum& cullingFrustum);

/// The scene manager's shadow maps, from the one that this camera draws into to the last. Empty
/// where the camera draws into none of them: applications also ask setups for the matrices alone,
/// with a camera of their own.
std::vector<ShadowTarget> shadowTargetsFrom(const Ogre::Camera& camera,
                                            Ogre::SceneManager& sceneManager);

/// The texture is cleared to "lit" and no caster is drawn into it.
void skipShadowPass(Ogre::Camera& shadowCamera);

/// Leaves nothing behind in render targets.
void forgetShadowPasses();

/// Whether the render system clamps depth.
LIXEL_API bool canClampDepth();

} // namespace Lixel

#pragma once

#include "fit/ConvexVolume.h"
#include "fit/ShadowProblem.h"
#include "scene/SceneRules.h"

#include <string>

namespace Ogre {
class Camera;
class MovableObject;
class SceneNode;
class Viewport;
} // namespace Ogre

namespace Lixel {

/** What casts and what receives, this frame, for this viewer.

    OGRE prepares shadow textures before it finds what the main camera sees, so the bounds that it
    offers there are last frame's (OGRE's Focused, LiSPSM and PSSM setups lose all shadows for a
    frame after a camera cut). The survey walks the scene graph instead, whose world boxes are this
    frame's, under any scene manager that keeps movable objects on scene nodes.

    An object counts where OGRE would draw it: visible by its own flag, by the masks of scene
    manager and viewport, and within its rendering distance. It casts as its `castShadows` says; it
    receives where a material of its does (or of what is attached to its bones), its render queue
    group takes part in shadows, and its box is in view. Where the scene manager's self-shadowing is
    off, OGRE lets no caster receive, and neither does the survey. What OGRE leaves out for its size
    in pixels, or because a listener of the object says so, counts nevertheless: the map is then a
    little larger than it need be.

    Boxes of objects that OGRE itself moves later in the frame (auto-tracking nodes, instance
    batches moved by nodes) are last frame's.
*/
class LIXEL_API Survey {
public:
    /// Surveys the scene of `viewer`, as seen through `viewport`.
    void take(const Ogre::Camera& viewer, const Ogre::Viewport& viewport);

    /// The viewer: matrices relative to wsOrigin. Shadow distance is left 0: it is the light's.
    const ShadowViewer& viewer() const { return mViewer; }
    /// The viewer's position in the world, which all boxes are relative to.
    const Vec3& wsOrigin() const { return mWsOrigin; }
    const BoxSet& casters() const { return mCasters; }
    const BoxSet& receivers() const { return mReceivers; }
    /// Name of an object without bounds that casts or receives; empty if there is none.
    const std::string& unboundedName() const { return mUnboundedName; }
    /// Objects looked at, for statistics.
    std::size_t objectCount() const { return mObjectCount; }

private:
    void visit(Ogre::SceneNode& node);
    void visit(Ogre::MovableObject& object);

    ShadowViewer mViewer;
    Vec3 mWsOrigin = Vec3::Zero();
    BoxSet mCasters;
    BoxSet mReceivers;
    std::string mUnboundedName;
    std::size_t mObjectCount = 0;

    // While a survey is taken.
    SceneRules mRules;
    ConvexVolume mView;
};

} // namespace Lixel

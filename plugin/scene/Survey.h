#pragma once

#include "fit/geometry/ConvexVolume.h"
#include "fit/problem/ShadowProblem.h"
#include "fit/sampling/ViewSamples.h"
#include "scene/MeshShapes.h"
#include "scene/NodeWalk.h"
#include "scene/SceneRules.h"

#include <string>
#include <vector>

namespace Ogre {
class Camera;
class MovableObject;
class SceneNode;
class Viewport;
} // namespace Ogre

namespace Lixel {

/** What receives shadows, this frame, in this viewer's view; CasterSearch finds who casts on it.

    OGRE prepares shadow textures before it finds what the main camera sees, so the bounds that it
    offers there are last frame's (OGRE's Focused, LiSPSM and PSSM setups lose all shadows for a
    frame after a camera cut). The survey walks the scene instead, whose world boxes are this
    frame's, under any scene manager that keeps movable objects on scene nodes.

    An object counts where OGRE would draw it: visible by its own flag, by the masks of scene
    manager and viewport, and within its rendering distance. It casts as its `castShadows` says; it
    receives where a material of its does (or of what is attached to its bones), its render queue
    group takes part in shadows, and its box is in view. Where the scene manager's self-shadowing is
    off, OGRE lets no caster receive, and neither does the survey. What OGRE leaves out for its size
    in pixels, or because a listener of the object says so, counts nevertheless: the map is then a
    little larger than it need be.

    Where it is asked for, a large mesh that reaches out of the view is known in parts: each that
    may be in view is a receiver of its own, and what the viewer sees is found once, for all lights
    and maps.

    Boxes of objects that OGRE itself moves later in the frame (auto-tracking nodes, instance
    batches moved by nodes) are last frame's.

    Nothing is kept from one survey to the next but memory, the shapes of meshes (MeshShapes.h), and
    which objects without materials the log was told of (BareParts.h); and where an application
    announces changes of objects (LixelSceneManager), what objects are. What a survey read of them
    holds for searches of casters too, until `forgetObjects`.
*/
class LIXEL_API Survey {
public:
    /// @param meshes that surveys share; must outlive this one
    explicit Survey(MeshShapes& meshes = MeshShapes::shared()) : mMeshes(meshes) {}
    Survey(const Survey&) = delete;
    Survey& operator=(const Survey&) = delete;

    /// Surveys the scene of `viewer`, as seen through `viewport`.
    /// @param shadowDistance as ShadowViewer::shadowDistance: receivers beyond are left out
    /// @param margin share by which the view is widened: for maps that are to last
    /// @param parts that a mesh is known in, at most; 0: as a whole
    void take(const Ogre::Camera& viewer, const Ogre::Viewport& viewport,
              double shadowDistance = 0.0, double margin = 0.0, std::size_t parts = 0);

    /// Has searches with this survey read objects again: call whenever somebody else has had a turn
    /// who may have changed them.
    void forgetObjects() const;

    /// The viewer: matrices relative to wsOrigin. Shadow distance is left 0: it is the light's.
    const ShadowViewer& viewer() const { return mViewer; }
    /// The viewer's position in the world, which all boxes are relative to.
    const Vec3& wsOrigin() const { return mWsOrigin; }
    const BoxSet& receivers() const { return mReceivers; }
    /// Their hulls. They read the objects: good until one is moved or destroyed.
    const BodyShapes& receiverShapes() const { return mReceiverShapes; }
    /// The receivers that have bounds, each once.
    std::span<const Ogre::MovableObject* const> receiverObjects() const { return mReceiverObjects; }
    /** Surfaces of those receivers whose boxes say too little: that the viewer stands in, or near.
        They point into the survey, and hold until its next one. */
    const std::vector<KnownSurface>& surfaces() const { return mSurfaces; }
    /// What the viewer sees of the receivers, where any of them is known in parts; else nothing.
    const std::vector<VisiblePoint>& visiblePoints() const { return mVisiblePoints; }
    /// The box around all receivers that have bounds; without one it is of no meaning.
    Aabb receiverBounds() const { return {(mLower + mUpper) / 2.0, (mUpper - mLower) / 2.0}; }
    /// Name of an object without bounds that casts or receives; empty if there is none.
    const std::string& unboundedName() const { return mUnboundedName; }
    /// Objects looked at, for statistics: those in view or without bounds.
    std::size_t objectCount() const { return mObjectCount; }
    /// What made an object count. Good for as long as the viewer and its viewport are.
    const SceneRules& rules() const { return mRules; }
    /// The shapes of the scene's meshes.
    MeshShapes& meshes() const { return mMeshes; }

private:
    void visit(const NodeWalk::Object& found);
    /// The same of an object whose answers are known.
    void visitKnown(const NodeWalk::Object& found);
    void addReceiver(const Ogre::MovableObject& object, const Aabb& box);
    void addSurface(const Ogre::MovableObject& object, std::size_t receiver);
    /// Adds an object as one receiver. @return false where its box is too large to have bounds
    bool addWhole(const Ogre::MovableObject& object, const Aabb& box);
    /// Adds an object that is known in parts: those in view, or a ground as a whole, whose parts
    /// are for view rays alone. @return whether it is
    bool addParts(const Ogre::MovableObject& object, const Aabb& box);

    SceneRules mRules;
    BareParts mBareParts;
    ShadowViewer mViewer;
    Vec3 mWsOrigin = Vec3::Zero();
    BoxSet mReceivers;
    ObjectShapes mReceiverShapes;
    MeshShapes& mMeshes;
    std::vector<const Ogre::MovableObject*> mReceiverObjects;
    std::vector<KnownSurface> mSurfaces;
    std::vector<VisiblePoint> mVisiblePoints;
    Vec3 mLower = Vec3::Zero();
    Vec3 mUpper = Vec3::Zero();
    std::string mUnboundedName;
    std::size_t mObjectCount = 0;

    // While a survey is taken.
    ConvexVolume mView;
    NodeWalk mWalk;
    NodeStore* mStore = nullptr;
    std::size_t mMostParts = 0;
    /// The receivers that are no parts, and the surfaces of those that are.
    BoxSet mWholes;
    std::vector<KnownSurface> mSurfacesOfWholes;
    std::vector<KnownSurface> mSurfacesOfParts;
    SampleScratch mSampling;
};

} // namespace Lixel

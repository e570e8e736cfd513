#pragma once

#include "fit/geometry/Types.h"
#include "scene/OgreVersions.h"

#include <memory>

namespace Lixel {

class CasterBatches;
class NearestDepth;
class NodeStore;
class VisibleObjects;
struct LayerPart;
struct MapShortcuts;
struct SceneNodes;

/// @addtogroup LixelSceneManager
/// @{

/** A scene manager that knows the bounds of all nodes in flat memory.

        Ogre::SceneManager* scene = root->createSceneManager("LixelSceneManager");

    It draws what OGRE's default scene manager draws, in less time: what a camera sees, and what
    casts shadows on it, is found by a scan of boxes that are kept up to date as nodes move. Lixel's
    setups find receivers and casters in them too.

    What is different from OGRE's default scene manager:
    - `SceneNode::_getWorldAABB()` is the box of the objects of that node alone, as in OGRE's octree
      scene manager. A node is drawn where that box is in view: what is attached to a parent is not
      drawn only because a child is in view.
    - Debug drawing (setDisplaySceneNodes, showBoundingBoxes) shows nodes with objects of their own.
    - A node at a place that is not finite is not drawn, and named in the log once; OGRE aborts.
    - Sphere queries find what is alone on its node where it is, as boxes and rays do. OGRE's know the
      sphere of the last frame that showed the object, if one did.
    - Objects are queued in the order in which their nodes first had something attached, not in the
      order of the graph. It makes a difference only between surfaces of one material at one depth.
    - A node that a listener moves while the scene graph is updated is updated the next time. With
      OGRE's own scene managers it may stay where it was for good.
    - Casters by Lixel's programs store the nearest depth of each texel, whatever the order in which
      they are drawn. OGRE's depth test compares other numbers than are stored, and decides by the
      order where two casters are equally near.
    - Where some of a map's casters move, it is drawn in two layers (CommonOptions::movingApart):
      what stands still once, and what moves in each frame. A scene manager's listeners hear of two
      searches for a map's casters in a frame that draws both.
*/
class LIXEL_API LixelSceneManager : public Ogre::SceneManager {
public:
    /// What the factory is registered as.
    static constexpr const char* TypeName = "LixelSceneManager";

    explicit LixelSceneManager(const Ogre::String& name);
    ~LixelSceneManager() override;

    /** Whether casters of one mesh are drawn by one call; they are at first.

        In shadow maps that are drawn with Lixel/Caster, four or more entities that share a part of
        a mesh, a culling mode and a place in the render queue are drawn as instances, and each
        texel is that of single draws. Drawn by themselves are: what is mirrored, skinned, animated
        or has levels of detail, what has holes or casters of its own, and whatever is no entity.
        All are where an application listens to the render queue or to single draws
        (RenderQueueListener, RenderableListener, RenderObjectListener) or draws queues in ways of
        its own, and where the render system cannot draw instances, which the log says once.
        @see setProofMode, which draws maps both ways and compares them */
    void setCasterBatches(bool use) { mUsesBatches = use; }
    bool getCasterBatches() const { return mUsesBatches; }

    /** Whether the application announces changes of objects; it does not at first, and nothing has
        to be told: whatever maps may show is read in each frame.

        With true it promises this: all that changes about objects from one frame to the next, it
        announces by announceChange(), except what scene nodes tell by themselves. These tell where
        they are, what is attached to them, and whether they are in the scene graph; so nothing has
        to be announced of what moves, comes or goes. To be announced is whatever else has shadows
        look different: visibility, masks, castShadows, materials and their settings, meshes, parts,
        render queue groups, rendering distances, listeners. (Lights, viewers, setups, shadow
        settings and the caster material are read in each frame all the same, and Lixel::reload
        announces what it changes.)

        Then what plain entities say is remembered while the viewer moves, and maps of a light that
        have come to rest, in front of a viewer who stands still, are kept without a look at the
        scene. Still surveyed in each frame are maps of lights
        - on which something shines that may look different without anybody's word: what casts is
          not a plain entity (MapPlan.h, PlanReason::RestlessCaster), or what receives in view is
          none of an entity without skeleton, vertex animation and attached objects, a manual object
          or static geometry;
        - that the log has complained about, or that shine on bodies without bounds;
        - of a setup that does not say that it depends on its options alone
          (FittedShadowCameraSetup::dependsOnlyOnOptions);
        - while the shapes of meshes are being read, and while visible points are set in each frame;
        - whose matrices alone an application asks a setup for in each frame, for the same viewer.

        A broken promise shows stale shadows. setProofMode finds it where maps are at rest: those
        that would be kept without a look are fitted and drawn nevertheless, and compared. */
    void setChangesAnnounced(bool announced);
    bool getChangesAnnounced() const;
    /// Has all that maps of this scene depend on read anew in the next frame; those that it changes
    /// are drawn. Lixel::redrawShadowMaps has them all drawn, in all scenes, and announces as much.
    void announceChange();

    const Ogre::String& getTypeName() const override;
    void clearScene() override;
    void _updateSceneGraph(Ogre::Camera* camera) override;
    void _findVisibleObjects(Ogre::Camera* camera, Ogre::VisibleObjectsBoundsInfo* visibleBounds,
                             bool onlyShadowCasters) override;
    void _renderScene(Ogre::Camera* camera, Ogre::Viewport* viewport,
                      bool includeOverlays) override;

private:
    bool drawLayers(Ogre::Camera& camera, Ogre::Viewport& viewport, bool includeOverlays,
                    const NearestDepth& nearest);
    void drawPart(Ogre::Camera& camera, Ogre::Viewport& viewport, bool includeOverlays,
                  const LayerPart& part);
    void prove(Ogre::Camera& camera, Ogre::Viewport& viewport, bool includeOverlays,
               const MapShortcuts& shortcuts);
    /// Null where the viewport is no shadow map's.
    Ogre::TexturePtr mapOf(const Ogre::Viewport& viewport);
    bool drawsQueuesAsOgre(Ogre::Viewport& viewport);

    Ogre::SceneNode* createSceneNodeImpl() override;
    Ogre::SceneNode* createSceneNodeImpl(const Ogre::String& name) override;

    std::shared_ptr<SceneNodes> mNodes;
    /// One of them.
    NodeStore* mStore;
    std::unique_ptr<VisibleObjects> mVisible;
    std::unique_ptr<CasterBatches> mBatches;
    bool mUsesBatches = true;
    /// While a map is drawn without them, to be compared.
    bool mProves = false;
    /// What is drawn now of a map's casters; null for all of them.
    const LayerPart* mPart = nullptr;
};

/// Makes LixelSceneManager; the plugin registers one.
class LIXEL_API LixelSceneManagerFactory : public NamedSceneManagerFactory {
public:
    LixelSceneManagerFactory() : NamedSceneManagerFactory(LixelSceneManager::TypeName) {}
    Ogre::SceneManager* createInstance(const Ogre::String& name) override;
    void destroyInstance(Ogre::SceneManager* instance) override;
};

/// @}
} // namespace Lixel

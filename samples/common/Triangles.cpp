#include "common/Triangles.h"

#include "common/BlendedPose.h"
#include "common/TriangleCollector.h"

#include <Ogre.h>
#include <OgreInstanceBatch.h>
#include <OgreInstanceBatchShader.h>
#include <OgreInstanceBatchVTF.h>
#include <OgreInstancedEntity.h>

namespace Lixel::Samples {
namespace {

/// How often a batch's buffers hold the mesh: once where the hardware repeats it. OGRE returns the
/// number nowhere, but a derived class may name it.
struct BatchSize : Ogre::InstanceBatch {
    static std::size_t of(const Ogre::InstanceBatch& batch) {
        return batch.*(&BatchSize::mInstancesPerBatch);
    }
};

std::size_t copiesInBuffers(const Ogre::InstanceBatch& batch) {
    const bool repeats = dynamic_cast<const Ogre::InstanceBatchShader*>(&batch) ||
                         dynamic_cast<const Ogre::InstanceBatchVTF*>(&batch);
    return repeats ? BatchSize::of(batch) : 1;
}

/// Adds the parts of one object.
class PartVisitor : public Ogre::Renderable::Visitor {
public:
    PartVisitor(TriangleCollector& collector, Ogre::MovableObject& object, const BlendedPose* pose)
        : mCollector(collector), mObject(object), mPose(pose) {}

    void visitAll() { mObject.visitRenderables(this, false); }

    void visit(Ogre::Renderable* renderable, Ogre::ushort lod, bool debug, Ogre::Any*) override {
        // Other levels of detail of the same object come with a number above 0; what skips the
        // projection is drawn on the screen, not in the world.
        if (lod > 0 || debug || renderable->getUseIdentityProjection()) return;
        auto* const part = dynamic_cast<Ogre::SubEntity*>(renderable);
        if (part && !part->isVisible()) return;
        Ogre::RenderOperation operation;
        renderable->getRenderOperation(operation);
        if (part && mPose) operation.vertexData = mPose->verticesOf(*part, operation.vertexData);
        mCollector.add(mCollector.read(mObject, renderable->getMaterial(), operation),
                       wsFromObject(*renderable, part), TriangleCollector::isMirrored(*renderable));
    }

private:
    Ogre::Matrix4 wsFromObject(const Ogre::Renderable& renderable,
                               const Ogre::SubEntity* part) const {
        // A part that a GPU skins has a matrix for each bone.
        if (part) return part->getParent()->_getParentNodeFullTransform();
        if (renderable.getNumWorldTransforms() != 1)
            OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                        "'" + mObject.getName() + "' has more than one world matrix",
                        "collectTriangles");
        Ogre::Matrix4 transform;
        renderable.getWorldTransforms(&transform);
        return transform;
    }

    TriangleCollector& mCollector;
    Ogre::MovableObject& mObject;
    const BlendedPose* mPose;
};

/// Objects below a node, the visible ones only, in the order in which they were attached.
class Walk {
public:
    Walk(TriangleCollector& collector, Ogre::uint32 visibilityMask)
        : mCollector(collector), mMask(visibilityMask) {}

    void node(const Ogre::SceneNode& sceneNode) {
        for (Ogre::MovableObject* movable : sceneNode.getAttachedObjects())
            object(*movable);
        for (const Ogre::Node* child : sceneNode.getChildren())
            node(*static_cast<const Ogre::SceneNode*>(child));
    }

private:
    bool isShown(const Ogre::MovableObject& movable) const {
        return movable.getVisible() && (movable.getVisibilityFlags() & mMask) != 0;
    }

    void object(Ogre::MovableObject& movable) {
        if (!isShown(movable)) return;
        const Ogre::String& type = movable.getMovableType();
        if (type == "ManualObject" || type == "StaticGeometry")
            PartVisitor(mCollector, movable, nullptr).visitAll();
        if (auto* const batch = dynamic_cast<Ogre::InstanceBatch*>(&movable)) instances(*batch);
        if (auto* const entity = dynamic_cast<Ogre::Entity*>(&movable)) entityParts(*entity);
    }

    void entityParts(Ogre::Entity& entity) {
        const BlendedPose pose(entity);
        PartVisitor(mCollector, entity, &pose).visitAll();
        for (Ogre::MovableObject* child : entity.getAttachedObjects())
            object(*child);
    }

    /// Not from the nodes of the instances, since an instance needs none.
    void instances(Ogre::InstanceBatch& batch) {
        Ogre::RenderOperation operation;
        batch.getRenderOperation(operation);
        const DrawnPart part =
            mCollector.read(batch, batch.getMaterial(), operation, copiesInBuffers(batch));
        const bool mirrored = TriangleCollector::isMirrored(batch);
        std::vector<Ogre::InstancedEntity*> used;
        std::vector<Ogre::Vector4> parameters;
        batch.getInstancedEntitiesInUse(used, parameters);
        for (const Ogre::InstancedEntity* instance : used) {
            if (!isShown(*instance)) continue;
            if (instance->hasSkeleton())
                OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                            "'" + instance->getName() +
                                "' has bones: the pose of an instance cannot be read back",
                            "collectTriangles");
            mCollector.add(part, instance->_getParentNodeFullTransform(), mirrored);
        }
    }

    TriangleCollector& mCollector;
    Ogre::uint32 mMask;
};

} // namespace

void TriangleScene::add(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                        const Eigen::Vector3d& c, Triangle flags) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), {a, b, c});
    flags.vertices = {first, first + 1, first + 2};
    triangles.push_back(flags);
}

Eigen::AlignedBox3d TriangleScene::box() const {
    Eigen::AlignedBox3d box;
    for (const Triangle& triangle : triangles)
        for (const std::uint32_t vertex : triangle.vertices)
            box.extend(positions[vertex]);
    return box;
}

TriangleScene collectTriangles(Ogre::SceneManager& sceneManager, const Eigen::Vector3d& wsOrigin) {
    TriangleScene scene;
    scene.wsOrigin = wsOrigin;
    // What SceneManager::_updateSceneGraph does before it draws.
    Ogre::Node::processQueuedUpdates();
    sceneManager.getRootSceneNode()->_update(true, false);
    TriangleCollector collector(scene, sceneManager.getFlipCullingOnNegativeScale());
    Walk(collector, sceneManager.getVisibilityMask()).node(*sceneManager.getRootSceneNode());
    return scene;
}

} // namespace Lixel::Samples

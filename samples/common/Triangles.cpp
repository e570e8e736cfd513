#include "common/Triangles.h"

#include <Lixel/scene/MeshBuffers.h>
#include <Lixel/scene/OgreMath.h>

#include <Ogre.h>

namespace Lixel::Samples {
namespace {

/// Float world matrix as OGRE hands it to the GPU, taken relative to an origin in double.
Eigen::Affine3d relativeTransform(const Ogre::Matrix4& wsFromObject,
                                  const Eigen::Vector3d& origin) {
    Eigen::Affine3d transform(toDouble(wsFromObject));
    transform.pretranslate(-origin);
    return transform;
}

/// The pass that decides which sides are drawn; null for a material without any.
const Ogre::Pass* firstPass(const Ogre::Material& material) {
    const auto& supported = material.getSupportedTechniques();
    const auto& all = material.getTechniques();
    const Ogre::Technique* technique =
        !supported.empty() ? supported.front() : (all.empty() ? nullptr : all.front());
    return technique && technique->getNumPasses() > 0 ? technique->getPass(0) : nullptr;
}

/// Appends what one movable object draws.
class Collector : public Ogre::Renderable::Visitor {
public:
    Collector(TriangleScene& scene, const Ogre::SceneManager& sceneManager)
        : mScene(scene), mFlipMirrored(sceneManager.getFlipCullingOnNegativeScale()) {}

    void collect(Ogre::MovableObject& object) {
        mObject = &object;
        object.visitRenderables(this, false);
    }

    void visit(Ogre::Renderable* renderable, Ogre::ushort lod, bool debug, Ogre::Any*) override {
        // Other levels of detail of the same object come with a number above 0; what skips the
        // projection is drawn on the screen, not in the world.
        if (lod > 0 || debug || renderable->getUseIdentityProjection()) return;
        const auto* part = dynamic_cast<const Ogre::SubEntity*>(renderable);
        if (part && !part->isVisible()) return;
        if (renderable->getNumWorldTransforms() != 1)
            OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                        "'" + mObject->getName() +
                            "' is skinned in hardware: its pose cannot be read back",
                        "collectTriangles");
        append(*renderable);
    }

private:
    void append(Ogre::Renderable& renderable) {
        Ogre::RenderOperation operation;
        renderable.getRenderOperation(operation);
        if (!operation.vertexData || operation.vertexData->vertexCount == 0) return;
        const std::vector<TriangleCorners> corners = readTriangles(operation);
        if (corners.empty()) return;

        Ogre::Matrix4 wsFromObject;
        renderable.getWorldTransforms(&wsFromObject);
        const Eigen::Affine3d transform = relativeTransform(wsFromObject, mScene.wsOrigin);
        const std::size_t first = mScene.positions.size();
        for (const Vec3& position : readPositions(*operation.vertexData))
            mScene.positions.push_back(transform * position);

        bool turned = mFlipMirrored && transform.linear().determinant() < 0.0;
        const Triangle flags = flagsOf(renderable.getMaterial(), turned);
        for (TriangleCorners triangle : corners) {
            if (turned) std::swap(triangle[1], triangle[2]);
            for (std::uint32_t& vertex : triangle) {
                if (vertex >= operation.vertexData->vertexCount)
                    OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                                "'" + mObject->getName() + "' has an index beyond its vertices",
                                "collectTriangles");
                vertex += static_cast<std::uint32_t>(first);
            }
            mScene.triangles.push_back(flags);
            mScene.triangles.back().vertices = triangle;
        }
    }

    /// Flags of every triangle of this material; `turned` is inverted where its front is clockwise.
    Triangle flagsOf(const Ogre::MaterialPtr& material, bool& turned) const {
        Triangle flags;
        flags.casts = mObject->getCastShadows();
        if (!material) return flags;
        flags.receives = material->getReceiveShadows();
        if (material->isTransparent() && !material->getTransparencyCastsShadows())
            flags.casts = false;
        if (const Ogre::Pass* pass = firstPass(*material)) {
            flags.drawnFromBack = pass->getCullingMode() == Ogre::CULL_NONE;
            if (pass->getCullingMode() == Ogre::CULL_ANTICLOCKWISE) turned = !turned;
        }
        return flags;
    }

    TriangleScene& mScene;
    bool mFlipMirrored;
    Ogre::MovableObject* mObject = nullptr;
};

/// Objects below a node, the visible ones only, in the order in which they were attached.
class Walk {
public:
    Walk(Collector& collector, Ogre::uint32 visibilityMask)
        : mCollector(collector), mMask(visibilityMask) {}

    void node(const Ogre::SceneNode& sceneNode) {
        for (Ogre::MovableObject* movable : sceneNode.getAttachedObjects())
            object(*movable);
        for (const Ogre::Node* child : sceneNode.getChildren())
            node(*static_cast<const Ogre::SceneNode*>(child));
    }

private:
    void object(Ogre::MovableObject& movable) {
        if (!movable.getVisible() || (movable.getVisibilityFlags() & mMask) == 0) return;
        const Ogre::String& type = movable.getMovableType();
        if (type == "ManualObject" || type == "StaticGeometry") mCollector.collect(movable);
        if (type != "Entity") return;
        auto& entity = static_cast<Ogre::Entity&>(movable);
        if (entity.hasSkeleton() || entity.hasVertexAnimation()) entity._updateAnimation();
        mCollector.collect(entity);
        for (Ogre::MovableObject* child : entity.getAttachedObjects())
            object(*child);
    }

    Collector& mCollector;
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
    Collector collector(scene, sceneManager);
    Walk(collector, sceneManager.getVisibilityMask()).node(*sceneManager.getRootSceneNode());
    return scene;
}

} // namespace Lixel::Samples

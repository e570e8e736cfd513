#include "OwnBoxesManager.h"

#include "scene/OgreVersions.h"

#include <OgreCamera.h>
#include <OgreMovableObject.h>
#include <OgreRenderQueue.h>
#include <OgreSceneNode.h>

#include <set>
#include <utility>

namespace Lixel::Tests {
namespace {

class OwnBoxNode : public Ogre::SceneNode {
public:
    OwnBoxNode(Ogre::SceneManager* manager, const Ogre::String& name, std::set<OwnBoxNode*>& all)
        : SceneNode(manager, name), mAll(all) {
        mAll.insert(this);
    }
    ~OwnBoxNode() override { mAll.erase(this); }

    void _updateBounds() override {
        late = std::exchange(mWorldAABB, Ogre::AxisAlignedBox());
        for (Ogre::MovableObject* object : getAttachedObjects())
            mWorldAABB.merge(object->getWorldBoundingBox(true));
    }

    /// The box before the last update.
    Ogre::AxisAlignedBox late;

private:
    std::set<OwnBoxNode*>& mAll;
};

/// A set of nodes that outlives all of them: OGRE destroys nodes after the derived manager.
struct AllNodes {
    std::set<OwnBoxNode*> mAllNodes;
};

class OwnBoxes : private AllNodes, public Ogre::SceneManager {
public:
    OwnBoxes(const Ogre::String& name, Fault fault)
        : SceneManager(name), mFault(fault), mType(faultyManager(fault)) {}
    const Ogre::String& getTypeName() const override { return mType; }

protected:
    Ogre::SceneNode* createSceneNodeImpl() override { return createSceneNodeImpl(""); }
    Ogre::SceneNode* createSceneNodeImpl(const Ogre::String& name) override {
        return new OwnBoxNode(this, name, mAllNodes);
    }

    void _findVisibleObjects(Ogre::Camera* camera, Ogre::VisibleObjectsBoundsInfo* bounds,
                             bool onlyShadowCasters) override {
        showTree(*getRootSceneNode(), *camera, onlyShadowCasters, bounds);
        if (mFault != Fault::LeftNodes) return;
        for (OwnBoxNode* node : mAllNodes)
            if (!node->isInSceneGraph()) showNode(*node, *camera, onlyShadowCasters, bounds);
    }

private:
    void showTree(Ogre::SceneNode& node, Ogre::Camera& camera, bool onlyShadowCasters,
                  Ogre::VisibleObjectsBoundsInfo* bounds) {
        showNode(static_cast<OwnBoxNode&>(node), camera, onlyShadowCasters, bounds);
        for (Ogre::Node* child : node.getChildren())
            showTree(static_cast<Ogre::SceneNode&>(*child), camera, onlyShadowCasters, bounds);
    }

    void showNode(OwnBoxNode& node, Ogre::Camera& camera, bool onlyShadowCasters,
                  Ogre::VisibleObjectsBoundsInfo* bounds) {
        if (!isSeen(node, camera)) return;
        for (Ogre::MovableObject* object : node.getAttachedObjects()) {
            show(*object, camera, onlyShadowCasters, bounds);
            if (mFault == Fault::SecondObjects) break;
        }
        if (getDebugDrawer() != nullptr && mFault != Fault::NoDebugDrawing)
            getDebugDrawer()->drawSceneNode(&node);
    }

    bool isSeen(const OwnBoxNode& node, const Ogre::Camera& camera) const {
        const Ogre::AxisAlignedBox& box =
            mFault == Fault::LateBoxes ? node.late : node._getWorldAABB();
        if (box.isInfinite()) return mFault != Fault::NoInfiniteBoxes;
        if (mFault == Fault::LooseFrustum && !box.isNull())
            return camera.isVisible(Ogre::Sphere(box.getCenter(), box.getHalfSize().length()));
        return camera.isVisible(box);
    }

    void show(Ogre::MovableObject& object, Ogre::Camera& camera, bool onlyShadowCasters,
              Ogre::VisibleObjectsBoundsInfo* bounds) {
        if (mFault == Fault::NoNotification) {
            if (!object.isVisible() || (onlyShadowCasters && !object.getCastShadows())) return;
            object._updateRenderQueue(getRenderQueue());
            bounds->merge(object.getWorldBoundingBox(true), object.getWorldBoundingSphere(true),
                          &camera, object.getReceivesShadows());
        } else {
            Ogre::VisibleObjectsBoundsInfo none;
            getRenderQueue()->processVisibleObject(&object, &camera, onlyShadowCasters,
                                                   mFault == Fault::NoBounds ? &none : bounds);
        }
    }

    Fault mFault;
    Ogre::String mType;
};

class OwnBoxesFactory : public NamedSceneManagerFactory {
public:
    explicit OwnBoxesFactory(Fault fault)
        : NamedSceneManagerFactory(faultyManager(fault)), mFault(fault) {}
    Ogre::SceneManager* createInstance(const Ogre::String& name) override {
        return new OwnBoxes(name, mFault);
    }
    void destroyInstance(Ogre::SceneManager* manager) override { delete manager; }

private:
    Fault mFault;
};

} // namespace

std::ostream& operator<<(std::ostream& out, Fault fault) {
    constexpr std::array names{"None",      "SecondObjects",   "LeftNodes",
                               "LateBoxes", "NoInfiniteBoxes", "NoNotification",
                               "NoBounds",  "NoDebugDrawing",  "LooseFrustum"};
    return out << names.at(static_cast<std::size_t>(fault));
}

std::string faultyManager(Fault fault) {
    return fault == Fault::None ? OwnBoxesManager
                                : "FaultyManager" + std::to_string(static_cast<int>(fault));
}

std::unique_ptr<Ogre::SceneManagerFactory> makeOwnBoxesFactory(Fault fault) {
    return std::make_unique<OwnBoxesFactory>(fault);
}

} // namespace Lixel::Tests

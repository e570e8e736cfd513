#include "scene/NodeWalk.h"

#include "scene/NodeStore.h"
#include "scene/Octants.h"
#include "scene/OgreVersions.h"

#include <OgreMovableObject.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>

namespace Lixel {
namespace {

/// How many nodes ahead memory is asked for: what the store keeps of a node, then the node and its
/// object, which lie all over the heap.
constexpr std::size_t PlacesAhead = 32;
constexpr std::size_t NodesAhead = 16;

class GraphWalk {
public:
    GraphWalk(const NodeCuller& volume, std::vector<Ogre::SceneNode*>& nodes)
        : mVolume(volume), mNodes(nodes) {}

    void visit(Ogre::SceneNode& node) {
        if (!node.getAttachedObjects().empty()) mNodes.push_back(&node);
        for (Ogre::Node* const child : node.getChildren()) {
            auto& sceneChild = static_cast<Ogre::SceneNode&>(*child);
            if (!mVolume.excludes(sceneChild._getWorldAABB(), mGuess)) visit(sceneChild);
        }
    }

private:
    const NodeCuller& mVolume;
    std::vector<Ogre::SceneNode*>& mNodes;
    std::size_t mGuess = 0;
};

void collectAll(Ogre::SceneNode& node, std::vector<Ogre::SceneNode*>& nodes) {
    if (!node.getAttachedObjects().empty()) nodes.push_back(&node);
    for (Ogre::Node* child : node.getChildren())
        collectAll(static_cast<Ogre::SceneNode&>(*child), nodes);
}

} // namespace

void NodeWalk::collectFromStore(const NodeStore& store, const NodeCuller& volume) {
    store.find(volume, mSearch);
    std::size_t guess = 0;
    mSearch.decide([&](NodeStore::Slot slot) { return volume.excludes(store.box(slot), guess); });
    const std::vector<NodeStore::Slot>& found = mSearch.found;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (i + PlacesAhead < found.size()) store.prefetchPlace(found[i + PlacesAhead]);
        if (i + NodesAhead < found.size() && store.known(found[i + NodesAhead]) == 0)
            store.prefetch(found[i + NodesAhead]);
        if (const unsigned known = store.known(found[i]); known != 0) {
            mObjects.push_back({store.onlyObject(found[i]), true, found[i], known});
            continue;
        }
        const Ogre::SceneNode& node = store.node(found[i]);
        if (!node.isInSceneGraph()) continue;
        if (Ogre::MovableObject* const object = store.onlyObject(found[i]))
            mObjects.push_back({object, true, found[i]});
        else
            for (Ogre::MovableObject* const several : node.getAttachedObjects())
                mObjects.push_back({several, false});
    }
}

std::span<const NodeWalk::Object> NodeWalk::collect(Ogre::SceneManager& manager,
                                                    const NodeCuller& volume) {
    mObjects.clear();
    if (const NodeStore* const store = findStore(manager)) {
        collectFromStore(*store, volume);
        return mObjects;
    }
    mNodes.clear();
    bool culled = true;
    if (!collectFromOctants(manager, volume, mNodes)) {
        culled = isDefaultSceneManager(manager);
        if (culled)
            GraphWalk(volume, mNodes).visit(*manager.getRootSceneNode());
        else
            collectAll(*manager.getRootSceneNode(), mNodes);
    }
    for (const Ogre::SceneNode* node : mNodes)
        for (Ogre::MovableObject* object : node->getAttachedObjects())
            mObjects.push_back(
                {object, culled && object->getWorldBoundingBox() == node->_getWorldAABB()});
    return mObjects;
}

} // namespace Lixel

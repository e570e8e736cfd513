#include "scene/NodeWalk.h"

#include "scene/Octants.h"
#include "scene/OgreVersions.h"

#include <OgreSceneManager.h>
#include <OgreSceneNode.h>

namespace Lixel {
namespace {

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

bool collectNodes(Ogre::SceneManager& manager, const NodeCuller& volume,
                  std::vector<Ogre::SceneNode*>& nodes) {
    nodes.clear();
    if (collectFromOctants(manager, volume, nodes)) return true;
    const bool isDefault = isDefaultSceneManager(manager);
    if (isDefault)
        GraphWalk(volume, nodes).visit(*manager.getRootSceneNode());
    else
        collectAll(*manager.getRootSceneNode(), nodes);
    return isDefault;
}

} // namespace Lixel

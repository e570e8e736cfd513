#include "scene/Octants.h"

#include <Plugins/OctreeSceneManager/OgreOctree.h>
#include <Plugins/OctreeSceneManager/OgreOctreeNode.h>
#include <Plugins/OctreeSceneManager/OgreOctreeSceneManager.h>

#include <string_view>
#include <typeinfo>

// The sanitizer's check of dynamic types would need the plugin's type information at link time.
#define LIXEL_WITHOUT_PLUGINS_TYPES __attribute__((no_sanitize("vptr")))

namespace Lixel {
namespace {

/// Whether it is that class and none derived from it, which may draw by other rules. Its type is
/// asked for by name: comparing type_info objects would need the plugin's.
bool isOctree(const Ogre::SceneManager& manager) {
    return std::string_view(typeid(manager).name()) == "N4Ogre18OctreeSceneManagerE";
}

/// The way to the scene manager's octree, which it keeps from everyone but classes derived from it.
struct Access : Ogre::OctreeSceneManager {
    LIXEL_WITHOUT_PLUGINS_TYPES static Ogre::Octree* octreeOf(Ogre::SceneManager& manager) {
        return static_cast<Ogre::OctreeSceneManager&>(manager).*&Access::mOctree;
    }
};

class OctantWalk {
public:
    OctantWalk(const NodeCuller& volume, std::vector<Ogre::SceneNode*>& nodes)
        : mVolume(volume), mNodes(nodes) {}

    LIXEL_WITHOUT_PLUGINS_TYPES void visit(Ogre::Octree& octant) {
        for (Ogre::OctreeNode* node : octant.mNodes)
            if (!mVolume.excludes(node->_getWorldAABB(), mGuess)) mNodes.push_back(node);
        for (auto& plane : octant.mChildren)
            for (auto& row : plane)
                for (Ogre::Octree* child : row)
                    if (child != nullptr && child->numNodes() > 0 &&
                        !mVolume.excludes(looseBounds(*child), mGuess))
                        visit(*child);
    }

private:
    /// What a node of the octant may reach: the octree is a loose one, whose nodes are filed by
    /// their centre. (The outermost octant also takes what fits nowhere; it has no bounds.)
    static Ogre::AxisAlignedBox looseBounds(const Ogre::Octree& octant) {
        return {octant.mBox.getMinimum() - octant.mHalfSize,
                octant.mBox.getMaximum() + octant.mHalfSize};
    }

    const NodeCuller& mVolume;
    std::vector<Ogre::SceneNode*>& mNodes;
    std::size_t mGuess = 0;
};

} // namespace

bool collectFromOctants(Ogre::SceneManager& manager, const NodeCuller& volume,
                        std::vector<Ogre::SceneNode*>& nodes) {
    if (!isOctree(manager)) return false;
    if (Ogre::Octree* const octree = Access::octreeOf(manager); octree != nullptr)
        OctantWalk(volume, nodes).visit(*octree);
    return true;
}

} // namespace Lixel

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace Lixel {

class LixelSceneNode;

/** The children of a scene's root that have moved since the scene graph was last updated, in the
    order in which they did.

    OGRE has its nodes keep such children in a search tree, ordered by their addresses: a leaf of it
    is allocated for each move and freed by the update. That takes about as long as all else of a
    move. Below other nodes than the root children are still kept so.
*/
class MovedNodes {
public:
    /// A node's place, while it is in the list.
    using Index = std::uint32_t;
    static constexpr Index NotListed = std::numeric_limits<Index>::max();

    /// None before the scene graph is first updated.
    const LixelSceneNode* root() const { return mRoot; }
    void setRoot(const LixelSceneNode* root) { mRoot = root; }

    void add(LixelSceneNode& node);
    /// The node goes, or has another parent; what it was moved by is not to be updated any more.
    void remove(LixelSceneNode& node);
    /// Updates them. Those that are moved meanwhile, by listeners, are for the next time.
    void update();

private:
    const LixelSceneNode* mRoot = nullptr;
    /// Null in the place of a node that was removed.
    std::vector<LixelSceneNode*> mNodes;
};

} // namespace Lixel

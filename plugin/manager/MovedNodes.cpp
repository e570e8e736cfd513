#include "manager/MovedNodes.h"

#include "manager/LixelSceneNode.h"

namespace Lixel {

void MovedNodes::add(LixelSceneNode& node) {
    if (node.mMovedIndex != NotListed) return;
    node.mMovedIndex = static_cast<Index>(mNodes.size());
    mNodes.push_back(&node);
}

void MovedNodes::remove(LixelSceneNode& node) {
    if (node.mMovedIndex == NotListed) return;
    mNodes[node.mMovedIndex] = nullptr;
    node.mMovedIndex = NotListed;
}

void MovedNodes::update() {
    // Listeners may add and remove nodes.
    const std::size_t count = mNodes.size();
    for (std::size_t i = 0; i < count; ++i) {
        LixelSceneNode* const node = mNodes[i];
        if (node == nullptr) continue;
        remove(*node);
        node->_update(true, false);
    }
    mNodes.erase(mNodes.begin(), mNodes.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t i = 0; i < mNodes.size(); ++i)
        if (mNodes[i] != nullptr) mNodes[i]->mMovedIndex = static_cast<Index>(i);
}

} // namespace Lixel

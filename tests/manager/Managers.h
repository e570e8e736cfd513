#pragma once

#include <string>

namespace Lixel::Tests {

/// Which nodes' objects a camera is shown.
enum class CullingRule {
    /// Of nodes whose objects, or whose descendants' objects, are in the frustum: OGRE's default.
    MergedBoxes,
    /// Of nodes whose own objects are in the frustum: the octree's rule.
    OwnBoxes
};

/// The scene manager under test, by the name of its type, and the rule that it has to follow. By
/// hand, the environment's LIXEL_CANDIDATE and LIXEL_RULE (merged or own) name others.
struct Candidate {
    std::string manager = "LixelSceneManager";
    CullingRule rule = CullingRule::OwnBoxes;
    /// Whether its queries answer as the default manager's. The octree's find cameras, too.
    bool answersAlike = true;
};

Candidate candidate();

/// The type's name of the scene manager that the rule is read from.
std::string referenceOf(CullingRule rule);

} // namespace Lixel::Tests

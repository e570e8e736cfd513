#pragma once

#include <OgreSceneManager.h>

#include <string>
#include <vector>

namespace Lixel::Tests {

inline const std::string InfiniteMesh = "infinite";
inline const std::string JointedMesh = "jointed";
/// A cube of size 1 that tests give other bounds.
inline const std::string ChangingMesh = "changing";
/// A square that can be reloaded.
inline const std::string ReloadedMesh = "reloaded";

/** Meshes of all kinds, made on first use; `manager` lends a hand. Of one and of several parts,
    with shared vertices, with coarser meshes for afar, with bones (animation "bend"), without
    bounds, and, last, with infinite ones. */
const std::vector<std::string>& meshes(Ogre::SceneManager& manager);

} // namespace Lixel::Tests

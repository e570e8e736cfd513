#pragma once

#include "common/MeshBuilder.h"
#include "common/Random.h"
#include "common/Surface.h"

#include <string>

namespace Lixel::Samples {

/// Where a piece stands: turned by `yawDegrees` about y, then moved.
struct Placement {
    Ogre::Vector3 position = Ogre::Vector3::ZERO;
    float yawDegrees = 0.0F;
    float scale = 1.0F;
};

/// Shows a mesh in a material on a new node below the root.
Ogre::Entity* place(Ogre::SceneManager& sceneManager, const Ogre::MeshPtr& mesh,
                    const Ogre::MaterialPtr& material, const Placement& placement = {});

/// A square that receives and does not cast, facing up at y = 0 about the origin.
Ogre::Entity* placeGround(Ogre::SceneManager& sceneManager, const std::string& name, float halfSide,
                          const Ogre::MaterialPtr& material);

/// A body that is made of two materials.
struct TwoMeshes {
    Ogre::MeshPtr lower;
    Ogre::MeshPtr upper;
};
void place(Ogre::SceneManager& sceneManager, const TwoMeshes& meshes,
           const Ogre::MaterialPtr& lower, const Ogre::MaterialPtr& upper,
           const Placement& placement);

/// A conifer `height` tall: trunk and layered crown.
TwoMeshes spruce(const std::string& name, float height);
/// A broad-leaved tree `height` tall: trunk and a crown of spheres.
TwoMeshes broadleaf(const std::string& name, float height, std::uint32_t seed);
/// Posts, 2 apart, and two rails along x, from -half to half; half is whole.
void addFence(MeshBuilder& mesh, float half);
/// A column with base and capital, `height` tall.
void addColumn(MeshBuilder& mesh, float radius, float height, int segments = 24);

} // namespace Lixel::Samples

#pragma once

#include "common/Random.h"
#include "common/ScenePieces.h"

#include <functional>
#include <string>

namespace Lixel::Samples {

/// The crown of a tree: `leaves` squares of side `leafSize`, each a picture of some leaves.
struct CrownShape {
    float height = 0.0F; ///< of the crown's middle
    float radius = 0.0F;
    int leaves = 0;
    float leafSize = 0.0F;
};

/// Trees and bushes, in two materials.
struct TreeBuilders {
    MeshBuilder wood;   ///< trunks and branches
    MeshBuilder leaves; ///< pictures with holes
    /// Adds a tree that stands at a place of the ground.
    void add(const Ogre::Vector3& foot, const CrownShape& crown, Random& random);
    /// Adds leaves without a trunk, on the ground.
    void addBush(const Ogre::Vector3& foot, float radius, int leaves, Random& random);
};

/// Upright pictures that cross in the middle of their width; their normals point up.
Ogre::MeshPtr tuft(const std::string& name, float width, float height, int pictures);

/// How many instances are drawn with one call.
inline constexpr std::size_t InstancesTogether = 128;

/** Plants many of one mesh as instances that the hardware draws together.
    @param mesh, material their names
    @param pick says where the next one stands; called `count` times. Neighbours should follow each
    other: those that are drawn together share their bounds
*/
void plantInstances(Ogre::SceneManager& sceneManager, const std::string& mesh,
                    const std::string& material, int count,
                    const std::function<Placement(Random&)>& pick, std::uint32_t seed);

} // namespace Lixel::Samples

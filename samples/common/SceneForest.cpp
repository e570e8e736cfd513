#include "common/SceneList.h"
#include "common/ScenePieces.h"
#include "common/ViewsBySeed.h"

#include <cmath>

namespace Lixel::Samples {
namespace {

using Ogre::Vector3;

const std::string ForestPath = "Lixel/Samples/forest/";
constexpr float HalfForest = 70.0F;

float forestHeight(float x, float z) {
    return 1.6F * std::sin(0.06F * x) * std::sin(0.05F * z + 0.7F) +
           0.35F * std::cos(0.19F * x + 0.11F * z);
}

/// A trunk and some bare branches.
void addBareTree(MeshBuilder& mesh, const Vector3& foot, float height, Random& random) {
    const float radius = 0.022F * height;
    mesh.transform = Ogre::Affine3::IDENTITY;
    mesh.transform.setTrans(foot);
    mesh.cone(radius, -0.5F, height, 7);
    const int branches = 5 + random.below(4);
    for (int i = 0; i < branches; ++i) {
        const float at = random.between(0.35F, 0.85F);
        const Ogre::Quaternion around(Ogre::Degree(random.between(0.0F, 360.0F)), Vector3::UNIT_Y);
        const Ogre::Quaternion up(Ogre::Degree(random.between(35.0F, 70.0F)), Vector3::UNIT_Z);
        mesh.transform = Ogre::Affine3(foot + Vector3(0.0F, at * height, 0.0F), around * up);
        mesh.cone(0.45F * radius * (1.0F - at) + 0.012F, 0.0F, 0.32F * height * (1.05F - at), 5);
    }
}

void buildForest(Ogre::SceneManager& sceneManager) {
    MeshBuilder forest;
    addTerrain(forest, forestHeight, HalfForest, 64, -6.0F);
    Random random(404);
    for (int i = 0; i < 420; ++i) {
        const float x = random.between(-HalfForest, HalfForest);
        const float z = random.between(-HalfForest, HalfForest);
        addBareTree(forest, {x, forestHeight(x, z), z}, random.between(6.0F, 15.0F), random);
    }
    place(sceneManager, forest.build(ForestPath + "all"),
          makeSurface(ForestPath + "snow-and-birch", Ogre::ColourValue(0.80F, 0.79F, 0.77F)));
}

} // namespace

SampleScene forestScene() {
    SampleScene scene;
    scene.name = "forest";
    scene.title = "Forest: bare trees in winter; ground and trees are one mesh";
    scene.build = buildForest;
    Random random(4004);
    addViews(scene.views,
             {.name = "walking",
              .eyes = {-45.0F, 1.5F, -45.0F, 45.0F, 1.9F, 45.0F},
              .targets = {-40.0F, 0.0F, -40.0F, 40.0F, 1.0F, 40.0F},
              .leastDistance = 8.0F,
              .farDistance = 250.0F},
             6, random, forestHeight);
    addViews(scene.views,
             {.name = "from-a-stand",
              .eyes = {-45.0F, 9.0F, -45.0F, 45.0F, 18.0F, 45.0F},
              .targets = {-30.0F, 0.0F, -30.0F, 30.0F, 0.0F, 30.0F},
              .leastDistance = 12.0F,
              .farDistance = 250.0F},
             2, random, forestHeight);
    scene.lights = sunsBySeed(random);
    scene.shadowDistance = 120.0F;
    scene.bySeed = true;
    return scene;
}

} // namespace Lixel::Samples

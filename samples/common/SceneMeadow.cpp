#include "common/SceneList.h"
#include "common/ScenePieces.h"
#include "common/ViewsBySeed.h"

#include <algorithm>
#include <cmath>

namespace Lixel::Samples {
namespace {

using Ogre::ColourValue;
using Ogre::Vector3;

const std::string MeadowPath = "Lixel/Samples/meadow/";
constexpr float HalfMeadow = 85.0F;
constexpr std::uint32_t MeadowViewSeed = 1001;

float meadowHeight(float x, float z) {
    return 1.9F * std::sin(0.041F * x + 1.3F) * std::cos(0.036F * z) +
           0.5F * std::sin(0.12F * x - 0.09F * z);
}

Vector3 onMeadow(float x, float z, float above) {
    return {x, meadowHeight(x, z) + above, z};
}

Ogre::MeshPtr makeBush(const std::string& name, std::uint32_t seed) {
    MeshBuilder mesh;
    Random random(seed);
    for (int i = 0; i < 5; ++i)
        mesh.sphere(
            {random.between(-0.7F, 0.7F), random.between(0.3F, 0.9F), random.between(-0.7F, 0.7F)},
            random.between(0.4F, 0.75F), 12);
    return mesh.build(name);
}

std::vector<SampleView> meadowViews(Random& random) {
    std::vector<SampleView> views;
    addViews(views,
             {.name = "walking",
              .eyes = {-55.0F, 1.5F, -55.0F, 55.0F, 1.9F, 55.0F},
              .targets = {-60.0F, 0.0F, -60.0F, 60.0F, 0.5F, 60.0F},
              .leastDistance = 8.0F,
              .farDistance = 350.0F},
             5, random, meadowHeight);
    addViews(views,
             {.name = "from-a-drone",
              .eyes = {-70.0F, 12.0F, -70.0F, 70.0F, 40.0F, 70.0F},
              .targets = {-50.0F, 0.0F, -50.0F, 50.0F, 0.0F, 50.0F},
              .leastDistance = 20.0F,
              .nearDistance = 0.5F,
              .farDistance = 400.0F},
             3, random, meadowHeight);
    return views;
}

/// Puts a mesh in many places, but nowhere over a viewer's head.
void scatter(Ogre::SceneManager& sceneManager, const Ogre::MeshPtr& mesh,
             const Ogre::MaterialPtr& material, int count, float least, float most,
             Random& random) {
    Random viewers(MeadowViewSeed);
    const std::vector<SampleView> views = meadowViews(viewers);
    for (int i = 0; i < count; ++i) {
        const float x = random.between(-HalfMeadow, HalfMeadow);
        const float z = random.between(-HalfMeadow, HalfMeadow);
        const float yaw = random.between(0.0F, 360.0F);
        const Vector3 at = onMeadow(x, z, -0.1F);
        const Placement placement{at, yaw, random.between(least, most)};
        if (std::ranges::any_of(views, [&](const SampleView& view) {
                return at.distance(view.position) < 2.0F * placement.scale + 1.0F;
            }))
            continue;
        place(sceneManager, mesh, material, placement);
    }
}

/// A fence across the meadow, a panel of 4 m after the other.
void fenceOff(Ogre::SceneManager& sceneManager, const Ogre::MeshPtr& panel,
              const Ogre::MaterialPtr& wood, Vector3 from, float yawDegrees, int panels) {
    const Ogre::Quaternion turn(Ogre::Degree(yawDegrees), Vector3::UNIT_Y);
    for (int i = 0; i < panels; ++i) {
        const Vector3 at = from + turn * Vector3(4.0F * static_cast<float>(i), 0.0F, 0.0F);
        place(sceneManager, panel, wood, {onMeadow(at.x, at.z, -0.2F), yawDegrees, 1.0F});
    }
}

void buildMeadow(Ogre::SceneManager& sceneManager) {
    MeshBuilder ground;
    addTerrain(ground, meadowHeight, HalfMeadow, 64, -6.0F);
    place(sceneManager, ground.build(MeadowPath + "ground"),
          makeSurface(MeadowPath + "grass", ColourValue(0.60F, 0.66F, 0.42F),
                      patternTexture(Pattern::Grain)));
    const auto leaves = makeSurface(MeadowPath + "leaves", ColourValue(0.40F, 0.54F, 0.32F));
    const auto stone = makeSurface(MeadowPath + "stone", ColourValue(0.66F, 0.64F, 0.60F));
    const auto wood = makeSurface(MeadowPath + "wood", ColourValue(0.52F, 0.41F, 0.30F));
    Random random(101);
    for (const std::uint32_t seed : {1U, 2U, 3U})
        scatter(sceneManager, makeBush(MeadowPath + "bush" + std::to_string(seed), seed), leaves,
                130, 0.7F, 2.2F, random);
    MeshBuilder boulder;
    boulder.sphere({0.0F, 0.25F, 0.0F}, 0.5F, 10);
    scatter(sceneManager, boulder.build(MeadowPath + "stone"), stone, 350, 0.3F, 2.2F, random);
    MeshBuilder panel;
    addFence(panel, 2.0F);
    const Ogre::MeshPtr fence = panel.build(MeadowPath + "fence");
    for (int i = 0; i < 12; ++i) {
        const Vector3 from(random.between(-75.0F, 15.0F), 0.0F, random.between(-65.0F, 65.0F));
        fenceOff(sceneManager, fence, wood, from, random.between(-35.0F, 35.0F), 16);
    }
}

} // namespace

SampleScene meadowScene() {
    SampleScene scene;
    scene.name = "meadow";
    scene.title = "Meadow: rolling grassland with bushes, stones and fences";
    scene.build = buildMeadow;
    Random random(MeadowViewSeed);
    scene.views = meadowViews(random);
    scene.lights = sunsBySeed(random);
    scene.shadowDistance = 200.0F;
    scene.bySeed = true;
    return scene;
}

} // namespace Lixel::Samples

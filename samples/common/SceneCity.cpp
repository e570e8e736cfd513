#include "common/SceneList.h"
#include "common/ScenePieces.h"
#include "common/ViewsBySeed.h"

#include <algorithm>
#include <array>

namespace Lixel::Samples {
namespace {

using Ogre::ColourValue;
using Ogre::Vector3;

const std::string CityPath = "Lixel/Samples/city/";
constexpr int Blocks = 22; ///< in each direction
constexpr float Block = 36.0F;

/// A house with a parapet and boxes on its flat roof; tall ones step back.
Ogre::MeshPtr makeBlock(const std::string& name, float width, float depth, float height,
                        std::uint32_t seed) {
    MeshBuilder mesh;
    Random random(seed);
    float w = width;
    float d = depth;
    float low = -1.0F;
    for (float top = std::min(height, 30.0F); low < height; top = std::min(height, top + 25.0F)) {
        mesh.box({-0.5F * w, low, -0.5F * d}, {0.5F * w, top, 0.5F * d});
        low = top;
        if (low >= height) break;
        w *= 0.8F;
        d *= 0.8F;
    }
    for (const float side : {-1.0F, 1.0F}) {
        mesh.boxOn({side * 0.5F * (w - 0.6F), height, 0.0F}, 0.6F, 1.1F, d);
        mesh.boxOn({0.0F, height, side * 0.5F * (d - 0.6F)}, w - 1.2F, 1.1F, 0.6F);
    }
    for (int i = 0; i < 3; ++i) {
        const float x = random.between(-0.3F, 0.3F) * w;
        const float z = random.between(-0.3F, 0.3F) * d;
        mesh.boxOn({x, height, z}, random.between(1.5F, 4.0F), random.between(1.5F, 4.0F),
                   random.between(1.5F, 4.0F));
    }
    return mesh.build(name);
}

void buildCity(Ogre::SceneManager& sceneManager) {
    constexpr float Half = 0.5F * Block * static_cast<float>(Blocks) + 100.0F;
    MeshBuilder ground;
    ground.box({-Half, -5.0F, -Half}, {Half, 0.0F, Half});
    place(sceneManager, ground.build(CityPath + "ground"),
          makeSurface(CityPath + "ground", ColourValue(0.60F, 0.60F, 0.58F)));
    std::vector<Ogre::MeshPtr> meshes;
    Random random(505);
    for (const float height : {9.0F, 12.0F, 15.0F, 15.0F, 20.0F, 24.0F, 45.0F, 80.0F}) {
        const auto number = static_cast<std::uint32_t>(meshes.size());
        const float width = random.between(16.0F, 25.0F);
        meshes.push_back(makeBlock(CityPath + "block" + std::to_string(number), width,
                                   random.between(14.0F, 25.0F), height, number));
    }
    const std::array tones{ColourValue(0.76F, 0.66F, 0.55F), ColourValue(0.70F, 0.55F, 0.48F),
                           ColourValue(0.78F, 0.76F, 0.71F), ColourValue(0.56F, 0.60F, 0.64F)};
    std::vector<Ogre::MaterialPtr> walls;
    for (const ColourValue& tone : tones)
        walls.push_back(makeSurface(CityPath + "walls" + std::to_string(walls.size()), tone));
    for (int row = 0; row < Blocks; ++row) {
        for (int column = 0; column < Blocks; ++column) {
            const auto at = [](int i) {
                return Block * (static_cast<float>(i) - 0.5F * static_cast<float>(Blocks - 1));
            };
            const auto mesh =
                static_cast<std::size_t>(random.below(static_cast<int>(meshes.size())));
            const auto tone =
                static_cast<std::size_t>(random.below(static_cast<int>(walls.size())));
            const float yaw = 90.0F * static_cast<float>(random.below(4));
            const float scale = random.between(0.8F, 1.15F);
            if (random.below(12) == 0) continue; // a square
            place(sceneManager, meshes[mesh], walls[tone],
                  {{at(column), 0.0F, at(row)}, yaw, scale});
        }
    }
}

} // namespace

SampleScene cityScene() {
    SampleScene scene;
    scene.name = "city";
    scene.title = "City: some 400 houses from the air";
    scene.build = buildCity;
    Random random(5005);
    addViews(scene.views,
             {.name = "from-the-air",
              .eyes = {-350.0F, 180.0F, -350.0F, 350.0F, 450.0F, 350.0F},
              .targets = {-200.0F, 0.0F, -200.0F, 200.0F, 0.0F, 200.0F},
              .leastDistance = 250.0F,
              .fovYLow = 30.0F,
              .fovYHigh = 60.0F,
              .nearDistance = 5.0F,
              .farDistance = 2500.0F},
             6, random);
    addViews(scene.views,
             {.name = "from-a-tower",
              .eyes = {-300.0F, 85.0F, -300.0F, 300.0F, 110.0F, 300.0F},
              .targets = {-200.0F, 0.0F, -200.0F, 200.0F, 0.0F, 200.0F},
              .leastDistance = 120.0F,
              .nearDistance = 1.0F,
              .farDistance = 2500.0F},
             2, random);
    scene.lights = sunsBySeed(random);
    scene.shadowDistance = 1200.0F;
    scene.bySeed = true;
    return scene;
}

} // namespace Lixel::Samples

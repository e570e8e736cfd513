#include "common/SceneList.h"
#include "common/ScenePieces.h"
#include "common/ViewsBySeed.h"

namespace Lixel::Samples {
namespace {

using Ogre::ColourValue;
using Ogre::Vector3;

const std::string VastPath = "Lixel/Samples/vast/";
constexpr float HalfPlain = 50000.0F;

void buildVast(Ogre::SceneManager& sceneManager) {
    // A plane, as OGRE's own meshes of that name: open, and a caster unless told otherwise.
    MeshBuilder ground;
    ground.ground(HalfPlain, 64);
    place(sceneManager, ground.build(VastPath + "ground"),
          makeSurface(VastPath + "salt", ColourValue(0.74F, 0.72F, 0.66F)));
    const auto white = makeSurface(VastPath + "white", ColourValue(0.84F, 0.83F, 0.80F));
    const auto red = makeSurface(VastPath + "red", ColourValue(0.76F, 0.38F, 0.30F));
    MeshBuilder hangar;
    const std::vector<Ogre::Vector2> outline{{12.0F, 0.0F}, {12.0F, 5.0F},  {7.0F, 9.5F},
                                             {-7.0F, 9.5F}, {-12.0F, 5.0F}, {-12.0F, 0.0F}};
    hangar.prism(outline, -20.0F, 20.0F);
    MeshBuilder tank;
    tank.cylinder(5.0F, 0.0F, 9.0F, 28);
    tank.cone(5.2F, 9.0F, 10.5F, 28);
    MeshBuilder mast;
    mast.cylinder(0.4F, 0.0F, 45.0F, 12);
    for (int i = 1; i < 5; ++i)
        mast.boxOn({0.0F, 9.0F * static_cast<float>(i), 0.0F}, 5.0F, 0.4F, 0.4F);
    MeshBuilder truck;
    truck.boxOn({0.0F, 0.8F, 0.0F}, 2.5F, 2.6F, 7.0F);
    truck.boxOn({0.0F, 0.5F, -4.8F}, 2.4F, 2.2F, 2.0F);
    for (const float x : {-1.1F, 1.1F})
        for (const float z : {-4.6F, -2.0F, 2.4F})
            truck.boxOn({x, 0.0F, z}, 0.35F, 0.9F, 0.9F);
    const std::vector<Ogre::MeshPtr> meshes{
        hangar.build(VastPath + "hangar"), tank.build(VastPath + "tank"),
        mast.build(VastPath + "mast"), truck.build(VastPath + "truck")};
    Random random(808);
    for (int i = 0; i < 48; ++i) {
        const auto kind = static_cast<std::size_t>(random.below(static_cast<int>(meshes.size())));
        // Two thirds within sight, the others in the distance and larger.
        const float reach = i % 3 == 2 ? 5000.0F : 150.0F;
        const float x = random.between(-reach, reach);
        const float z = random.between(-reach, reach);
        const float yaw = random.between(0.0F, 360.0F);
        place(sceneManager, meshes[kind], i % 2 == 0 ? white : red,
              {{x, 0.0F, z}, yaw, i % 3 == 2 ? 6.0F : 1.0F});
    }
}

} // namespace

SampleScene vastScene() {
    SampleScene scene;
    scene.name = "vast";
    scene.title = "Vast: a plane of 100 000 units, few things on it, and no shadow distance";
    scene.build = buildVast;
    Random random(8008);
    addViews(scene.views,
             {.name = "on-the-ground",
              .eyes = {-180.0F, 1.6F, -180.0F, 180.0F, 6.0F, 180.0F},
              .targets = {-120.0F, 0.0F, -120.0F, 120.0F, 2.0F, 120.0F},
              .leastDistance = 40.0F,
              .nearDistance = 0.5F,
              .farDistance = 100000.0F},
             4, random);
    addViews(scene.views,
             {.name = "from-the-air",
              .eyes = {-300.0F, 60.0F, -300.0F, 300.0F, 200.0F, 300.0F},
              .targets = {-100.0F, 0.0F, -100.0F, 100.0F, 0.0F, 100.0F},
              .leastDistance = 120.0F,
              .nearDistance = 1.0F,
              .farDistance = 100000.0F},
             4, random);
    scene.lights = sunsBySeed(random);
    scene.shadowDistance = 0.0F;
    scene.bySeed = true;
    return scene;
}

} // namespace Lixel::Samples

#include "common/SceneList.h"
#include "common/ScenePieces.h"
#include "common/ViewsBySeed.h"

namespace Lixel::Samples {
namespace {

using Ogre::ColourValue;
using Ogre::Vector3;

const std::string WeaponPath = "Lixel/Samples/weapon/";
constexpr std::uint32_t WeaponViewSeed = 6006;

std::vector<SampleView> weaponViews(Random& random) {
    std::vector<SampleView> views;
    addViews(views,
             {.name = "aiming",
              .eyes = {-70.0F, 1.65F, -70.0F, 70.0F, 1.75F, 70.0F},
              .targets = {-70.0F, 1.0F, -70.0F, 70.0F, 2.0F, 70.0F},
              .leastDistance = 25.0F,
              .fovYLow = 50.0F,
              .fovYHigh = 70.0F,
              .nearDistance = 0.05F,
              .farDistance = 800.0F},
             8, random);
    return views;
}

/// About the viewer's eye, who looks along -z; metres.
Ogre::MeshPtr makeWeapon(const std::string& name) {
    MeshBuilder mesh;
    const Vector3 grip(0.14F, -0.15F, -0.38F);
    const Ogre::Quaternion forward(Ogre::Degree(-90.0F), Vector3::UNIT_X); // of +y
    mesh.transform = Ogre::Affine3(grip, forward);
    mesh.cylinder(0.013F, 0.1F, 0.62F, 14);
    mesh.cylinder(0.02F, 0.56F, 0.62F, 14);
    mesh.transform.setTrans(grip + Vector3(0.0F, 0.075F, 0.0F));
    mesh.cylinder(0.021F, -0.04F, 0.16F, 16);
    mesh.transform = Ogre::Affine3::IDENTITY;
    mesh.transform.setTrans(grip);
    mesh.box({-0.025F, -0.035F, -0.3F}, {0.025F, 0.035F, 0.12F});
    mesh.box({-0.008F, 0.035F, -0.06F}, {0.008F, 0.06F, -0.03F});
    mesh.box({-0.008F, 0.035F, 0.0F}, {0.008F, 0.06F, 0.03F});
    mesh.box({-0.018F, -0.16F, -0.12F}, {0.018F, -0.035F, -0.06F});
    mesh.box({-0.018F, -0.13F, 0.06F}, {0.018F, -0.035F, 0.1F});
    mesh.box({-0.006F, 0.035F, -0.29F}, {0.006F, 0.065F, -0.28F});
    return mesh.build(name);
}

void buildWeapon(Ogre::SceneManager& sceneManager) {
    MeshBuilder ground;
    ground.box({-300.0F, -4.0F, -300.0F}, {300.0F, 0.0F, 300.0F});
    place(sceneManager, ground.build(WeaponPath + "ground"),
          makeSurface(WeaponPath + "sand", ColourValue(0.74F, 0.68F, 0.55F),
                      patternTexture(Pattern::Grain)));
    const auto concrete = makeSurface(WeaponPath + "concrete", ColourValue(0.68F, 0.67F, 0.64F));
    const auto rust = makeSurface(WeaponPath + "rust", ColourValue(0.66F, 0.42F, 0.32F));
    const auto green = makeSurface(WeaponPath + "green", ColourValue(0.44F, 0.50F, 0.38F));
    MeshBuilder crate;
    crate.boxOn(Vector3::ZERO, 1.2F, 1.1F, 1.2F);
    MeshBuilder container;
    container.boxOn(Vector3::ZERO, 6.1F, 2.6F, 2.4F);
    MeshBuilder barrier;
    barrier.box({-1.5F, 0.0F, -0.3F}, {1.5F, 0.25F, 0.3F});
    barrier.box({-1.5F, 0.25F, -0.12F}, {1.5F, 0.9F, 0.12F});
    MeshBuilder tower;
    tower.boxOn({0.0F, 8.0F, 0.0F}, 3.0F, 2.4F, 3.0F);
    for (const float x : {-1.2F, 1.2F})
        for (const float z : {-1.2F, 1.2F})
            tower.boxOn({x, 0.0F, z}, 0.22F, 8.0F, 0.22F);
    MeshBuilder barrel;
    barrel.cylinder(0.3F, 0.0F, 0.9F, 16);
    const std::vector<std::pair<Ogre::MeshPtr, Ogre::MaterialPtr>> kinds{
        {crate.build(WeaponPath + "crate"), green},
        {container.build(WeaponPath + "container"), rust},
        {barrier.build(WeaponPath + "barrier"), concrete},
        {tower.build(WeaponPath + "tower"), green},
        {barrel.build(WeaponPath + "barrel"), rust}};
    Random random(606);
    for (int i = 0; i < 420; ++i) {
        const auto& [mesh, material] =
            kinds[static_cast<std::size_t>(random.below(static_cast<int>(kinds.size())))];
        const float x = random.between(-110.0F, 110.0F);
        const float z = random.between(-110.0F, 110.0F);
        place(sceneManager, mesh, material, {{x, 0.0F, z}, random.between(0.0F, 360.0F), 1.0F});
    }

    // Before each viewer; from elsewhere they are far away and small.
    const auto steel = makeSurface(WeaponPath + "steel", ColourValue(0.46F, 0.47F, 0.50F));
    const Ogre::MeshPtr weapon = makeWeapon(WeaponPath + "weapon");
    Random viewers(WeaponViewSeed);
    for (const SampleView& view : weaponViews(viewers))
        place(sceneManager, weapon, steel, {view.position, headingOf(view).valueDegrees(), 1.0F});
}

} // namespace

SampleScene weaponScene() {
    SampleScene scene;
    scene.name = "weapon";
    scene.title = "Weapon: right before the camera, in a yard that goes on for hundreds of metres";
    scene.build = buildWeapon;
    Random random(WeaponViewSeed);
    scene.views = weaponViews(random);
    scene.lights = sunsBySeed(random);
    scene.shadowDistance = 250.0F;
    scene.bySeed = true;
    return scene;
}

} // namespace Lixel::Samples

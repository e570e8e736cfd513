#include "common/SceneList.h"
#include "common/ScenePieces.h"

namespace Lixel::Samples {
namespace {

using Ogre::ColourValue;
using Ogre::Vector3;

const std::string DuelPath = "Lixel/Samples/duel/";

/// A row of columns that carry a beam, along x.
Ogre::MeshPtr colonnade(int columns, float spacing) {
    MeshBuilder mesh;
    const float half = 0.5F * spacing * static_cast<float>(columns - 1);
    for (int i = 0; i < columns; ++i) {
        mesh.transform.setTrans(Vector3(static_cast<float>(i) * spacing - half, 0.3F, 0.0F));
        addColumn(mesh, 0.5F, 6.5F);
    }
    mesh.transform = Ogre::Affine3::IDENTITY;
    mesh.boxOn(Vector3::ZERO, 2.0F * half + 2.4F, 0.3F, 2.4F);
    mesh.boxOn({0.0F, 6.8F, 0.0F}, 2.0F * half + 1.8F, 0.8F, 1.3F);
    mesh.boxOn({0.0F, 7.6F, 0.0F}, 2.0F * half + 2.3F, 0.25F, 1.8F);
    return mesh.build(DuelPath + "colonnade");
}

void plantTrees(Ogre::SceneManager& sceneManager) {
    const auto bark = makeSurface(DuelPath + "bark", ColourValue(0.42F, 0.34F, 0.27F));
    const auto needles = makeSurface(DuelPath + "needles", ColourValue(0.33F, 0.46F, 0.36F));
    const auto leaves = makeSurface(DuelPath + "leaves", ColourValue(0.55F, 0.60F, 0.33F));
    const TwoMeshes conifer = spruce(DuelPath + "spruce", 11.0F);
    const TwoMeshes broad = broadleaf(DuelPath + "broadleaf", 9.0F, 3);
    Random random(11);
    for (int i = 0; i < 15; ++i) {
        Placement placement;
        placement.position = {12.0F * static_cast<float>(i - 7) + random.between(-3.0F, 3.0F), 0.0F,
                              -34.0F + random.between(-6.0F, 6.0F)};
        placement.yawDegrees = random.between(0.0F, 360.0F);
        placement.scale = random.between(0.8F, 1.3F);
        place(sceneManager, i % 3 == 1 ? broad : conifer, bark, i % 3 == 1 ? leaves : needles,
              placement);
    }
    place(sceneManager, broad, bark, leaves, {{-13.0F, 0.0F, 12.0F}, 40.0F, 1.0F});
    place(sceneManager, conifer, bark, needles, {{17.0F, 0.0F, 8.0F}, 0.0F, 0.9F});
}

void buildDuel(Ogre::SceneManager& sceneManager) {
    placeGround(sceneManager, DuelPath + "ground", 150.0F,
                makeSurface(DuelPath + "ground", ColourValue(0.66F, 0.66F, 0.52F),
                            patternTexture(Pattern::Grain)));
    const auto stone = makeSurface(DuelPath + "stone", ColourValue(0.82F, 0.78F, 0.69F));
    const auto wood = makeSurface(DuelPath + "wood", ColourValue(0.55F, 0.41F, 0.29F));
    const auto clay = makeSurface(DuelPath + "clay", ColourValue(0.76F, 0.45F, 0.34F));
    MeshBuilder fence;
    addFence(fence, 40.0F);
    place(sceneManager, fence.build(DuelPath + "fence"), wood, {{0.0F, 0.0F, 22.0F}, 0.0F, 1.0F});
    place(sceneManager, colonnade(11, 4.5F), stone, {{0.0F, 0.0F, -9.0F}, 0.0F, 1.0F});
    plantTrees(sceneManager);

    MeshBuilder jar;
    jar.lathe(std::vector<ProfilePoint>{{0.0F, 0.0F},
                                        {0.35F, 0.0F},
                                        {0.42F, 0.1F},
                                        {0.8F, 0.75F, true},
                                        {0.7F, 1.3F, true},
                                        {0.35F, 1.6F},
                                        {0.5F, 1.8F},
                                        {0.0F, 1.8F}},
              28);
    const Ogre::MeshPtr jarMesh = jar.build(DuelPath + "jar");
    for (int i = 0; i < 6; ++i)
        place(
            sceneManager, jarMesh, clay,
            {{6.0F * static_cast<float>(i) - 17.0F, 0.0F, 6.0F - 2.0F * static_cast<float>(i % 2)},
             0.0F,
             1.0F});
}

} // namespace

SampleScene duelScene() {
    SampleScene scene;
    scene.name = "duel";
    scene.title = "Duel: looking into a low sun, with trees, columns and a fence in between";
    scene.build = buildDuel;
    scene.views = {
        {"into-the-sun", {0.5F, 1.9F, 31.0F}, {0.0F, 1.2F, 0.0F}, 0.5F, 300.0F, 50.0F, {}},
        {"from-a-hill", {-22.0F, 16.0F, 52.0F}, {0.0F, 0.0F, -8.0F}, 0.5F, 300.0F, 45.0F, {}},
        {"behind-the-fence", {6.0F, 0.9F, 25.5F}, {1.0F, 1.2F, 0.0F}, 0.2F, 300.0F, 60.0F, {}},
        {"among-the-columns", {6.5F, 1.7F, -6.5F}, {-8.0F, 1.5F, -16.0F}, 0.2F, 300.0F, 65.0F, {}},
        {"from-a-tower", {34.0F, 36.0F, 30.0F}, {4.0F, 0.0F, -6.0F}, 1.0F, 300.0F, 40.0F, {}},
        {"at-a-jar", {-13.2F, 0.9F, 9.4F}, {-10.4F, 0.4F, 3.4F}, 0.1F, 300.0F, 60.0F, {}},
    };
    scene.lights = {sunlight("straight-against", 180.0F, 15.0F),
                    sunlight("nearly-against", 168.0F, 9.0F),
                    sunlight("high-against", 186.0F, 38.0F),
                    sunlight("from-the-side", 95.0F, 22.0F), sunlight("from-behind", 4.0F, 25.0F)};
    scene.shadowDistance = 160.0F;
    return scene;
}

} // namespace Lixel::Samples

#include "common/SceneList.h"
#include "common/ScenePieces.h"
#include "common/ViewsBySeed.h"

#include <array>
#include <cmath>

namespace Lixel::Samples {
namespace {

using Ogre::ColourValue;
using Ogre::Vector3;

const std::string CarParkPath = "Lixel/Samples/telephoto/";

Ogre::MeshPtr makeCar(const std::string& name) {
    MeshBuilder mesh;
    const std::array body{Ogre::Vector2(-2.1F, 0.3F), Ogre::Vector2(2.1F, 0.3F),
                          Ogre::Vector2(2.0F, 0.8F), Ogre::Vector2(1.0F, 0.95F),
                          Ogre::Vector2(-2.0F, 0.95F)};
    mesh.prism(body, -0.85F, 0.85F);
    const std::array cabin{Ogre::Vector2(-1.9F, 0.95F), Ogre::Vector2(1.0F, 0.95F),
                           Ogre::Vector2(0.4F, 1.42F), Ogre::Vector2(-1.2F, 1.42F)};
    mesh.prism(cabin, -0.75F, 0.75F);
    const Ogre::Quaternion aside(Ogre::Degree(90.0F), Vector3::UNIT_X);
    for (const float x : {-1.3F, 1.3F})
        for (const float z : {-0.87F, 0.65F}) {
            mesh.transform = Ogre::Affine3(Vector3(x, 0.31F, z), aside);
            mesh.cylinder(0.31F, 0.0F, 0.22F, 14);
        }
    return mesh.build(name);
}

void buildCarPark(Ogre::SceneManager& sceneManager) {
    MeshBuilder ground;
    ground.box({-250.0F, -4.0F, -250.0F}, {250.0F, 0.0F, 250.0F});
    place(sceneManager, ground.build(CarParkPath + "ground"),
          makeSurface(CarParkPath + "asphalt", ColourValue(0.58F, 0.58F, 0.58F),
                      patternTexture(Pattern::Grain)));
    const std::array tones{ColourValue(0.78F, 0.77F, 0.75F), ColourValue(0.66F, 0.28F, 0.25F),
                           ColourValue(0.30F, 0.40F, 0.56F), ColourValue(0.34F, 0.35F, 0.36F)};
    std::vector<Ogre::MaterialPtr> paints;
    for (const ColourValue& tone : tones)
        paints.push_back(makeSurface(CarParkPath + "paint" + std::to_string(paints.size()), tone));
    const auto iron = makeSurface(CarParkPath + "iron", ColourValue(0.42F, 0.44F, 0.45F));
    const auto bark = makeSurface(CarParkPath + "bark", ColourValue(0.43F, 0.35F, 0.28F));
    const auto leaves = makeSurface(CarParkPath + "leaves", ColourValue(0.46F, 0.57F, 0.34F));
    const Ogre::MeshPtr car = makeCar(CarParkPath + "car");
    MeshBuilder mast;
    mast.cylinder(0.1F, 0.0F, 8.0F, 10);
    mast.boxOn({0.0F, 8.0F, 0.0F}, 2.4F, 0.15F, 0.3F);
    const Ogre::MeshPtr mastMesh = mast.build(CarParkPath + "mast");
    const TwoMeshes tree = broadleaf(CarParkPath + "tree", 6.0F, 31);
    Random random(910);
    for (int row = -7; row <= 7; ++row) {
        for (int bay = -24; bay <= 24; ++bay) {
            const Vector3 at(2.8F * static_cast<float>(bay), 0.0F, 11.0F * static_cast<float>(row));
            if (bay % 8 == 0) {
                if (row % 2 == 0)
                    place(sceneManager, mastMesh, iron, {at, 0.0F, 1.0F});
                else
                    place(sceneManager, tree, bark, leaves,
                          {at, random.between(0.0F, 360.0F), random.between(0.7F, 1.1F)});
                continue;
            }
            const int paint = random.below(static_cast<int>(paints.size()));
            if (random.below(3) == 0) continue; // free
            place(sceneManager, car, paints[static_cast<std::size_t>(paint)],
                  {at + Vector3(0.0F, 0.0F, random.between(-0.4F, 0.4F)),
                   (random.below(2) == 0 ? 90.0F : -90.0F) + random.between(-3.0F, 3.0F),
                   random.between(0.9F, 1.1F)});
        }
    }
}

} // namespace

SampleScene telephotoScene() {
    SampleScene scene;
    scene.name = "telephoto";
    scene.title = "Telephoto: a car park steeply from above, in a narrow field of view";
    scene.build = buildCarPark;
    Random random(9109);
    for (int i = 1; i <= 8; ++i) {
        SampleView view;
        view.name = "through-a-lens-" + std::to_string(i);
        view.target = pointIn({-40.0F, 0.0F, -50.0F, 40.0F, 0.0F, 50.0F}, random);
        const float azimuth = Ogre::Degree(random.between(0.0F, 360.0F)).valueRadians();
        const float elevation = Ogre::Degree(random.between(32.0F, 75.0F)).valueRadians();
        const float distance = random.between(900.0F, 2200.0F);
        view.position = view.target + distance * Vector3(std::cos(elevation) * std::sin(azimuth),
                                                         std::sin(elevation),
                                                         std::cos(elevation) * std::cos(azimuth));
        view.fovYDegrees = random.between(1.2F, 4.0F);
        view.nearDistance = 50.0F;
        view.farDistance = 5000.0F;
        scene.views.push_back(view);
    }
    scene.lights = sunsBySeed(random);
    scene.shadowDistance = 4000.0F;
    scene.bySeed = true;
    return scene;
}

} // namespace Lixel::Samples

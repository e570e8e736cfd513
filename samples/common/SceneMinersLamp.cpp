#include "common/SceneList.h"
#include "common/ScenePieces.h"

namespace Lixel::Samples {
namespace {

using Ogre::ColourValue;
using Ogre::Vector3;

const std::string LampPath = "Lixel/Samples/miners-lamp/";

// The hall, in metres: x across, z along.
constexpr float HalfWidth = 12.0F;
constexpr int Bays = 10;
constexpr float Bay = 8.0F; ///< from pillar to pillar
constexpr float HalfLength = 0.5F * Bay * Bays;
constexpr float Height = 8.0F;
constexpr float Wall = 1.0F;  ///< thickness of walls and ceiling
constexpr float Aisle = 4.6F; ///< from the middle to a row of pillars

/** A lamp at a viewer's temple, pointing where the viewer looks.

    It stands 0.25 m to the right and 0.15 m above the eye.
*/
SampleLight headLamp(const Vector3& eye, const Vector3& target, float outerDegrees) {
    const Vector3 along = (target - eye).normalisedCopy();
    const Vector3 right = along.crossProduct(Vector3::UNIT_Y).normalisedCopy();
    SampleLight lamp;
    lamp.name = "lamp";
    lamp.kind = SampleLight::Kind::Spot;
    lamp.position = eye + 0.25F * right + 0.15F * Vector3::UNIT_Y;
    lamp.direction = along;
    lamp.innerDegrees = 0.7F * outerDegrees;
    lamp.outerDegrees = outerDegrees;
    lamp.range = 120.0F;
    lamp.colour = ColourValue(1.0F, 0.93F, 0.8F);
    return lamp;
}

SampleView lampView(const std::string& name, const Vector3& eye, const Vector3& target,
                    float outerDegrees) {
    return {name, eye, target, 0.1F, 120.0F, 60.0F, headLamp(eye, target, outerDegrees)};
}

void buildShell(Ogre::SceneManager& sceneManager) {
    const auto rock = makeSurface(LampPath + "rock", ColourValue(0.66F, 0.62F, 0.56F),
                                  patternTexture(Pattern::Grain));
    MeshBuilder floor;
    floor.box({-HalfWidth, -Wall, -HalfLength}, {HalfWidth, 0.0F, HalfLength});
    place(sceneManager, floor.build(LampPath + "floor"),
          makeSurface(LampPath + "floor", ColourValue(0.64F, 0.59F, 0.52F),
                      patternTexture(Pattern::Paving)))
        ->setCastShadows(false);

    MeshBuilder shell;
    const float outX = HalfWidth + Wall;
    const float outZ = HalfLength + Wall;
    shell.box({-outX, Height, -outZ}, {outX, Height + Wall, outZ});
    shell.box({-outX, -Wall, -outZ}, {-HalfWidth, Height, outZ});
    shell.box({HalfWidth, -Wall, -outZ}, {outX, Height, outZ});
    shell.box({-HalfWidth, -Wall, HalfLength}, {HalfWidth, Height, outZ});
    // The far wall has a gate to a short passage that ends in the dark.
    shell.box({-HalfWidth, -Wall, -outZ}, {-2.0F, Height, -HalfLength});
    shell.box({2.0F, -Wall, -outZ}, {HalfWidth, Height, -HalfLength});
    shell.box({-2.0F, 4.0F, -outZ}, {2.0F, Height, -HalfLength});
    shell.box({-2.0F, -Wall, -outZ - 1.0F}, {2.0F, 4.0F, -outZ});
    place(sceneManager, shell.build(LampPath + "shell"), rock);
}

void buildPillars(Ogre::SceneManager& sceneManager) {
    const auto stone = makeSurface(LampPath + "stone", ColourValue(0.78F, 0.72F, 0.62F));
    MeshBuilder pillar;
    addColumn(pillar, 0.62F, Height);
    const Ogre::MeshPtr pillarMesh = pillar.build(LampPath + "pillar");
    MeshBuilder rib;
    rib.arch(2.0F * Aisle - 1.6F, 3.1F, 0.5F, 0.7F, 24);
    const Ogre::MeshPtr ribMesh = rib.build(LampPath + "rib");
    for (int i = 0; i < Bays; ++i) {
        const float z = (static_cast<float>(i) + 0.5F) * Bay - HalfLength;
        place(sceneManager, pillarMesh, stone, {{-Aisle, 0.0F, z}, 0.0F, 1.0F});
        place(sceneManager, pillarMesh, stone, {{Aisle, 0.0F, z}, 0.0F, 1.0F});
        place(sceneManager, ribMesh, stone, {{0.0F, 0.0F, z}, 0.0F, 1.0F});
    }
}

void buildFurniture(Ogre::SceneManager& sceneManager) {
    const auto wood = makeSurface(LampPath + "wood", ColourValue(0.60F, 0.44F, 0.30F));
    const auto iron = makeSurface(LampPath + "iron", ColourValue(0.40F, 0.43F, 0.46F));
    const auto boulderColour = makeSurface(LampPath + "boulder", ColourValue(0.60F, 0.57F, 0.53F));
    MeshBuilder crate;
    crate.boxOn(Vector3::ZERO, 1.1F, 1.1F, 1.1F);
    const Ogre::MeshPtr crateMesh = crate.build(LampPath + "crate");
    MeshBuilder barrel;
    barrel.lathe(std::vector<ProfilePoint>{{0.0F, 0.0F},
                                           {0.36F, 0.0F},
                                           {0.46F, 0.3F, true},
                                           {0.48F, 0.55F, true},
                                           {0.46F, 0.8F, true},
                                           {0.36F, 1.1F},
                                           {0.0F, 1.1F}},
                 24);
    const Ogre::MeshPtr barrelMesh = barrel.build(LampPath + "barrel");
    MeshBuilder boulder;
    boulder.sphere({0.0F, 0.35F, 0.0F}, 0.6F, 24);
    const Ogre::MeshPtr boulderMesh = boulder.build(LampPath + "boulder");

    Random random(5);
    for (int i = 0; i < 44; ++i) {
        const float side = i % 2 == 0 ? -1.0F : 1.0F;
        const Placement placement{{side * random.between(5.6F, 11.0F), 0.0F,
                                   random.between(-HalfLength + 2.0F, HalfLength - 12.0F)},
                                  random.between(0.0F, 90.0F),
                                  random.between(0.8F, 1.3F)};
        const int kind = random.below(3);
        place(sceneManager, kind == 0 ? crateMesh : (kind == 1 ? barrelMesh : boulderMesh),
              kind == 2 ? boulderColour : wood, placement);
    }
    place(sceneManager, crateMesh, wood, {{1.9F, 0.0F, 22.0F}, 25.0F, 1.0F});
    place(sceneManager, crateMesh, wood, {{1.8F, 1.1F, 22.0F}, 50.0F, 0.7F});
    place(sceneManager, barrelMesh, wood, {{-2.2F, 0.0F, 14.0F}, 0.0F, 1.0F});

    // Rails down the middle, low and thin.
    MeshBuilder rails;
    for (const float x : {-0.5F, 0.5F})
        rails.box({x - 0.04F, 0.08F, -HalfLength}, {x + 0.04F, 0.2F, HalfLength - 8.0F});
    constexpr float Sleepers = 1.25F; // apart
    for (int i = 0; i < static_cast<int>((2.0F * HalfLength - 8.0F) / Sleepers); ++i)
        rails.boxOn({0.0F, 0.0F, Sleepers * static_cast<float>(i) + 0.5F - HalfLength}, 1.7F, 0.08F,
                    0.24F);
    place(sceneManager, rails.build(LampPath + "rails"), iron);
}

void buildMinersLamp(Ogre::SceneManager& sceneManager) {
    buildShell(sceneManager);
    buildPillars(sceneManager);
    buildFurniture(sceneManager);
}

} // namespace

SampleScene minersLampScene() {
    SampleScene scene;
    scene.name = "miners-lamp";
    scene.title = "Miner's lamp: a pillared hall lit only by a lamp beside the viewer's head";
    scene.build = buildMinersLamp;
    scene.views = {
        lampView("down-the-nave", {0.3F, 1.7F, 37.0F}, {0.0F, 1.9F, -20.0F}, 75.0F),
        lampView("along-the-aisle", {-8.4F, 1.7F, 34.0F}, {-5.0F, 1.2F, 0.0F}, 75.0F),
        lampView("across", {-9.5F, 2.1F, 9.5F}, {8.0F, 0.8F, -6.0F}, 90.0F),
        lampView("at-the-floor", {0.8F, 4.5F, 27.0F}, {0.0F, 0.0F, 17.0F}, 60.0F),
        lampView("at-a-pillar", {-3.4F, 1.6F, 14.6F}, {-5.4F, 1.1F, 8.0F}, 80.0F),
        lampView("from-under-the-roof", {5.5F, 6.8F, 34.0F}, {-1.0F, 0.5F, 4.0F}, 75.0F),
    };
    // The lamp on the head, and others': beside the viewer, coming towards him, under the roof.
    const auto lamp = [](const std::string& name, const Vector3& position, const Vector3& target,
                         float outerDegrees) {
        SampleLight light = headLamp(position, target, outerDegrees);
        light.name = name;
        light.position = position;
        return light;
    };
    scene.lights = {*scene.views.front().light,
                    lamp("companion", {-5.0F, 1.6F, 33.0F}, {2.0F, 1.0F, 10.0F}, 75.0F),
                    lamp("oncoming", {1.5F, 2.2F, -6.0F}, {0.0F, 1.0F, 30.0F}, 80.0F),
                    lamp("under-the-roof", {0.0F, 7.2F, 18.0F}, {0.5F, 0.0F, 14.0F}, 120.0F)};
    scene.shadowDistance = 100.0F;
    scene.sky = {ColourValue(0.12F, 0.12F, 0.14F), ColourValue(0.02F, 0.02F, 0.03F)};
    return scene;
}

} // namespace Lixel::Samples

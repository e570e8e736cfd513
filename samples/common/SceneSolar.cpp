#include "common/SceneList.h"
#include "common/ScenePieces.h"
#include "common/ViewsBySeed.h"

#include <array>

namespace Lixel::Samples {
namespace {

using Ogre::ColourValue;
using Ogre::Vector3;

const std::string SolarPath = "Lixel/Samples/solar/";

/// Panels side by side along x on one slope that faces +z, in metres.
constexpr float TableLength = 11.0F;
constexpr float TableSlope = 3.4F;
constexpr float TableTilt = 30.0F; ///< degrees
constexpr float TableLow = 0.8F;   ///< height of the lower edge

Ogre::MeshPtr makePanels(const std::string& name) {
    MeshBuilder mesh;
    const Ogre::Quaternion tilt(Ogre::Degree(TableTilt), Vector3::UNIT_X);
    const float middle = TableLow + 0.5F * TableSlope * 0.5F; // sin 30 degrees
    mesh.transform = Ogre::Affine3(Vector3(0.0F, middle, 0.0F), tilt);
    constexpr int Panels = 10;
    constexpr float Pitch = TableLength / Panels;
    for (int i = 0; i < Panels; ++i) {
        const float x = (static_cast<float>(i) + 0.5F) * Pitch - 0.5F * TableLength;
        for (const float half : {-0.25F, 0.25F})
            mesh.boxOn({x, 0.0F, half * TableSlope}, Pitch - 0.03F, 0.05F,
                       0.5F * TableSlope - 0.03F);
    }
    return mesh.build(name);
}

Ogre::MeshPtr makeFrame(const std::string& name) {
    MeshBuilder mesh;
    for (const float x : {-4.5F, -1.5F, 1.5F, 4.5F}) {
        mesh.boxOn({x, -0.3F, 0.9F}, 0.1F, TableLow + 0.55F, 0.1F);
        mesh.boxOn({x, -0.3F, -0.9F}, 0.1F, TableLow + 1.55F, 0.1F);
    }
    return mesh.build(name);
}

void buildSolar(Ogre::SceneManager& sceneManager) {
    MeshBuilder ground;
    ground.box({-140.0F, -3.0F, -140.0F}, {140.0F, 0.0F, 140.0F});
    place(sceneManager, ground.build(SolarPath + "ground"),
          makeSurface(SolarPath + "ground", ColourValue(0.66F, 0.63F, 0.50F),
                      patternTexture(Pattern::Grain)));
    const auto silicon = makeSurface(SolarPath + "silicon", ColourValue(0.30F, 0.36F, 0.52F));
    const auto steel = makeSurface(SolarPath + "steel", ColourValue(0.70F, 0.71F, 0.72F));
    const Ogre::MeshPtr panels = makePanels(SolarPath + "panels");
    const Ogre::MeshPtr frame = makeFrame(SolarPath + "frame");
    MeshBuilder cabinet;
    cabinet.boxOn(Vector3::ZERO, 1.2F, 2.0F, 0.8F);
    const Ogre::MeshPtr cabinetMesh = cabinet.build(SolarPath + "cabinet");
    for (int row = -8; row <= 8; ++row) {
        for (int column = -4; column <= 4; ++column) {
            if (column == 0) continue; // the way between both halves
            const Placement at{
                {12.0F * static_cast<float>(column), 0.0F, 6.5F * static_cast<float>(row)},
                0.0F,
                1.0F};
            place(sceneManager, panels, silicon, at);
            place(sceneManager, frame, steel, at);
        }
        if (row % 4 == 0)
            place(sceneManager, cabinetMesh, steel,
                  {{3.5F, 0.0F, 6.5F * static_cast<float>(row)}, 90.0F, 1.0F});
    }
}

} // namespace

SampleScene solarScene() {
    SampleScene scene;
    scene.name = "solar";
    scene.title = "Solar: rows of tilted panels";
    scene.build = buildSolar;
    Random random(9009);
    addViews(scene.views,
             {.name = "walking",
              .eyes = {-5.0F, 1.6F, -50.0F, 5.0F, 1.9F, 50.0F},
              .targets = {-40.0F, 0.0F, -50.0F, 40.0F, 1.5F, 50.0F},
              .leastDistance = 10.0F,
              .farDistance = 350.0F},
             4, random);
    addViews(scene.views,
             {.name = "from-a-drone",
              .eyes = {-60.0F, 8.0F, -70.0F, 60.0F, 35.0F, 70.0F},
              .targets = {-35.0F, 0.0F, -40.0F, 35.0F, 0.0F, 40.0F},
              .leastDistance = 25.0F,
              .nearDistance = 0.5F,
              .farDistance = 400.0F},
             4, random);
    scene.lights = sunsBySeed(random);
    scene.shadowDistance = 180.0F;
    scene.bySeed = true;
    return scene;
}

} // namespace Lixel::Samples

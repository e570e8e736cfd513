#include "common/SceneList.h"
#include "common/ScenePieces.h"
#include "common/ViewsBySeed.h"

#include <algorithm>
#include <cmath>

namespace Lixel::Samples {
namespace {

using Ogre::ColourValue;
using Ogre::Vector3;

const std::string BridgePath = "Lixel/Samples/bridge/";

// Metres. The deck runs along x, the valley along z.
constexpr float DeckTop = 15.0F;
constexpr float DeckThickness = 1.0F;
constexpr float HalfDeck = 54.0F; ///< its length
constexpr float DeckWidth = 8.0F;
constexpr float PierPitch = 18.0F;

/// The valley is 14 deep, its slopes wind.
float valleyHeight(float x, float z) {
    const float middle = 5.0F * std::sin(0.04F * z);
    const float t = std::clamp((std::abs(x - middle) - 7.0F) / 40.0F, 0.0F, 1.0F);
    return 14.3F * t * t * (3.0F - 2.0F * t) + 0.4F * std::sin(0.17F * x) * std::cos(0.13F * z);
}

void buildDeck(Ogre::SceneManager& sceneManager) {
    const auto stone = makeSurface(BridgePath + "stone", ColourValue(0.74F, 0.69F, 0.60F),
                                   patternTexture(Pattern::Paving));
    const auto iron = makeSurface(BridgePath + "iron", ColourValue(0.36F, 0.40F, 0.42F));
    MeshBuilder deck;
    deck.box({-HalfDeck, DeckTop - DeckThickness, -0.5F * DeckWidth},
             {HalfDeck, DeckTop, 0.5F * DeckWidth});
    place(sceneManager, deck.build(BridgePath + "deck"), stone);

    // Arches whose crowns carry the deck, and thin posts from their flanks up to it.
    constexpr float Span = 15.0F;
    constexpr float Thickness = 1.5F;
    constexpr float Legs = 4.0F;
    constexpr float Base = DeckTop - DeckThickness - Thickness - 0.5F * Span - Legs;
    MeshBuilder arches;
    for (int i = -2; i <= 2; ++i) {
        arches.transform.setTrans(Vector3(PierPitch * static_cast<float>(i), Base, 0.0F));
        arches.arch(Span, Legs, Thickness, 6.0F, 24);
    }
    arches.transform = Ogre::Affine3::IDENTITY;
    for (int i = -3; i <= 2; ++i) {
        const float x = PierPitch * (static_cast<float>(i) + 0.5F);
        arches.box({x - 1.4F, -4.0F, -3.0F}, {x + 1.4F, Base + Legs, 3.0F});
        for (const float aside : {-3.5F, 0.0F, 3.5F}) {
            // From within an arch's flank, which is above the pier there.
            const float low = Base + Legs + (aside == 0.0F ? 0.0F : 6.0F);
            for (const float z : {-2.6F, 2.6F})
                arches.box({x + aside - 0.25F, low, z - 0.25F},
                           {x + aside + 0.25F, DeckTop - DeckThickness, z + 0.25F});
        }
    }
    place(sceneManager, arches.build(BridgePath + "arches"), stone);

    MeshBuilder railing;
    addFence(railing, HalfDeck);
    const Ogre::MeshPtr railingMesh = railing.build(BridgePath + "railing");
    MeshBuilder lamp;
    lamp.cylinder(0.09F, 0.0F, 5.0F, 10);
    lamp.boxOn({0.0F, 5.0F, 0.5F}, 0.25F, 0.15F, 1.4F);
    const Ogre::MeshPtr lampMesh = lamp.build(BridgePath + "lamp");
    for (const float side : {1.0F, -1.0F}) {
        const float z = side * (0.5F * DeckWidth - 0.2F);
        place(sceneManager, railingMesh, iron, {{0.0F, DeckTop, z}, 0.0F, 1.0F});
        for (int i = -3; i <= 3; ++i)
            place(sceneManager, lampMesh, iron,
                  {{14.0F * static_cast<float>(i) + 3.0F * side, DeckTop, z},
                   side > 0.0F ? 180.0F : 0.0F,
                   1.0F});
    }
}

void buildBridge(Ogre::SceneManager& sceneManager) {
    MeshBuilder ground;
    addTerrain(ground, valleyHeight, 110.0F, 88, -8.0F);
    place(sceneManager, ground.build(BridgePath + "ground"),
          makeSurface(BridgePath + "grass", ColourValue(0.58F, 0.61F, 0.44F),
                      patternTexture(Pattern::Grain)));
    buildDeck(sceneManager);

    const auto bark = makeSurface(BridgePath + "bark", ColourValue(0.43F, 0.35F, 0.28F));
    const auto needles = makeSurface(BridgePath + "needles", ColourValue(0.34F, 0.48F, 0.38F));
    const auto leaves = makeSurface(BridgePath + "leaves", ColourValue(0.54F, 0.59F, 0.33F));
    const TwoMeshes conifer = spruce(BridgePath + "spruce", 9.0F);
    const TwoMeshes broad = broadleaf(BridgePath + "broadleaf", 7.0F, 12);
    Random random(202);
    for (int i = 0; i < 110; ++i) {
        const float x = random.between(-95.0F, 95.0F);
        const float z = random.between(-95.0F, 95.0F);
        const float yaw = random.between(0.0F, 360.0F);
        const float scale = random.between(0.6F, 1.3F);
        if (std::abs(z) < 9.0F) continue; // the bridge and its road
        const bool isConifer = random.below(2) == 0;
        place(sceneManager, isConifer ? conifer : broad, bark, isConifer ? needles : leaves,
              {{x, valleyHeight(x, z) - 0.2F, z}, yaw, scale});
    }
}

} // namespace

SampleScene bridgeScene() {
    SampleScene scene;
    scene.name = "bridge";
    scene.title = "Bridge: arches over a wooded valley, seen from the deck, from below and afar";
    scene.build = buildBridge;
    Random random(2002);
    addViews(scene.views,
             {.name = "on-the-deck",
              .eyes = {-45.0F, DeckTop + 1.6F, -2.5F, 45.0F, DeckTop + 1.8F, 2.5F},
              .targets = {-45.0F, DeckTop, -2.0F, 45.0F, DeckTop + 0.5F, 2.0F},
              .leastDistance = 12.0F},
             2, random);
    addViews(scene.views,
             {.name = "in-the-valley",
              .eyes = {-14.0F, 1.6F, -50.0F, 14.0F, 1.8F, 50.0F},
              .targets = {-20.0F, 2.0F, -8.0F, 20.0F, 6.0F, 8.0F},
              .leastDistance = 14.0F},
             3, random, valleyHeight);
    addViews(scene.views,
             {.name = "from-a-slope",
              .eyes = {-80.0F, 3.0F, 30.0F, 80.0F, 14.0F, 80.0F},
              .targets = {-30.0F, 4.0F, -10.0F, 30.0F, 12.0F, 10.0F},
              .leastDistance = 30.0F,
              .nearDistance = 0.5F},
             3, random, valleyHeight);
    scene.lights = sunsBySeed(random);
    scene.shadowDistance = 220.0F;
    scene.bySeed = true;
    return scene;
}

} // namespace Lixel::Samples

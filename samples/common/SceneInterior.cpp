#include "common/RoomPieces.h"
#include "common/SceneList.h"
#include "common/ViewsBySeed.h"

namespace Lixel::Samples {
namespace {

const std::string InteriorPath = "Lixel/Samples/interior/";

const RoomShape Hall{.halfWidth = 9.0F,
                     .halfLength = 6.0F,
                     .height = 4.2F,
                     .wall = 0.35F,
                     .windowsWide = 6,
                     .windowsLong = 4};

void buildInterior(Ogre::SceneManager& sceneManager) {
    MeshBuilder ground;
    ground.box({-60.0F, -1.5F, -60.0F}, {60.0F, -Hall.wall, 60.0F});
    place(sceneManager, ground.build(InteriorPath + "ground"),
          makeSurface(InteriorPath + "ground", Ogre::ColourValue(0.60F, 0.64F, 0.50F),
                      patternTexture(Pattern::Grain)));
    placeRoom(sceneManager, InteriorPath, Hall);
    furnishRoom(sceneManager, InteriorPath, Hall, Random(303));
}

} // namespace

SampleScene interiorScene() {
    SampleScene scene;
    scene.name = "interior";
    scene.title = "Interior: the sun shines through windows onto floor and furniture";
    scene.build = buildInterior;
    Random random(3003);
    addViews(scene.views,
             {.name = "standing",
              .eyes = {-8.0F, 1.5F, -5.0F, 8.0F, 1.8F, 5.0F},
              .targets = {-8.0F, 0.0F, -5.0F, 8.0F, 1.0F, 5.0F},
              .leastDistance = 4.0F,
              .fovYLow = 55.0F,
              .fovYHigh = 75.0F,
              .nearDistance = 0.1F,
              .farDistance = 120.0F},
             6, random);
    addViews(scene.views,
             {.name = "from-under-the-ceiling",
              .eyes = {-8.0F, 3.2F, -5.0F, 8.0F, 3.9F, 5.0F},
              .targets = {-5.0F, 0.0F, -3.0F, 5.0F, 0.0F, 3.0F},
              .leastDistance = 5.0F,
              .fovYLow = 55.0F,
              .fovYHigh = 75.0F,
              .nearDistance = 0.1F,
              .farDistance = 120.0F},
             2, random);
    scene.lights = sunsBySeed(random);
    // A higher one would shine on window sills only.
    scene.lights.front() = sunlight("afternoon", random.between(0.0F, 360.0F), 32.0F);
    scene.shadowDistance = 60.0F;
    scene.bySeed = true;
    return scene;
}

} // namespace Lixel::Samples

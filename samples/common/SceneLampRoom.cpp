#include "common/RoomPieces.h"
#include "common/SceneList.h"
#include "common/ViewsBySeed.h"

namespace Lixel::Samples {
namespace {

using Ogre::Vector3;

const std::string RoomPath = "Lixel/Samples/lamp-room/";
const RoomShape Chamber{};

void buildLampRoom(Ogre::SceneManager& sceneManager) {
    placeRoom(sceneManager, RoomPath, Chamber);
    furnishRoom(sceneManager, RoomPath, Chamber, Random(707));
}

SampleLight roomLamp(const std::string& name, const Vector3& position) {
    SampleLight lamp;
    lamp.name = name;
    lamp.kind = SampleLight::Kind::Point;
    lamp.position = position;
    lamp.range = 40.0F;
    lamp.colour = Ogre::ColourValue(1.0F, 0.93F, 0.8F);
    return lamp;
}

SampleLight roomSpot(const std::string& name, const Vector3& position, const Vector3& target,
                     float outerDegrees) {
    SampleLight lamp = roomLamp(name, position);
    lamp.kind = SampleLight::Kind::Spot;
    lamp.direction = (target - position).normalisedCopy();
    lamp.innerDegrees = 0.8F * outerDegrees;
    lamp.outerDegrees = outerDegrees;
    return lamp;
}

} // namespace

SampleScene lampRoomScene() {
    SampleScene scene;
    scene.name = "lamp-room";
    scene.title = "Lamp in a room: a spot or a point light among furniture";
    scene.build = buildLampRoom;
    Random random(7008);
    addViews(scene.views,
             {.name = "standing",
              .eyes = {-5.5F, 1.5F, -4.0F, 5.5F, 1.8F, 4.0F},
              .targets = {-5.0F, 0.0F, -3.5F, 5.0F, 0.8F, 3.5F},
              .leastDistance = 3.5F,
              .fovYLow = 55.0F,
              .fovYHigh = 75.0F,
              .nearDistance = 0.1F,
              .farDistance = 60.0F},
             8, random);
    scene.lights = {roomSpot("ceiling", {0.4F, 3.3F, -0.3F}, {0.0F, 0.0F, 0.0F}, 140.0F),
                    roomSpot("corner", {5.7F, 3.0F, 4.2F}, {-1.0F, 0.0F, -0.5F}, 95.0F),
                    roomLamp("pendant", {0.3F, 2.5F, 0.2F}),
                    roomLamp("floor-lamp", {-5.2F, 1.7F, 3.8F})};
    scene.shadowDistance = 30.0F;
    scene.sky = {Ogre::ColourValue(0.14F, 0.14F, 0.16F), Ogre::ColourValue(0.02F, 0.02F, 0.03F)};
    scene.bySeed = true;
    return scene;
}

} // namespace Lixel::Samples

#pragma once

#include "common/ScenePieces.h"

namespace Lixel::Samples {

/// A room's inside, in metres, about the origin; its floor is at y = 0.
struct RoomShape {
    float halfWidth = 6.0F;  ///< along x
    float halfLength = 4.5F; ///< along z
    float height = 3.4F;
    float wall = 0.3F;   ///< thickness of walls, floor and ceiling
    int windowsWide = 0; ///< in each wall along x
    int windowsLong = 0; ///< in each wall along z
};

/// Floor, walls with their windows, and ceiling; parts of the room that cast.
void placeRoom(Ogre::SceneManager& sceneManager, const std::string& path, const RoomShape& shape);

/// Tables with chairs, shelves, sofas and plants, where a seed puts them.
void furnishRoom(Ogre::SceneManager& sceneManager, const std::string& path, const RoomShape& shape,
                 Random random);

} // namespace Lixel::Samples

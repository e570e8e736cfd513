#pragma once

#include "common/MeshBuilder.h"

#include <span>
#include <string>

namespace Lixel::Samples {

// Things of the garden. Their materials are those of media/garden, by name.

/// A picket fence along a line of x and z, whose pickets are a picture with holes: a front and a
/// back, with nothing between.
struct GardenFence {
    static constexpr float Height = 1.15F;
    static constexpr float Thickness = 0.03F;
    static constexpr float PictureWidth = 0.575F; ///< of two pickets

    Ogre::MeshPtr pickets;
    Ogre::MeshPtr posts; ///< solid ones, at the ends
    GardenFence(const std::string& name, std::span<const Ogre::Vector2> line);
};

/// A mesh and its material.
struct GardenPart {
    Ogre::MeshPtr mesh;
    const char* material;
    bool casts = true;
};

/// Each stands on the ground at the origin and faces +z.
std::vector<GardenPart> gardenShed(const std::string& name);
std::vector<GardenPart> gardenBench(const std::string& name);
std::vector<GardenPart> gardenWell(const std::string& name);
/// A lantern on a post, whose light is at LanternHeight.
std::vector<GardenPart> gardenLantern(const std::string& name);
inline constexpr float LanternHeight = 2.05F;
/// A watering can, held by the middle of its handle, which is the origin.
Ogre::MeshPtr wateringCan(const std::string& name);

} // namespace Lixel::Samples

#include "common/GardenGround.h"

#include "common/Terrain.h"

#include <algorithm>
#include <cmath>

namespace Lixel::Samples {
namespace {

using Ogre::uint32;
using Ogre::Vector2;
using Ogre::Vector3;

constexpr float HalfGround = 90.0F;
constexpr uint32 GroundCells = 112;   ///< in each direction
constexpr float GroundTexture = 2.4F; ///< metres that a texture covers
/// The path lies above the ground, whose triangles are coarser.
constexpr float PathAbove = 0.035F;

Ogre::MeshPtr meshOfGround(const Ogre::String& name, const GroundGrid& grid) {
    MeshBuilder mesh;
    grid.addTo(mesh);
    return mesh.build(name);
}

} // namespace

float gardenHeight(float x, float z) {
    constexpr float Level = 20.0F; // radius in which there are no hills
    const float waves = 0.45F * std::sin(0.11F * x + 0.5F) * std::cos(0.09F * z - 0.3F) +
                        0.16F * std::sin(0.21F * x - 0.17F * z);
    const float beyond = std::max(0.0F, std::hypot(x, z) - Level);
    const float hills = 1.0F + 0.35F * std::sin(0.07F * x + 0.05F * z + 1.0F);
    return waves + 0.0011F * hills * beyond * beyond;
}

Vector3 onGarden(float x, float z, float above) {
    return {x, gardenHeight(x, z) + above, z};
}

std::vector<Vector2> curveThrough(std::span<const Vector2> points, float step) {
    std::vector<Vector2> curve;
    const auto at = [&](std::ptrdiff_t i) {
        return points[static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(i, 0, std::ssize(points) - 1))];
    };
    for (std::ptrdiff_t i = 0; i + 1 < std::ssize(points); ++i) {
        const int parts =
            std::max(1, static_cast<int>(std::lround((at(i + 1) - at(i)).length() / step)));
        for (int part = 0; part < parts; ++part) {
            // Catmull and Rom 1974.
            const float t = static_cast<float>(part) / static_cast<float>(parts);
            const Vector2 a = 2.0F * at(i);
            const Vector2 b = at(i + 1) - at(i - 1);
            const Vector2 c = 2.0F * at(i - 1) - 5.0F * at(i) + 4.0F * at(i + 1) - at(i + 2);
            const Vector2 d = 3.0F * at(i) - at(i - 1) - 3.0F * at(i + 1) + at(i + 2);
            curve.push_back(0.5F * (a + t * (b + t * (c + t * d))));
        }
    }
    curve.push_back(points.back());
    return curve;
}

float distanceFrom(std::span<const Vector2> line, const Vector2& place) {
    float least = Ogre::Math::POS_INFINITY;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vector2 along = line[i + 1] - line[i];
        const float t =
            std::clamp((place - line[i]).dotProduct(along) / along.squaredLength(), 0.0F, 1.0F);
        least = std::min(least, (line[i] + t * along).distance(place));
    }
    return least;
}

Ogre::MeshPtr gardenGround(const Ogre::String& name) {
    GroundGrid grid(gardenHeight);
    const auto place = [](uint32 i) {
        return HalfGround * (2.0F * static_cast<float>(i) / static_cast<float>(GroundCells) - 1.0F);
    };
    for (uint32 row = 0; row <= GroundCells; ++row)
        for (uint32 column = 0; column <= GroundCells; ++column)
            grid.add(place(column), place(row), 0.0F,
                     Vector2(place(column), place(row)) / GroundTexture);
    grid.connect(GroundCells + 1, GroundCells + 1);
    return meshOfGround(name, grid);
}

Ogre::MeshPtr gardenPath(const Ogre::String& name, std::span<const Vector2> line, float width) {
    constexpr uint32 Across = 5;
    GroundGrid grid(gardenHeight);
    float along = 0.0F;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vector2 before = line[i > 0 ? i - 1 : 0];
        const Vector2 after = line[std::min(i + 1, line.size() - 1)];
        const Vector2 forward = (after - before).normalisedCopy();
        if (i > 0) along += line[i].distance(before);
        for (uint32 k = 0; k < Across; ++k) {
            const float u = static_cast<float>(k) / static_cast<float>(Across - 1);
            const Vector2 place = line[i] + (u - 0.5F) * width * Vector2(forward.y, -forward.x);
            grid.add(place.x, place.y, PathAbove, {u, along / width});
        }
    }
    grid.connect(static_cast<uint32>(line.size()), Across);
    return meshOfGround(name, grid);
}

} // namespace Lixel::Samples

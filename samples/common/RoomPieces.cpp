#include "common/RoomPieces.h"

#include <algorithm>
#include <array>

namespace Lixel::Samples {
namespace {

using Ogre::ColourValue;
using Ogre::Vector3;

/// A wall along x about the origin from z = 0 on, with windows of equal width.
void addWall(MeshBuilder& mesh, float length, float height, float thickness, int windows) {
    const float half = 0.5F * length;
    if (windows == 0) {
        mesh.box({-half, 0.0F, 0.0F}, {half, height, thickness});
        return;
    }
    const float sill = 0.15F * height;
    const float head = 0.92F * height;
    mesh.box({-half, 0.0F, 0.0F}, {half, sill, thickness});
    mesh.box({-half, head, 0.0F}, {half, height, thickness});
    const float pitch = length / static_cast<float>(windows);
    constexpr float Pier = 0.16F; // of a pitch
    for (int i = 0; i <= windows; ++i) {
        const float x = static_cast<float>(i) * pitch - half;
        mesh.box({std::max(-half, x - 0.5F * Pier * pitch), sill, 0.0F},
                 {std::min(half, x + 0.5F * Pier * pitch), head, thickness});
        if (i == windows) break;
        // Glazing bars.
        mesh.box({x + 0.5F * pitch - 0.03F, sill, 0.4F * thickness},
                 {x + 0.5F * pitch + 0.03F, head, 0.6F * thickness});
        const float bar = sill + 0.65F * (head - sill);
        mesh.box({x + 0.5F * Pier * pitch, bar, 0.4F * thickness},
                 {x + (1.0F - 0.5F * Pier) * pitch, bar + 0.06F, 0.6F * thickness});
    }
}

Ogre::MeshPtr makeTable(const std::string& name) {
    MeshBuilder mesh;
    mesh.boxOn({0.0F, 0.7F, 0.0F}, 1.8F, 0.05F, 0.9F);
    for (const float x : {-0.82F, 0.82F})
        for (const float z : {-0.38F, 0.38F})
            mesh.boxOn({x, 0.0F, z}, 0.07F, 0.7F, 0.07F);
    return mesh.build(name);
}

/// Its back is at +z.
Ogre::MeshPtr makeChair(const std::string& name) {
    MeshBuilder mesh;
    mesh.boxOn({0.0F, 0.42F, 0.0F}, 0.44F, 0.04F, 0.44F);
    for (const float x : {-0.19F, 0.19F}) {
        mesh.boxOn({x, 0.0F, -0.19F}, 0.04F, 0.42F, 0.04F);
        mesh.boxOn({x, 0.0F, 0.19F}, 0.04F, 0.42F, 0.04F);
        mesh.boxOn({x, 0.46F, 0.2F}, 0.04F, 0.46F, 0.03F);
    }
    for (const float y : {0.6F, 0.74F, 0.86F})
        mesh.boxOn({0.0F, y, 0.2F}, 0.34F, 0.06F, 0.02F);
    return mesh.build(name);
}

Ogre::MeshPtr makeShelf(const std::string& name) {
    MeshBuilder mesh;
    Random random(4);
    for (const float x : {-0.6F, 0.6F})
        mesh.boxOn({x, 0.0F, 0.0F}, 0.04F, 2.0F, 0.34F);
    for (int i = 0; i < 5; ++i) {
        const float y = 0.1F + 0.44F * static_cast<float>(i);
        mesh.boxOn({0.0F, y, 0.0F}, 1.16F, 0.03F, 0.34F);
        float x = -0.55F;
        while (i < 4 && x < 0.4F) {
            const float wide = random.between(0.03F, 0.09F);
            mesh.boxOn({x + 0.5F * wide, y + 0.03F, -0.02F}, wide - 0.004F,
                       random.between(0.2F, 0.33F), 0.22F);
            x += wide;
        }
    }
    return mesh.build(name);
}

Ogre::MeshPtr makeSofa(const std::string& name) {
    MeshBuilder mesh;
    mesh.boxOn({0.0F, 0.1F, 0.0F}, 1.9F, 0.32F, 0.85F);
    mesh.boxOn({0.0F, 0.42F, 0.34F}, 1.9F, 0.42F, 0.17F);
    for (const float x : {-0.87F, 0.87F})
        mesh.boxOn({x, 0.42F, -0.09F}, 0.16F, 0.2F, 0.67F);
    for (const float x : {-0.85F, 0.85F})
        for (const float z : {-0.35F, 0.35F})
            mesh.boxOn({x, 0.0F, z}, 0.06F, 0.1F, 0.06F);
    return mesh.build(name);
}

TwoMeshes makePlant(const std::string& name) {
    MeshBuilder pot;
    pot.lathe(std::array{ProfilePoint{0.0F, 0.0F}, ProfilePoint{0.17F, 0.0F},
                         ProfilePoint{0.24F, 0.42F}, ProfilePoint{0.0F, 0.42F}},
              16);
    MeshBuilder leaves;
    leaves.transform.setTrans(Vector3(0.0F, 0.42F, 0.0F));
    leaves.cylinder(0.03F, 0.0F, 0.6F, 8);
    Random random(9);
    for (int i = 0; i < 7; ++i)
        leaves.sphere({random.between(-0.22F, 0.22F), random.between(0.4F, 0.95F),
                       random.between(-0.22F, 0.22F)},
                      random.between(0.1F, 0.2F), 10);
    return {pot.build(name + "/pot"), leaves.build(name + "/leaves")};
}

} // namespace

void placeRoom(Ogre::SceneManager& sceneManager, const std::string& path, const RoomShape& shape) {
    const float outX = shape.halfWidth + shape.wall;
    const float outZ = shape.halfLength + shape.wall;
    MeshBuilder floor;
    floor.box({-outX, -shape.wall, -outZ}, {outX, 0.0F, outZ});
    place(sceneManager, floor.build(path + "floor"),
          makeSurface(path + "floor", ColourValue(0.66F, 0.55F, 0.42F),
                      patternTexture(Pattern::Paving)));
    MeshBuilder walls;
    for (const float side : {1.0F, -1.0F}) {
        const Ogre::Quaternion half(Ogre::Degree(side > 0.0F ? 0.0F : 180.0F), Vector3::UNIT_Y);
        walls.transform = Ogre::Affine3(half * Vector3(0.0F, 0.0F, shape.halfLength), half);
        addWall(walls, 2.0F * outX, shape.height, shape.wall, shape.windowsWide);
        const Ogre::Quaternion quarter(Ogre::Degree(side * 90.0F), Vector3::UNIT_Y);
        walls.transform = Ogre::Affine3(quarter * Vector3(0.0F, 0.0F, shape.halfWidth), quarter);
        addWall(walls, 2.0F * shape.halfLength, shape.height, shape.wall, shape.windowsLong);
    }
    walls.transform = Ogre::Affine3::IDENTITY;
    walls.box({-outX, shape.height, -outZ}, {outX, shape.height + shape.wall, outZ});
    place(sceneManager, walls.build(path + "walls"),
          makeSurface(path + "walls", ColourValue(0.84F, 0.80F, 0.72F),
                      patternTexture(Pattern::Grain)));
}

void furnishRoom(Ogre::SceneManager& sceneManager, const std::string& path, const RoomShape& shape,
                 Random random) {
    const auto wood = makeSurface(path + "wood", ColourValue(0.58F, 0.41F, 0.27F));
    const auto dark = makeSurface(path + "dark-wood", ColourValue(0.42F, 0.30F, 0.22F));
    const auto cloth = makeSurface(path + "cloth", ColourValue(0.45F, 0.52F, 0.62F));
    const auto clay = makeSurface(path + "clay", ColourValue(0.72F, 0.45F, 0.34F));
    const auto green = makeSurface(path + "green", ColourValue(0.38F, 0.54F, 0.33F));
    const Ogre::MeshPtr table = makeTable(path + "table");
    const Ogre::MeshPtr chair = makeChair(path + "chair");
    const Ogre::MeshPtr shelf = makeShelf(path + "shelf");
    const Ogre::MeshPtr sofa = makeSofa(path + "sofa");
    const TwoMeshes plant = makePlant(path + "plant");

    // A cell of the floor for each group of furniture; one in five stays empty.
    constexpr float Cell = 3.0F;
    const int columns = static_cast<int>(2.0F * shape.halfWidth / Cell);
    const int rows = static_cast<int>(2.0F * shape.halfLength / Cell);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const Vector3 centre(
                (static_cast<float>(column) - 0.5F * static_cast<float>(columns - 1)) * Cell +
                    random.between(-0.3F, 0.3F),
                0.0F,
                (static_cast<float>(row) - 0.5F * static_cast<float>(rows - 1)) * Cell +
                    random.between(-0.3F, 0.3F));
            const float yaw = 90.0F * static_cast<float>(random.below(4));
            const Ogre::Quaternion turn(Ogre::Degree(yaw), Vector3::UNIT_Y);
            switch (random.below(5)) {
            case 0:
            case 1:
                place(sceneManager, table, wood, {centre, yaw, 1.0F});
                for (const float x : {-0.45F, 0.45F})
                    for (const float side : {1.0F, -1.0F})
                        place(sceneManager, chair, dark,
                              {centre + turn * Vector3(x, 0.0F, side * random.between(0.5F, 0.8F)),
                               yaw + (side > 0.0F ? 0.0F : 180.0F) + random.between(-15.0F, 15.0F),
                               1.0F});
                break;
            case 2:
                place(sceneManager, sofa, cloth, {centre, yaw, 1.0F});
                break;
            case 3:
                place(sceneManager, shelf, dark, {centre, yaw, 1.0F});
                place(
                    sceneManager, plant, clay, green,
                    {centre + turn * Vector3(0.95F, 0.0F, 0.0F), yaw, random.between(0.8F, 1.2F)});
                break;
            default:
                break;
            }
        }
    }
}

} // namespace Lixel::Samples

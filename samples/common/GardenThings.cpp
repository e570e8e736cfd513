#include "common/GardenThings.h"

#include "common/GardenGround.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace Lixel::Samples {
namespace {

using Ogre::Quaternion;
using Ogre::uint32;
using Ogre::Vector2;
using Ogre::Vector3;

/// One side of a fence, `aside` to the left of its line; pictures follow each other along it.
void addFenceSide(MeshBuilder& mesh, std::span<const Vector2> line, float aside) {
    std::vector<Vector3> positions, normals;
    std::vector<Vector2> uvs;
    std::vector<uint32> indices;
    float along = 0.0F;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vector2 before = line[i > 0 ? i - 1 : 0];
        const Vector2 after = line[std::min(i + 1, line.size() - 1)];
        const Vector2 forward = (after - before).normalisedCopy();
        const Vector2 left(forward.y, -forward.x);
        if (i > 0) along += line[i].distance(before);
        const Vector2 place = line[i] + aside * left;
        const float u = along / GardenFence::PictureWidth;
        for (const float up : {0.0F, 1.0F}) {
            positions.push_back(onGarden(place.x, place.y, up * GardenFence::Height - 0.03F));
            normals.push_back(Vector3(left.x, 0.0F, left.y) * (aside < 0.0F ? -1.0F : 1.0F));
            uvs.emplace_back(u, 1.0F - up);
        }
    }
    for (uint32 v = 0; v + 3 < positions.size(); v += 2) {
        if (aside < 0.0F)
            indices.insert(indices.end(), {v, v + 2, v + 3, v, v + 3, v + 1});
        else
            indices.insert(indices.end(), {v, v + 3, v + 2, v, v + 1, v + 3});
    }
    mesh.triangles(positions, normals, uvs, indices);
}

void addPost(MeshBuilder& mesh, const Vector2& place) {
    const Vector3 foot = onGarden(place.x, place.y, -0.1F);
    mesh.boxOn(foot, 0.13F, GardenFence::Height + 0.2F, 0.13F);
    mesh.transform.setTrans(foot + Vector3(0.0F, GardenFence::Height + 0.2F, 0.0F));
    mesh.sphere({0.0F, 0.05F, 0.0F}, 0.085F, 14);
    mesh.transform = Ogre::Affine3::IDENTITY;
}

/// A gable roof whose ridge goes along x, of slabs that reach beyond the walls.
void addGardenRoof(MeshBuilder& mesh, float halfLength, float halfWidth, float eaves, float rise,
                   float over, float thick) {
    const float slope = rise / halfWidth;
    const float edge = halfWidth + over;
    // In the outline, x is the house's -z.
    mesh.transform = Ogre::Affine3(Vector3::ZERO, Quaternion(Ogre::Degree(90), Vector3::UNIT_Y));
    const float ridge = eaves + rise;
    const float low = eaves - slope * over;
    mesh.prism(std::array{Vector2(0, ridge), Vector2(edge, low), Vector2(edge, low + thick),
                          Vector2(0, ridge + thick)},
               -halfLength, halfLength);
    mesh.prism(std::array{Vector2(0, ridge + thick), Vector2(-edge, low + thick),
                          Vector2(-edge, low), Vector2(0, ridge)},
               -halfLength, halfLength);
    mesh.transform = Ogre::Affine3::IDENTITY;
}

} // namespace

GardenFence::GardenFence(const std::string& name, std::span<const Vector2> line) {
    MeshBuilder sides;
    addFenceSide(sides, line, 0.5F * Thickness);
    addFenceSide(sides, line, -0.5F * Thickness);
    pickets = sides.build(name + "/pickets");
    MeshBuilder solid;
    addPost(solid, line.front());
    addPost(solid, line.back());
    posts = solid.build(name + "/posts");
}

std::vector<GardenPart> gardenShed(const std::string& name) {
    constexpr float HalfLength = 1.9F, HalfWidth = 1.4F, Eaves = 2.0F, Rise = 1.15F;
    MeshBuilder walls, roof, trim, base;
    walls.box({-HalfLength, -0.3F, -HalfWidth}, {HalfLength, Eaves, HalfWidth});
    walls.transform = Ogre::Affine3(Vector3::ZERO, Quaternion(Ogre::Degree(90), Vector3::UNIT_Y));
    walls.prism(
        std::array{Vector2(-HalfWidth, Eaves), Vector2(HalfWidth, Eaves), Vector2(0, Eaves + Rise)},
        -HalfLength, HalfLength);
    addGardenRoof(roof, HalfLength + 0.3F, HalfWidth, Eaves, Rise, 0.4F, 0.12F);
    base.box({-HalfLength - 0.08F, -0.4F, -HalfWidth - 0.08F},
             {HalfLength + 0.08F, 0.22F, HalfWidth + 0.08F});
    base.boxOn({-0.7F, -0.2F, HalfWidth + 0.35F}, 1.1F, 0.3F, 0.5F);
    // A door and a window with a cross, in front of the wall.
    const float front = HalfWidth + 0.03F;
    for (const float x : {-1.2F, -0.2F})
        trim.boxOn({x, 0.22F, front}, 0.1F, 1.68F, 0.1F);
    trim.boxOn({-0.7F, 1.8F, front}, 1.1F, 0.1F, 0.1F);
    for (const float y : {0.95F, 1.7F})
        trim.boxOn({0.95F, y, front}, 0.98F, 0.09F, 0.12F);
    for (const float x : {0.5F, 0.95F, 1.4F})
        trim.boxOn({x, 0.95F, front}, x == 0.95F ? 0.05F : 0.09F, 0.8F, 0.1F);
    trim.boxOn({0.95F, 1.32F, front}, 0.9F, 0.05F, 0.1F);
    MeshBuilder door, glass;
    door.box({-1.15F, 0.2F, HalfWidth - 0.1F}, {-0.25F, 1.8F, HalfWidth + 0.025F});
    glass.box({0.5F, 0.95F, HalfWidth - 0.1F}, {1.4F, 1.75F, HalfWidth + 0.02F});
    return {{walls.build(name + "/walls"), "Garden/Planks"},
            {roof.build(name + "/roof"), "Garden/Roof"},
            {trim.build(name + "/trim"), "Garden/Paint"},
            {door.build(name + "/door"), "Garden/Door"},
            {glass.build(name + "/glass"), "Garden/Glass"},
            {base.build(name + "/base"), "Garden/Stone"}};
}

std::vector<GardenPart> gardenBench(const std::string& name) {
    MeshBuilder wood, iron;
    for (int i = 0; i < 4; ++i)
        wood.boxOn({0.0F, 0.44F, -0.18F + 0.12F * static_cast<float>(i)}, 1.7F, 0.035F, 0.1F);
    for (int i = 0; i < 3; ++i)
        wood.boxOn(
            {0.0F, 0.56F + 0.13F * static_cast<float>(i), -0.27F - 0.025F * static_cast<float>(i)},
            1.7F, 0.1F, 0.03F);
    for (const float x : {-0.72F, 0.72F}) {
        iron.boxOn({x, 0.0F, 0.17F}, 0.05F, 0.44F, 0.05F);
        iron.boxOn({x, 0.0F, -0.25F}, 0.05F, 0.44F, 0.05F);
        iron.boxOn({x, 0.4F, -0.02F}, 0.05F, 0.04F, 0.44F);
        iron.boxOn({x, 0.64F, 0.0F}, 0.06F, 0.035F, 0.46F);
        iron.boxOn({x, 0.44F, 0.17F}, 0.04F, 0.2F, 0.04F);
        iron.transform = Ogre::Affine3(Vector3(x, 0.44F, -0.255F),
                                       Quaternion(Ogre::Degree(-11), Vector3::UNIT_X));
        iron.boxOn(Vector3::ZERO, 0.05F, 0.5F, 0.04F);
        iron.transform = Ogre::Affine3::IDENTITY;
    }
    return {{wood.build(name + "/wood"), "Garden/Wood"},
            {iron.build(name + "/iron"), "Garden/Iron"}};
}

std::vector<GardenPart> gardenWell(const std::string& name) {
    MeshBuilder stone, wood, roof, water;
    stone.lathe(std::array{ProfilePoint{0.0F, -0.3F}, ProfilePoint{0.86F, -0.3F},
                           ProfilePoint{0.82F, 0.72F}, ProfilePoint{0.88F, 0.72F},
                           ProfilePoint{0.88F, 0.84F}, ProfilePoint{0.6F, 0.84F},
                           ProfilePoint{0.6F, 0.1F}, ProfilePoint{0.0F, 0.1F}},
                28);
    water.cylinder(0.59F, 0.12F, 0.42F, 28);
    for (const float x : {-0.74F, 0.74F})
        wood.boxOn({x, 0.5F, 0.0F}, 0.12F, 1.55F, 0.12F);
    wood.boxOn({0.0F, 1.98F, 0.0F}, 1.8F, 0.1F, 0.1F);
    wood.transform =
        Ogre::Affine3(Vector3(-0.86F, 1.45F, 0.0F), Quaternion(Ogre::Degree(-90), Vector3::UNIT_Z));
    wood.cylinder(0.07F, 0.0F, 1.72F, 14);
    wood.transform = Ogre::Affine3::IDENTITY;
    // A bucket on its rope.
    wood.lathe(std::array{ProfilePoint{0.0F, 0.84F}, ProfilePoint{0.12F, 0.84F},
                          ProfilePoint{0.16F, 1.1F}, ProfilePoint{0.14F, 1.1F},
                          ProfilePoint{0.11F, 0.88F}, ProfilePoint{0.0F, 0.88F}},
               16);
    wood.boxOn({0.0F, 1.08F, 0.0F}, 0.02F, 0.36F, 0.02F);
    addGardenRoof(roof, 1.05F, 0.75F, 1.95F, 0.5F, 0.2F, 0.06F);
    return {{stone.build(name + "/stone"), "Garden/Stone"},
            {water.build(name + "/water"), "Garden/Glass"},
            {wood.build(name + "/wood"), "Garden/Wood"},
            {roof.build(name + "/roof"), "Garden/Roof"}};
}

std::vector<GardenPart> gardenLantern(const std::string& name) {
    MeshBuilder iron, flame;
    iron.lathe(std::array{ProfilePoint{0.0F, -0.2F}, ProfilePoint{0.12F, -0.2F},
                          ProfilePoint{0.12F, 0.1F}, ProfilePoint{0.05F, 0.2F, true},
                          ProfilePoint{0.04F, 1.8F, true}, ProfilePoint{0.1F, 1.86F},
                          ProfilePoint{0.0F, 1.86F}},
               14);
    constexpr float Half = 0.12F;
    iron.boxOn({0.0F, 1.86F, 0.0F}, 0.28F, 0.03F, 0.28F);
    for (const float x : {-Half, Half})
        for (const float z : {-Half, Half})
            iron.boxOn({x, 1.88F, z}, 0.022F, 0.36F, 0.022F);
    iron.cone(0.22F, 2.24F, 2.42F, 4);
    iron.sphere({0.0F, 2.44F, 0.0F}, 0.035F, 10);
    flame.lathe(std::array{ProfilePoint{0.0F, 1.89F}, ProfilePoint{0.05F, 1.89F},
                           ProfilePoint{0.05F, 2.0F}, ProfilePoint{0.0F, 2.12F}},
                12);
    return {{iron.build(name + "/iron"), "Garden/Iron"},
            {flame.build(name + "/flame"), "Garden/Flame", false}}; // around the light
}

Ogre::MeshPtr wateringCan(const std::string& name) {
    MeshBuilder can;
    can.lathe(std::array{ProfilePoint{0.0F, -0.42F}, ProfilePoint{0.14F, -0.42F},
                         ProfilePoint{0.125F, -0.16F}, ProfilePoint{0.0F, -0.14F}},
              18);
    const auto rod = [&](const Vector3& from, const Vector3& to, float r0, float r1) {
        const Vector3 along = to - from;
        can.transform = Ogre::Affine3(from, Vector3::UNIT_Y.getRotationTo(along.normalisedCopy()));
        can.lathe(std::array{ProfilePoint{0.0F, 0.0F}, ProfilePoint{r0, 0.0F},
                             ProfilePoint{r1, along.length()}, ProfilePoint{0.0F, along.length()}},
                  10);
        can.transform = Ogre::Affine3::IDENTITY;
    };
    rod({0.0F, -0.36F, 0.12F}, {0.0F, -0.1F, 0.36F}, 0.022F, 0.018F);
    rod({0.0F, -0.115F, 0.345F}, {0.0F, -0.065F, 0.395F}, 0.02F, 0.055F);
    rod({0.0F, -0.18F, 0.11F}, {0.0F, 0.0F, 0.07F}, 0.012F, 0.012F);
    rod({0.0F, 0.0F, 0.075F}, {0.0F, 0.0F, -0.075F}, 0.013F, 0.013F);
    rod({0.0F, 0.0F, -0.07F}, {0.0F, -0.3F, -0.135F}, 0.012F, 0.012F);
    return can.build(name);
}

} // namespace Lixel::Samples

#include "common/ScenePieces.h"

#include <array>

namespace Lixel::Samples {

using Ogre::Vector3;

Ogre::Entity* place(Ogre::SceneManager& sceneManager, const Ogre::MeshPtr& mesh,
                    const Ogre::MaterialPtr& material, const Placement& placement) {
    Ogre::Entity* entity = sceneManager.createEntity(mesh);
    entity->setMaterial(material);
    Ogre::SceneNode* node = sceneManager.getRootSceneNode()->createChildSceneNode(
        placement.position, Ogre::Quaternion(Ogre::Degree(placement.yawDegrees), Vector3::UNIT_Y));
    node->setScale(Vector3(placement.scale));
    node->attachObject(entity);
    return entity;
}

Ogre::Entity* placeGround(Ogre::SceneManager& sceneManager, const std::string& name, float halfSide,
                          const Ogre::MaterialPtr& material) {
    MeshBuilder mesh;
    mesh.ground(halfSide, 32);
    Ogre::Entity* entity = place(sceneManager, mesh.build(name), material);
    entity->setCastShadows(false);
    return entity;
}

void place(Ogre::SceneManager& sceneManager, const TwoMeshes& meshes,
           const Ogre::MaterialPtr& lower, const Ogre::MaterialPtr& upper,
           const Placement& placement) {
    place(sceneManager, meshes.lower, lower, placement);
    place(sceneManager, meshes.upper, upper, placement);
}

TwoMeshes spruce(const std::string& name, float height) {
    MeshBuilder trunk;
    trunk.cylinder(0.03F * height, 0.0F, 0.3F * height, 10);
    MeshBuilder crown;
    constexpr int Layers = 4;
    std::vector<ProfilePoint> profile{{0.0F, 0.14F * height}};
    for (int i = 0; i < Layers; ++i) {
        const float t = static_cast<float>(i) / Layers;
        const float wide = height * 0.24F * (1.0F - 0.8F * t);
        const float low = height * (0.14F + 0.8F * t);
        profile.push_back({wide, low});
        if (i + 1 < Layers) profile.push_back({0.42F * wide, low + 0.2F * height});
    }
    profile.push_back({0.0F, height});
    crown.lathe(profile, 18);
    return {trunk.build(name + "/trunk"), crown.build(name + "/crown")};
}

TwoMeshes broadleaf(const std::string& name, float height, std::uint32_t seed) {
    MeshBuilder trunk;
    trunk.lathe(std::array{ProfilePoint{0.0F, 0.0F}, ProfilePoint{0.055F * height, 0.0F},
                           ProfilePoint{0.035F * height, 0.12F * height, true},
                           ProfilePoint{0.028F * height, 0.6F * height},
                           ProfilePoint{0.0F, 0.6F * height}},
                12);
    MeshBuilder crown;
    Random random(seed);
    crown.sphere({0.0F, 0.72F * height, 0.0F}, 0.25F * height, 20);
    for (int i = 0; i < 6; ++i) {
        const Ogre::Quaternion turn(
            Ogre::Degree(static_cast<float>(i) * 60.0F + random.between(-15.0F, 15.0F)),
            Vector3::UNIT_Y);
        const Vector3 centre = turn * Vector3(random.between(0.16F, 0.24F) * height,
                                              random.between(0.54F, 0.78F) * height, 0.0F);
        crown.sphere(centre, random.between(0.13F, 0.19F) * height, 16);
    }
    return {trunk.build(name + "/trunk"), crown.build(name + "/crown")};
}

void addFence(MeshBuilder& mesh, float half) {
    const int bays = static_cast<int>(half);
    for (int i = 0; i <= bays; ++i) {
        const float x = 2.0F * static_cast<float>(i) - half;
        mesh.boxOn({x, 0.0F, 0.0F}, 0.14F, 1.25F, 0.14F);
        mesh.boxOn({x, 1.25F, 0.0F}, 0.2F, 0.05F, 0.2F);
    }
    for (const float height : {0.45F, 0.95F})
        mesh.boxOn({0.0F, height, 0.11F}, 2.0F * half, 0.12F, 0.05F);
}

void addColumn(MeshBuilder& mesh, float radius, float height, int segments) {
    const float r = radius;
    const float h = height;
    mesh.lathe(std::array{ProfilePoint{0.0F, 0.0F}, ProfilePoint{1.45F * r, 0.0F},
                          ProfilePoint{1.45F * r, 0.35F * r}, ProfilePoint{1.2F * r, 0.55F * r},
                          ProfilePoint{1.0F * r, 0.9F * r}, ProfilePoint{1.03F * r, 0.4F * h, true},
                          ProfilePoint{0.85F * r, h - 0.9F * r},
                          ProfilePoint{1.3F * r, h - 0.45F * r}, ProfilePoint{1.3F * r, h},
                          ProfilePoint{0.0F, h}},
               segments);
}

} // namespace Lixel::Samples

// Triangles of instances, against those of entities in the same places.

#include "OgreTest.h"
#include "VertexPrograms.h"

#include "common/MeshBuilder.h"
#include "common/Triangles.h"

#include <OgreInstanceManager.h>
#include <OgreInstancedEntity.h>

#include <algorithm>
#include <array>

namespace Lixel::Samples {
namespace {

using Ogre::InstanceManager;
using Ogre::Vector3;

class InstanceTriangles
    : public OgreTest,
      public ::testing::WithParamInterface<InstanceManager::InstancingTechnique> {
protected:
    InstanceTriangles() {
        MeshBuilder builder;
        builder.boxOn(Vector3(1, 0, 0), 1, 2, 3);
        builder.cone(1, 2, 4, 7);
        builder.build("shape");
        addMaterial("instanced",
                    addVertexProgram("instances", InstanceArrayProgram, [](Ogre::GpuProgram&) {
                    })->getName());
        // Batches of two.
        instances =
            scene->createInstanceManager("instances", "shape", Ogre::RGN_DEFAULT, GetParam(), 2);
    }

    ~InstanceTriangles() override { scene->destroyInstanceManager(instances); }

    Ogre::InstancedEntity* addInstance() { return instances->createInstancedEntity("instanced"); }

    /// Nodes that are turned, scaled and below one another.
    std::vector<Ogre::SceneNode*> places() {
        std::vector<Ogre::SceneNode*> nodes{&child({1e3F, 0, 0}), &child({-5, 2, 1})};
        nodes[1]->setOrientation(
            Ogre::Quaternion(Ogre::Degree(70), Vector3(1, -1, 3).normalisedCopy()));
        nodes[1]->setScale(1, 2, 0.25F);
        nodes.push_back(nodes[1]->createChildSceneNode(Vector3(3, 0, 4)));
        nodes.push_back(&child({0, -4, 9}));
        nodes.push_back(&child({0, 40, 9}));
        return nodes;
    }

    TriangleScene ofEntities(const std::vector<Ogre::SceneNode*>& nodes) {
        std::vector<Ogre::Entity*> entities;
        for (Ogre::SceneNode* node : nodes) {
            entities.push_back(scene->createEntity("shape"));
            entities.back()->setMaterialName("instanced");
            node->attachObject(entities.back());
        }
        TriangleScene triangles = collectTriangles(*scene);
        for (Ogre::Entity* entity : entities)
            scene->destroyEntity(entity);
        return triangles;
    }

    /// Of one scene's triangles and of another's, in whatever order they come.
    static void expectSame(const TriangleScene& one, const TriangleScene& other) {
        const auto corners = [](const TriangleScene& triangles) {
            std::vector<std::array<double, 9>> all;
            for (const Triangle& triangle : triangles.triangles) {
                std::array<double, 9>& nine = all.emplace_back();
                for (std::size_t i = 0; i < 9; ++i)
                    nine[i] = triangles.positions[triangle.vertices[i / 3]](
                        static_cast<Eigen::Index>(i % 3));
            }
            std::ranges::sort(all);
            return all;
        };
        EXPECT_EQ(corners(one), corners(other));
    }

    InstanceManager* instances;
};

TEST_P(InstanceTriangles, AreThoseOfEntitiesInTheSamePlaces) {
    const std::vector<Ogre::SceneNode*> nodes = places();
    const TriangleScene entities = ofEntities(nodes);
    ASSERT_EQ(entities.triangles.size(), 5U * (12 + 14));
    for (Ogre::SceneNode* node : nodes)
        node->attachObject(addInstance());
    expectSame(collectTriangles(*scene), entities);
    // They follow their nodes.
    nodes[1]->setPosition(7, 7, 7);
    const TriangleScene moved = collectTriangles(*scene);
    std::vector<Ogre::MovableObject*> attached;
    for (Ogre::SceneNode* node : nodes) {
        attached.push_back(node->getAttachedObject(0));
        attached.back()->setVisible(false);
    }
    EXPECT_TRUE(collectTriangles(*scene).triangles.empty()) << "all are hidden";
    expectSame(moved, ofEntities(nodes));
}

TEST_P(InstanceTriangles, CountWhileTheyAreUsedAndShown) {
    std::array<Ogre::InstancedEntity*, 3> three{};
    for (Ogre::InstancedEntity*& instance : three) {
        instance = addInstance();
        child().attachObject(instance);
    }
    const auto count = [&] { return collectTriangles(*scene).triangles.size() / 26; };
    EXPECT_EQ(count(), 3U);
    three[1]->setVisibilityFlags(2);
    scene->setVisibilityMask(1);
    EXPECT_EQ(count(), 2U);
    scene->setVisibilityMask(3);
    three[0]->setVisible(false);
    EXPECT_EQ(count(), 2U);
    scene->destroyInstancedEntity(three[1]);
    EXPECT_EQ(count(), 1U);
}

/// OGRE draws such an instance from when it is created on.
TEST_P(InstanceTriangles, NeedNoNode) {
    Ogre::InstancedEntity* const instance = addInstance();
    instance->setPosition(Vector3(5, 6, 7), false);
    instance->setScale(Vector3(2, 2, 2), true);
    const TriangleScene loose = collectTriangles(*scene);
    instance->setVisible(false);
    Ogre::SceneNode& node = child({5, 6, 7});
    node.setScale(2, 2, 2);
    expectSame(loose, ofEntities({&node}));
}

TEST_P(InstanceTriangles, CastAndReceiveAsTheirBatchDoes) {
    child().attachObject(addInstance());
    Triangle flags = collectTriangles(*scene).triangles.front();
    EXPECT_TRUE(flags.casts);
    EXPECT_TRUE(flags.receives);
    EXPECT_FALSE(flags.drawnFromBack);
    instances->setSetting(InstanceManager::CAST_SHADOWS, false);
    flags = collectTriangles(*scene).triangles.front();
    EXPECT_FALSE(flags.casts);
    EXPECT_TRUE(flags.receives);
}

std::string nameOf(const ::testing::TestParamInfo<InstanceManager::InstancingTechnique>& instance) {
    switch (instance.param) {
    case InstanceManager::ShaderBased:
        return "ShaderBased";
    case InstanceManager::TextureVTF:
        return "TextureVTF";
    case InstanceManager::HWInstancingBasic:
        return "HWInstancingBasic";
    default:
        return "HWInstancingVTF";
    }
}

INSTANTIATE_TEST_SUITE_P(Techniques, InstanceTriangles,
                         ::testing::Values(InstanceManager::HWInstancingBasic,
                                           InstanceManager::HWInstancingVTF,
                                           InstanceManager::TextureVTF,
                                           InstanceManager::ShaderBased),
                         nameOf);

using InstancesOfBasicHardware = OgreTest;

/// OGRE turns its culling for a whole batch, by a matrix that is the identity.
TEST_F(InstancesOfBasicHardware, AreNotTurnedWhereTheyAreMirrored) {
    MeshBuilder builder;
    builder.boxOn(Vector3::ZERO, 1, 2, 3);
    builder.build("box");
    InstanceManager& instances = *scene->createInstanceManager(
        "instances", "box", Ogre::RGN_DEFAULT, InstanceManager::HWInstancingBasic, 2);
    Ogre::SceneNode& node = child();
    node.attachObject(instances.createInstancedEntity("BaseWhite"));
    const TriangleScene upright = collectTriangles(*scene);
    node.setScale(-1, 1, 1);
    const TriangleScene mirrored = collectTriangles(*scene);
    for (std::size_t i = 0; i < upright.triangles.size(); ++i)
        EXPECT_EQ(upright.triangles[i].vertices, mirrored.triangles[i].vertices);
    scene->destroyInstanceManager(&instances);
}

/// A material with a bar and a hole.
Ogre::MaterialPtr makeBarred() {
    const auto texture = Ogre::TextureManager::getSingleton().createManual(
        "bars", Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, 2, 1, 0, Ogre::PF_BYTE_RGBA);
    std::array<Ogre::uchar, 8> texels{0, 0, 0, 255, 0, 0, 0, 0};
    texture->getBuffer()->blitFromMemory(
        Ogre::PixelBox(2, 1, 1, Ogre::PF_BYTE_RGBA, texels.data()));
    Ogre::MaterialPtr material =
        Ogre::MaterialManager::getSingleton().create("barred", Ogre::RGN_DEFAULT);
    Ogre::Pass& pass = *material->getTechnique(0)->getPass(0);
    pass.setAlphaRejectSettings(Ogre::CMPF_GREATER_EQUAL, 128);
    pass.createTextureUnitState()->setTexture(texture);
    return material;
}

TEST_F(InstancesOfBasicHardware, HaveTheHolesOfTheirMaterial) {
    MeshBuilder builder;
    builder.boxOn(Vector3::ZERO, 4, 4, 4);
    Ogre::Entity* const entity = scene->createEntity(builder.build("box"));
    entity->setMaterial(makeBarred());
    child().attachObject(entity);
    const TriangleScene one = collectTriangles(*scene);
    scene->destroyEntity(entity);
    InstanceManager& instances = *scene->createInstanceManager(
        "instances", "box", Ogre::RGN_DEFAULT, InstanceManager::HWInstancingBasic, 2);
    for (int i = 0; i < 2; ++i)
        child().attachObject(instances.createInstancedEntity("barred"));
    const TriangleScene two = collectTriangles(*scene);
    EXPECT_EQ(two.masks.size(), 1U);
    ASSERT_EQ(two.uvs.size(), 2 * one.uvs.size());
    for (std::size_t i = 0; i < two.uvs.size(); ++i)
        EXPECT_EQ(two.uvs[i], one.uvs[i % one.uvs.size()]);
    scene->destroyInstanceManager(&instances);
}

/// Where a mesh has no texture coordinates, OGRE puts the matrices into the first set of them.
TEST_F(InstancesOfBasicHardware, TakeNoMatricesForTextureCoordinates) {
    makeBarred();
    Ogre::ManualObject triangle("triangle");
    triangle.begin("barred", Ogre::RenderOperation::OT_TRIANGLE_LIST);
    for (const float x : {0.0F, 1.0F, 2.0F})
        triangle.position(x, x * x, 0);
    triangle.triangle(0, 1, 2);
    triangle.end();
    triangle.convertToMesh("triangle", Ogre::RGN_DEFAULT);
    InstanceManager& instances = *scene->createInstanceManager(
        "instances", "triangle", Ogre::RGN_DEFAULT, InstanceManager::HWInstancingBasic, 3);
    child({5, 6, 7}).attachObject(instances.createInstancedEntity("barred"));
    instances.setBatchesAsStaticAndUpdate(true); // writes the matrices, as drawing does
    const TriangleScene collected = collectTriangles(*scene);
    ASSERT_EQ(collected.uvs.size(), 3U);
    for (const Eigen::Vector2f& uv : collected.uvs)
        EXPECT_EQ(uv, Eigen::Vector2f::Zero().eval());
    scene->destroyInstanceManager(&instances);
}

} // namespace
} // namespace Lixel::Samples

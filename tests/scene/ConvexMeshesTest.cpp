// Which meshes are known to be convex, read from OGRE's buffers.
#include "SceneTest.h"

#include <OgreManualObject.h>
#include <OgreMaterialManager.h>
#include <OgreMesh.h>
#include <OgreMeshManager.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreSkeleton.h>
#include <OgreSkeletonManager.h>
#include <OgreSubEntity.h>
#include <OgreSubMesh.h>
#include <OgreTechnique.h>
#include <OgreVertexIndexData.h>

#include <cmath>

namespace Lixel::Tests {
namespace {

using Ogre::Vector3;

class ConvexMeshesTest : public SceneTest {
protected:
    ~ConvexMeshesTest() override {
        for (const Ogre::MeshPtr& mesh : mMeshes)
            Ogre::MeshManager::getSingleton().remove(mesh->getHandle());
    }

    /// Shows an entity 20 units ahead, 2 units large and more.
    Ogre::Entity* show(Ogre::Entity* entity) {
        entity->setMaterialName("BaseWhite"); // which has no programs
        mNode = mRootNode->createChildSceneNode(Vector3(0, 0, -20));
        mNode->attachObject(entity);
        return entity;
    }
    Ogre::Entity* show(const Ogre::MeshPtr& mesh) {
        mMeshes.push_back(mesh);
        return show(mManager->createEntity(mesh));
    }

    /// A mesh of quads that `draw` adds to an object.
    template <typename Draw>
    Ogre::MeshPtr make(const std::string& name, const Draw& draw, bool dynamic = false) {
        Ogre::ManualObject* drawn = mManager->createManualObject();
        drawn->setDynamic(dynamic);
        drawn->begin("BaseWhite", Ogre::RenderOperation::OT_TRIANGLE_LIST);
        draw(*drawn);
        drawn->end();
        const Ogre::MeshPtr mesh = drawn->convertToMesh(name);
        mManager->destroyManualObject(drawn);
        return mesh;
    }

    static void addBox(Ogre::ManualObject& drawn, const Vector3& lower, const Vector3& upper) {
        const auto first = static_cast<Ogre::uint32>(drawn.getCurrentVertexCount());
        for (int i = 0; i < 8; ++i)
            drawn.position((i & 1) != 0 ? upper.x : lower.x, (i & 2) != 0 ? upper.y : lower.y,
                           (i & 4) != 0 ? upper.z : lower.z);
        for (const auto& quad : {std::array{0U, 2U, 3U, 1U},
                                 {4U, 5U, 7U, 6U},
                                 {0U, 1U, 5U, 4U},
                                 {2U, 6U, 7U, 3U},
                                 {0U, 4U, 6U, 2U},
                                 {1U, 3U, 7U, 5U}})
            drawn.quad(first + quad[0], first + quad[1], first + quad[2], first + quad[3]);
    }

    Ogre::MeshPtr makeCube(const std::string& name, bool dynamic = false) {
        return make(
            name, [](auto& drawn) { addBox(drawn, -Vector3::UNIT_SCALE, Vector3::UNIT_SCALE); },
            dynamic);
    }

    /// A sheet of squares, at the height that a function gives.
    template <typename Height>
    Ogre::MeshPtr makeGround(const std::string& name, const Height& height) {
        constexpr Ogre::uint32 Squares = 8;
        return make(name, [&](Ogre::ManualObject& drawn) {
            for (Ogre::uint32 z = 0; z <= Squares; ++z)
                for (Ogre::uint32 x = 0; x <= Squares; ++x)
                    drawn.position(static_cast<float>(x) - 4, height(x, z),
                                   static_cast<float>(z) - 4);
            for (Ogre::uint32 z = 0; z < Squares; ++z)
                for (Ogre::uint32 x = 0; x < Squares; ++x) {
                    const Ogre::uint32 at = z * (Squares + 1) + x;
                    drawn.quad(at, at + Squares + 1, at + Squares + 2, at + 1);
                }
        });
    }

    /// Whether the one receiver, which must be the one caster too, shadows nothing of itself.
    bool isSelfShadowFree() {
        takeSurvey();
        EXPECT_EQ(mSurvey.receivers().size(), 1U);
        EXPECT_EQ(allCasters().size(), 1U);
        EXPECT_NE(mSurvey.receiverShapes().identityOf(0), nullptr);
        EXPECT_EQ(mSurvey.receiverShapes().identityOf(0), mSearch.shapes().identityOf(0));
        SelfShadowFree ofCaster;
        const bool result = mSurvey.receiverShapes().isSelfShadowFree(0, mBody);
        EXPECT_EQ(mSearch.shapes().isSelfShadowFree(0, ofCaster), result);
        if (result) {
            EXPECT_TRUE(ofCaster.around.wsFromBody.isApprox(mBody.around.wsFromBody));
            EXPECT_EQ(ofCaster.around.box.halfExtents, mBody.around.box.halfExtents);
            EXPECT_EQ(ofCaster.relief, mBody.relief);
        }
        return result;
    }
    /// Whether it does so whatever the light.
    bool isConvex() { return isSelfShadowFree() && !mBody.relief; }

    Ogre::SceneNode* mNode = nullptr;
    SelfShadowFree mBody;

private:
    std::vector<Ogre::MeshPtr> mMeshes;
};

INSTANTIATE_TEST_SUITE_P(SceneManager, ConvexMeshesTest,
                         testing::Values(DefaultManager, OctreeManager, FlatManager),
                         [](const auto& test) { return test.param; });

} // namespace

TEST_P(ConvexMeshesTest, ArePlanesCubesAndSpheres) {
    for (const auto prefab : {Ogre::SceneManager::PT_PLANE, Ogre::SceneManager::PT_CUBE,
                              Ogre::SceneManager::PT_SPHERE}) {
        Ogre::Entity* const entity = show(mManager->createEntity(prefab));
        mNode->setPosition(0, 0, -200);
        EXPECT_TRUE(isConvex()) << entity->getMesh()->getName();
        EXPECT_EQ(mBody.isBox, prefab != Ogre::SceneManager::PT_SPHERE);
        mNode->detachAllObjects();
    }
}

TEST_P(ConvexMeshesTest, HaveABoxThatGoesWithThem) {
    show(makeCube("convex cube"));
    mCameraNode->setPosition(1, 2, 3);
    mNode->setScale(8, 0.4f, 2);
    mNode->setOrientation(Ogre::Quaternion(Ogre::Degree(40), Vector3(1, 2, 3).normalisedCopy()));
    ASSERT_TRUE(isConvex());
    EXPECT_TRUE(mBody.around.box.halfExtents.isApprox(Vec3::Ones(), 1e-6));
    EXPECT_TRUE(mBody.around.box.centre.isZero(1e-6));
    EXPECT_TRUE(mBody.around.wsFromBody.translation().isApprox(Vec3(-1, -2, -23), 1e-6));
    EXPECT_NEAR(mBody.around.wsFromBody.linear().col(0).norm(), 8.0, 1e-5);
}

TEST_P(ConvexMeshesTest, AreFlatGroundsOfManyTriangles) {
    constexpr int Segments = 100;
    const Ogre::MeshPtr ground = Ogre::MeshManager::getSingleton().createPlane(
        "finely divided", Ogre::RGN_DEFAULT, Ogre::Plane(Vector3::UNIT_Y, 1.5f), 8, 8, Segments,
        Segments, true, 1, 1, 1, Vector3::UNIT_Z);
    show(ground);
    mSurvey.meshes().prepare(ground);
    EXPECT_TRUE(isConvex());
}

TEST_P(ConvexMeshesTest, AreSheetsWhicheverSideIsDrawn) {
    Ogre::Entity* const sheet = show(makeGround("sheet", [](auto, auto) { return 0.25f; }));
    EXPECT_TRUE(isConvex());
    Ogre::MaterialPtr bothSides =
        Ogre::MaterialManager::getSingleton().getByName("BaseWhite")->clone("BothSides");
    bothSides->setCullingMode(Ogre::CULL_NONE);
    sheet->setMaterial(bothSides);
    EXPECT_TRUE(isConvex());
    Ogre::MaterialManager::getSingleton().remove(bothSides->getHandle());
}

TEST_P(ConvexMeshesTest, AreNotGroundsWithRelief) {
    show(makeGround("relief", [](auto x, auto z) { return x == 3 && z == 4 ? 0.001f : 0.0f; }));
    EXPECT_FALSE(isConvex());
    ASSERT_TRUE(isSelfShadowFree());
    EXPECT_EQ(mBody.relief->axis, Vec3::UnitY());
    EXPECT_NEAR(mBody.relief->steepness, 0.001, 1e-3);
}

/// As relief it is convex from above, and lit from below it is not.
TEST_P(ConvexMeshesTest, AreNotHills) {
    show(makeGround("hill", [](auto x, auto z) {
        const float dx = static_cast<float>(x) - 4;
        const float dz = static_cast<float>(z) - 4;
        return -0.05f * (dx * dx + dz * dz);
    }));
    EXPECT_FALSE(isConvex());
    ASSERT_TRUE(isSelfShadowFree());
    EXPECT_EQ(mBody.relief->axis, Vec3::UnitY());
    // From 3 to 4 units from its middle, along both.
    EXPECT_NEAR(mBody.relief->steepness, std::sin(std::atan(0.35 * std::sqrt(2.0))), 1e-5);
    EXPECT_GT(mBody.relief->cells.size(), 4U);
}

TEST_P(ConvexMeshesTest, AreNotTwoGroundsInOne) {
    show(make("two sheets", [](Ogre::ManualObject& drawn) {
        for (Ogre::uint32 i = 0; i < 2; ++i) {
            const float y = 0.5f * static_cast<float>(i);
            for (const float z : {-4.0f, 4.0f})
                for (const float x : {-4.0f, 4.0f})
                    drawn.position(x, x > 0 ? y : y + 0.1f, z);
            drawn.quad(4 * i, 4 * i + 2, 4 * i + 3, 4 * i + 1);
        }
    }));
    EXPECT_FALSE(isSelfShadowFree());
}

TEST_P(ConvexMeshesTest, AreNotUs) {
    show(make("u", [](auto& drawn) {
        addBox(drawn, Vector3(-3, 0, -1), Vector3(3, 1, 1));
        addBox(drawn, Vector3(-3, 1, -1), Vector3(-2, 3, 1));
        addBox(drawn, Vector3(2, 1, -1), Vector3(3, 3, 1));
    }));
    EXPECT_FALSE(isConvex());
}

TEST_P(ConvexMeshesTest, AreNotSeveralBodies) {
    show(make("two", [](auto& drawn) {
        addBox(drawn, Vector3(-3, 0, -1), Vector3(-1, 1, 1));
        addBox(drawn, Vector3(1, 0, -1), Vector3(3, 1, 1));
    }));
    EXPECT_FALSE(isConvex());
}

/// Triangles of one part alone may be convex.
TEST_P(ConvexMeshesTest, AreNotBodiesOfSeveralParts) {
    Ogre::ManualObject* drawn = mManager->createManualObject();
    for (const float x : {-3.0f, 1.0f}) {
        drawn->begin("BaseWhite", Ogre::RenderOperation::OT_TRIANGLE_LIST);
        addBox(*drawn, Vector3(x, 0, -1), Vector3(x + 2, 1, 1));
        drawn->end();
    }
    show(drawn->convertToMesh("parts"));
    mManager->destroyManualObject(drawn);
    EXPECT_FALSE(isConvex());
}

/// A room: its walls shadow each other where the viewer sees them.
TEST_P(ConvexMeshesTest, AreNotInsideOut) {
    show(makeCube("room"));
    EXPECT_TRUE(isConvex());
    mNode->setScale(-1, 1, 1);
    EXPECT_FALSE(isConvex());
}

TEST_P(ConvexMeshesTest, AreNotDrawnFromInside) {
    Ogre::Entity* const cube = show(makeCube("convex cube"));
    Ogre::MaterialPtr bothSides =
        Ogre::MaterialManager::getSingleton().getByName("BaseWhite")->clone("BothSides");
    bothSides->setCullingMode(Ogre::CULL_NONE);
    cube->setMaterial(bothSides);
    EXPECT_FALSE(isConvex());
    bothSides->setCullingMode(Ogre::CULL_CLOCKWISE);
    EXPECT_TRUE(isConvex());
    Ogre::MaterialManager::getSingleton().remove(bothSides->getHandle());
}

TEST_P(ConvexMeshesTest, AreNotMovedByAVertexProgram) {
    show(makeCube("convex cube"))->setMaterial(flatMaterial(true));
    EXPECT_FALSE(isConvex());
}

TEST_P(ConvexMeshesTest, AreNotRewritten) {
    show(makeCube("rewritten", true));
    EXPECT_FALSE(isConvex());
}

TEST_P(ConvexMeshesTest, AreNotDrawnByHand) {
    Ogre::ManualObject* const drawn = mManager->createManualObject();
    drawn->begin("BaseWhite", Ogre::RenderOperation::OT_TRIANGLE_LIST);
    addBox(*drawn, -Vector3::UNIT_SCALE, Vector3::UNIT_SCALE);
    drawn->end();
    drawn->setCastShadows(true);
    mRootNode->createChildSceneNode(Vector3(0, 0, -20))->attachObject(drawn);
    EXPECT_FALSE(isConvex());
}

TEST_P(ConvexMeshesTest, HaveNoSkeleton) {
    Ogre::SkeletonPtr skeleton =
        Ogre::SkeletonManager::getSingleton().create("bones", Ogre::RGN_DEFAULT, true);
    skeleton->createBone();
    skeleton->setBindingPose();
    const Ogre::MeshPtr mesh = makeCube("boned");
    mesh->_notifySkeleton(skeleton);
    ASSERT_TRUE(show(mesh)->hasSkeleton());
    EXPECT_FALSE(isConvex());
    Ogre::SkeletonManager::getSingleton().remove(skeleton->getHandle());
}

TEST_P(ConvexMeshesTest, DoNotMorph) {
    const Ogre::MeshPtr mesh = makeCube("morphing");
    mesh->createAnimation("swell", 1);
    ASSERT_TRUE(show(mesh)->hasVertexAnimation());
    EXPECT_FALSE(isConvex());
}

/// OGRE's own passes darken the dark side of a body too, where a map says so.
TEST_P(ConvexMeshesTest, AreNotUnderModulativeShadows) {
    show(makeCube("convex cube"));
    mManager->setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_MODULATIVE);
    EXPECT_FALSE(isConvex());
    mManager->setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_MODULATIVE_INTEGRATED);
    EXPECT_TRUE(isConvex());
    mManager->setShadowTechnique(Ogre::SHADOWTYPE_NONE);
}

TEST_P(ConvexMeshesTest, AreReadAnewWithOtherBounds) {
    const Ogre::MeshPtr mesh = makeCube("edited");
    show(mesh);
    EXPECT_TRUE(isConvex());
    // As an application leaves a mesh that it has edited: other buffers, and bounds for them.
    const Ogre::MeshPtr other = make("other", [](auto& drawn) {
        addBox(drawn, Vector3(-3, 0, -1), Vector3(-1, 1, 1));
        addBox(drawn, Vector3(1, 0, -1), Vector3(3, 1, 1));
    });
    Ogre::SubMesh& part = *mesh->getSubMesh(0);
    std::swap(part.vertexData, other->getSubMesh(0)->vertexData);
    std::swap(part.indexData, other->getSubMesh(0)->indexData);
    mesh->_setBounds(other->getBounds(), false);
    EXPECT_FALSE(isConvex());
    Ogre::MeshManager::getSingleton().remove(other->getHandle());
}

namespace {

/// Makes a mesh of boxes each time that it is loaded: one, and then two.
class ReloadedBoxes : public Ogre::ManualResourceLoader {
public:
    void loadResource(Ogre::Resource* resource) override {
        auto* const mesh = static_cast<Ogre::Mesh*>(resource);
        Ogre::SubMesh* const part = mesh->createSubMesh();
        const Ogre::MeshPtr from = makeBoxes(++mLoads);
        part->useSharedVertices = false;
        part->vertexData = from->getSubMesh(0)->vertexData->clone();
        delete part->indexData;
        part->indexData = from->getSubMesh(0)->indexData->clone();
        // The same bounds each time.
        mesh->_setBounds(Ogre::AxisAlignedBox(-1, -1, -1, 1, 1, 1), false);
        Ogre::MeshManager::getSingleton().remove(from->getHandle());
    }
    std::function<Ogre::MeshPtr(int)> makeBoxes;

private:
    int mLoads = 0;
};

} // namespace

TEST_P(ConvexMeshesTest, AreReadAnewWhenTheyAreLoadedAnew) {
    ReloadedBoxes loader;
    loader.makeBoxes = [&](int boxes) {
        return make("boxes", [&](auto& drawn) {
            if (boxes == 1) return addBox(drawn, -Vector3::UNIT_SCALE, Vector3::UNIT_SCALE);
            addBox(drawn, Vector3(-1, -1, -1), Vector3(-0.5f, 1, 1));
            addBox(drawn, Vector3(0.5f, -1, -1), Vector3(1, 1, 1));
        });
    };
    const Ogre::MeshPtr mesh =
        Ogre::MeshManager::getSingleton().createManual("reloaded", Ogre::RGN_DEFAULT, &loader);
    mesh->load();
    show(mesh);
    EXPECT_TRUE(isConvex());
    mesh->reload();
    EXPECT_FALSE(isConvex());
}

} // namespace Lixel::Tests

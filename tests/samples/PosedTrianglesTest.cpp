// Triangles of meshes that bones and morphing bend, blended by OGRE or by a vertex program.

#include "JointedPost.h"
#include "OgreTest.h"
#include "VertexPrograms.h"

#include "common/MeshBuilder.h"
#include "common/Triangles.h"

#include <OgreInstanceManager.h>
#include <OgreInstancedEntity.h>

#include <cmath>

namespace Lixel::Samples {
namespace {

using Eigen::Vector3d;
using Ogre::Vector3;

/// Materials whose programs blend.
constexpr const char* SkinnedByProgram = "skinned-by-program";
constexpr const char* MorphedByProgram = "morphed-by-program";
constexpr const char* PosedByProgram = "posed-by-program";

class PosedTriangles : public OgreTest {
protected:
    PosedTriangles() {
        using Setter = void (Ogre::GpuProgram::*)(bool);
        const auto make = [](const char* name, Setter includes) {
            const Ogre::GpuProgramPtr program = addVertexProgram(
                name, SkinProgram, [&](Ogre::GpuProgram& made) { (made.*includes)(true); });
            addMaterial(name, program->getName());
        };
        make(SkinnedByProgram, &Ogre::GpuProgram::setSkeletalAnimationIncluded);
        make(MorphedByProgram, &Ogre::GpuProgram::setMorphAnimationIncluded);
        addVertexProgram(PosedByProgram, SkinProgram,
                         [](Ogre::GpuProgram& made) { made.setPoseAnimationIncluded(1); });
        addMaterial(PosedByProgram, PosedByProgram);
    }

    Ogre::Entity* addEntity(const Ogre::MeshPtr& mesh, Ogre::SceneNode& node) {
        Ogre::Entity* const entity = scene->createEntity(mesh);
        entity->setMaterialName("BaseWhite");
        node.attachObject(entity);
        return entity;
    }

    /// What is collected of the scene's one entity, blended by OGRE and by a program.
    void expectSameFromProgram(Ogre::Entity& entity, const std::string& material) {
        entity.setMaterialName("BaseWhite");
        ASSERT_FALSE(entity.isHardwareAnimationEnabled());
        const TriangleScene software = collectTriangles(*scene);
        entity.setMaterialName(material);
        ASSERT_TRUE(entity.isHardwareAnimationEnabled());
        const TriangleScene hardware = collectTriangles(*scene);
        EXPECT_EQ(entity.getSoftwareAnimationRequests(), 0);
        ASSERT_EQ(software.positions.size(), hardware.positions.size());
        ASSERT_EQ(software.triangles.size(), hardware.triangles.size());
        for (std::size_t i = 0; i < software.positions.size(); ++i)
            ASSERT_EQ(software.positions[i], hardware.positions[i]) << i;
        for (std::size_t i = 0; i < software.triangles.size(); ++i)
            ASSERT_EQ(software.triangles[i].vertices, hardware.triangles[i].vertices) << i;
    }
};

class SkinnedTriangles : public PosedTriangles, public ::testing::WithParamInterface<bool> {};

TEST_P(SkinnedTriangles, OfAProgramAreThoseOfOgre) {
    Ogre::SceneNode& node = child({5, 6, 7});
    node.setOrientation(Ogre::Quaternion(Ogre::Degree(40), Vector3(1, 2, 3).normalisedCopy()));
    Ogre::Entity& entity = *addEntity(makeJointedPost("post", GetParam()), node);
    Ogre::AnimationState& bend = *entity.getAnimationState("bend");
    bend.setEnabled(true);
    bend.setLoop(false);
    for (const Vector3 scale : {Vector3(1, 1, 1), Vector3(-1, 2, 0.5F)}) {
        node.setScale(scale);
        for (const float time : {0.3F, 1.0F, 0.0F}) {
            SCOPED_TRACE(time);
            bend.setTimePosition(time);
            expectSameFromProgram(entity, SkinnedByProgram);
        }
    }
}

TEST_P(SkinnedTriangles, AreWhereTheBonesAreNow) {
    Ogre::Entity& entity = *addEntity(makeJointedPost("post", GetParam()), child({10, 0, 0}));
    entity.setMaterialName(SkinnedByProgram);
    ASSERT_TRUE(entity.isHardwareAnimationEnabled());
    EXPECT_NEAR(collectTriangles(*scene).box().max().y(), 4.0, 1e-6);
    Ogre::AnimationState& bend = *entity.getAnimationState("bend");
    bend.setEnabled(true);
    bend.setLoop(false);
    // No frame is drawn in between, after which OGRE would forget what it has blended.
    for (const float time : {1.0F, 0.5F}) {
        bend.setTimePosition(time);
        // The head's end, 2 from the joint at (10, 2), turns to the left.
        const double angle = 1.5707963 * static_cast<double>(time);
        const Eigen::AlignedBox3d box = collectTriangles(*scene).box();
        EXPECT_NEAR(box.min().x(), 10.0 - 2.0 * std::sin(angle) - 0.5 * std::cos(angle), 1e-5);
        EXPECT_NEAR(box.max().y(), 2.0 + 2.0 * std::cos(angle) + 0.5 * std::sin(angle), 1e-5);
        EXPECT_NEAR(box.min().y(), 0.0, 1e-6);
    }
    bend.setEnabled(false);
    EXPECT_NEAR(collectTriangles(*scene).box().max().y(), 4.0, 1e-6);
}

TEST_P(SkinnedTriangles, FollowBonesThatAreMovedByHand) {
    Ogre::Entity& entity = *addEntity(makeJointedPost("post", GetParam()), child());
    Ogre::Bone& head = *entity.getSkeleton()->getBone(1);
    head.setManuallyControlled(true);
    for (const float degrees : {90.0F, -90.0F}) {
        head.setOrientation(Ogre::Quaternion(Ogre::Degree(degrees), Vector3::UNIT_Z));
        expectSameFromProgram(entity, SkinnedByProgram);
        const Eigen::AlignedBox3d box = collectTriangles(*scene).box();
        EXPECT_NEAR(degrees > 0 ? -box.min().x() : box.max().x(), 2.0, 1e-5);
    }
}

TEST_P(SkinnedTriangles, CarryWhatIsOnTheirBones) {
    Ogre::Entity& entity = *addEntity(makeJointedPost("post", GetParam()), child());
    entity.setMaterialName(SkinnedByProgram);
    Ogre::AnimationState& bend = *entity.getAnimationState("bend");
    bend.setEnabled(true);
    bend.setLoop(false);
    bend.setTimePosition(1.0F);
    MeshBuilder small;
    small.box(Vector3(-0.1F, 4, -0.1F), Vector3(0.1F, 5, 0.1F));
    entity.attachObjectToBone(entity.getSkeleton()->getBone(1)->getName(),
                              scene->createEntity(small.build("small")));
    EXPECT_NEAR(collectTriangles(*scene).box().min().x(), -5.0, 1e-5);
}

TEST_F(PosedTriangles, OfInstancesAreRefusedWhereTheyHaveBones) {
    makeJointedPost("post", false);
    using Ogre::InstanceManager;
    const auto add = [&](InstanceManager::InstancingTechnique technique) {
        Ogre::InstancedEntity* const instance =
            scene
                ->createInstanceManager(std::to_string(technique), "post", Ogre::RGN_DEFAULT,
                                        technique, 2)
                ->createInstancedEntity("BaseWhite");
        child().attachObject(instance);
        return instance;
    };
    Ogre::InstancedEntity* const bent = add(InstanceManager::HWInstancingVTF);
    EXPECT_THROW(collectTriangles(*scene), Ogre::InvalidParametersException);
    bent->setVisible(false);
    EXPECT_TRUE(collectTriangles(*scene).triangles.empty());
    add(InstanceManager::HWInstancingBasic); // which is stiff
    EXPECT_NEAR(collectTriangles(*scene).box().max().y(), 4.0, 1e-6);
    scene->destroyAllInstanceManagers();
}

INSTANTIATE_TEST_SUITE_P(Vertices, SkinnedTriangles, ::testing::Bool(), [](const auto& instance) {
    return std::string(instance.param ? "Shared" : "Own");
});

/// A second pose in which everything is this much higher.
Ogre::HardwareVertexBufferSharedPtr raisedBuffer(const Ogre::VertexData& data, float by) {
    const Ogre::VertexElement& element =
        *data.vertexDeclaration->findElementBySemantic(Ogre::VES_POSITION);
    const auto buffer = data.vertexBufferBinding->getBuffer(element.getSource());
    const auto raised = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
        buffer->getVertexSize(), data.vertexCount, Ogre::HardwareBuffer::HBU_STATIC, true);
    std::vector<float> floats(buffer->getSizeInBytes() / sizeof(float));
    buffer->readData(0, buffer->getSizeInBytes(), floats.data());
    for (std::size_t i = 1; i < floats.size(); i += buffer->getVertexSize() / sizeof(float))
        floats[i] += by;
    raised->writeData(0, buffer->getSizeInBytes(), floats.data());
    return raised;
}

/// Positions in a buffer of their own, as vertex animation needs them.
void separatePositions(Ogre::SubMesh& part) {
    part.vertexData->reorganiseBuffers(
        part.vertexData->vertexDeclaration->getAutoOrganisedDeclaration(false, true, false));
}

TEST_F(PosedTriangles, MorphedByAProgramAreThoseOfOgre) {
    const Ogre::MeshPtr mesh = makePost("post");
    Ogre::SubMesh& part = *mesh->getSubMesh(0);
    separatePositions(part);
    Ogre::VertexAnimationTrack* const track =
        mesh->createAnimation("rise", 1)->createVertexTrack(1, part.vertexData, Ogre::VAT_MORPH);
    track->createVertexMorphKeyFrame(0)->setVertexBuffer(raisedBuffer(*part.vertexData, 0));
    track->createVertexMorphKeyFrame(1)->setVertexBuffer(raisedBuffer(*part.vertexData, 3));
    Ogre::Entity& entity = *addEntity(mesh, child({0, 10, 0}));
    Ogre::AnimationState& rise = *entity.getAnimationState("rise");
    rise.setLoop(false);
    for (const float time : {0.25F, 1.0F, 0.0F}) {
        rise.setEnabled(true);
        rise.setTimePosition(time);
        entity._updateAnimation(); // as drawing does, which takes note of the change
        expectSameFromProgram(entity, MorphedByProgram);
        EXPECT_NEAR(collectTriangles(*scene).box().min().y(),
                    10.0 + 3.0 * static_cast<double>(time), 1e-5);
    }
    for (const float time : {0.5F, 0.75F}) {
        rise.setTimePosition(time);
        entity._updateAnimation(); // by the program now, beside what OGRE blended before
        EXPECT_NEAR(collectTriangles(*scene).box().min().y(),
                    10.0 + 3.0 * static_cast<double>(time), 1e-5);
    }
    rise.setEnabled(false);
    expectSameFromProgram(entity, MorphedByProgram);
}

TEST_F(PosedTriangles, OfPosesInAProgramAreRefused) {
    const Ogre::MeshPtr mesh = makePost("post");
    Ogre::SubMesh& part = *mesh->getSubMesh(0);
    separatePositions(part);
    Ogre::Pose* const pose = mesh->createPose(1, "pose");
    for (unsigned vertex = 0; vertex < part.vertexData->vertexCount; ++vertex)
        pose->addVertex(vertex, Vector3(0, 2, 0));
    mesh->createAnimation("posed", 1)
        ->createVertexTrack(1, part.vertexData, Ogre::VAT_POSE)
        ->createVertexPoseKeyFrame(0)
        ->addPoseReference(0, 1);
    Ogre::Entity& entity = *addEntity(mesh, child());
    entity.getAnimationState("posed")->setEnabled(true);
    EXPECT_NEAR(collectTriangles(*scene).box().min().y(), 2.0, 1e-6);
    entity.setMaterialName(PosedByProgram);
    ASSERT_TRUE(entity.isHardwareAnimationEnabled());
    EXPECT_THROW(collectTriangles(*scene), Ogre::InvalidParametersException);
    EXPECT_EQ(entity.getSoftwareAnimationRequests(), 0);
}

} // namespace
} // namespace Lixel::Samples

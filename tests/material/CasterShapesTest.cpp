// Casters that OGRE itself bends or mirrors: under Lixel's surfaces they need nothing, and are
// shadowed and cast as they are drawn.

#include "TestStage.h"

#include "common/MeshBuilder.h"

#include <OgrePose.h>

namespace Lixel::Tests {
namespace {

using Ogre::Vector3;

/// An L: a post with an arm along +x, at its upper end.
Ogre::MeshPtr makeArm() {
    Samples::MeshBuilder arm;
    arm.box(Vector3(-0.4F, 0, -0.4F), Vector3(0.4F, 3, 0.4F));
    arm.box(Vector3(0.4F, 2.2F, -0.4F), Vector3(2.4F, 3, 0.4F));
    return arm.build("arm");
}

/// Positions in a buffer of their own, as vertex animation needs them.
void separatePositions(Ogre::VertexData& vertices) {
    vertices.reorganiseBuffers(
        vertices.vertexDeclaration->getAutoOrganisedDeclaration(false, true, false));
}

/// An animation of a second, at whose end all is moved.
void addPose(Ogre::Mesh& mesh, const Vector3& offset) {
    constexpr unsigned short FirstPart = 1;
    Ogre::Pose& pose = *mesh.createPose(FirstPart, "moved");
    for (unsigned i = 0; i < mesh.getSubMesh(0)->vertexData->vertexCount; ++i)
        pose.addVertex(i, offset);
    Ogre::VertexAnimationTrack& track =
        *mesh.createAnimation("move", 1)->createVertexTrack(FirstPart, Ogre::VAT_POSE);
    track.createVertexPoseKeyFrame(0)->addPoseReference(0, 0);
    track.createVertexPoseKeyFrame(1)->addPoseReference(0, 1);
}

/// The same by two sets of positions.
void addMorph(Ogre::Mesh& mesh, const Vector3& offset) {
    constexpr unsigned short FirstPart = 1;
    Ogre::VertexAnimationTrack& track =
        *mesh.createAnimation("move", 1)->createVertexTrack(FirstPart, Ogre::VAT_MORPH);
    const Ogre::VertexData& vertices = *mesh.getSubMesh(0)->vertexData;
    const auto rest = vertices.vertexBufferBinding->getBuffer(
        vertices.vertexDeclaration->findElementBySemantic(Ogre::VES_POSITION)->getSource());
    std::vector<Vector3> positions(vertices.vertexCount);
    rest->readData(0, rest->getSizeInBytes(), positions.data());
    for (const float time : {0.0F, 1.0F}) {
        const auto buffer = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
            rest->getVertexSize(), rest->getNumVertices(), Ogre::HardwareBuffer::HBU_STATIC, true);
        if (time > 0)
            for (Vector3& position : positions)
                position += offset;
        buffer->writeData(0, buffer->getSizeInBytes(), positions.data());
        track.createVertexMorphKeyFrame(time)->setVertexBuffer(buffer);
    }
}

enum class Shape { Mirrored, Posed, Morphed };

class CasterShapes : public testing::TestWithParam<Shape> {
protected:
    CasterShapes() {
        scene.box->setVisible(false);
        scene.stage.setShadowMapSize(2048);
        const Ogre::MeshPtr mesh = makeArm();
        if (GetParam() != Shape::Mirrored) separatePositions(*mesh->getSubMesh(0)->vertexData);
        const Vector3 aside(1, 0, 2);
        // OGRE does not widen a mesh's bounds by its animations.
        mesh->_setBounds(Ogre::AxisAlignedBox(-0.4F, 0, -0.4F, 3.4F, 3, 2.4F));
        if (GetParam() == Shape::Posed) addPose(*mesh, aside);
        if (GetParam() == Shape::Morphed) addMorph(*mesh, aside);
        auto& manager = scene.stage.sceneManager();
        Ogre::Entity& arm = *manager.createEntity(mesh);
        arm.setMaterialName("Lixel/Surface");
        node = manager.getRootSceneNode()->createChildSceneNode();
        node->attachObject(&arm);
        if (GetParam() == Shape::Mirrored) return;
        Ogre::AnimationState& state = *arm.getAnimationState("move");
        state.setEnabled(true);
        state.setLoop(false);
        mState = &state;
    }

    void change() {
        if (mState != nullptr)
            mState->setTimePosition(1);
        else
            node->setScale(-1, 1, 1);
    }

    BoxOnGround scene;
    Ogre::SceneNode* node = nullptr;

private:
    Ogre::AnimationState* mState = nullptr;
};

TEST_P(CasterShapes, CastTheShadowOfWhatIsDrawn) {
    scene.stage.drawFrame();
    const std::vector<std::uint8_t> before = scene.stage.drawVisibility();
    change();
    scene.stage.drawFrame();
    const Samples::ClassificationError error = scene.nextFrameError();
    EXPECT_GT(error.shadowed, 300U) << "pixels";
    EXPECT_LT(error.error, 0.2) << "percent";
    const std::vector<std::uint8_t> after = scene.stage.drawVisibility();
    std::size_t changed = 0;
    for (std::size_t i = 0; i < after.size(); ++i)
        changed += after[i] != before[i] ? 1 : 0;
    EXPECT_GT(changed, 500U) << "pixels: nothing was tested";
}

INSTANTIATE_TEST_SUITE_P(Kinds, CasterShapes,
                         testing::Values(Shape::Mirrored, Shape::Posed, Shape::Morphed),
                         [](const testing::TestParamInfo<Shape>& shape) {
                             switch (shape.param) {
                             case Shape::Mirrored:
                                 return "Mirrored";
                             case Shape::Posed:
                                 return "Posed";
                             case Shape::Morphed:
                                 break;
                             }
                             return "Morphed";
                         });

} // namespace
} // namespace Lixel::Tests

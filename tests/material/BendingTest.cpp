// What the log says where a surface's own program bends it and its caster or receiver does not.

#include "MaterialScene.h"

namespace Lixel::Tests {
namespace {

/// A cube with one bone, beside the box.
class Bending : public testing::Test {
protected:
    Bending() {
        auto& skeletons = Ogre::SkeletonManager::getSingleton();
        Ogre::SkeletonPtr skeleton = skeletons.create("bending", Ogre::RGN_DEFAULT, true);
        skeleton->load(); // or OGRE would not free its bones
        skeleton->createBone("bone");
        skeleton->setBindingPose();
        Ogre::SceneNode* const node = scene.addCube(Ogre::Vector3(4, 1, 0), Ogre::Vector3(1));
        auto* const cube =
            static_cast<Ogre::Entity*>(node->detachObject(static_cast<unsigned short>(0)));
        const Ogre::MeshPtr mesh = cube->getMesh()->clone("bending");
        mesh->_notifySkeleton(skeleton);
        Ogre::SubMesh& part = *mesh->getSubMesh(0);
        const std::size_t vertices =
            (part.useSharedVertices ? mesh->sharedVertexData : part.vertexData)->vertexCount;
        for (unsigned vertex = 0; vertex < vertices; ++vertex)
            if (part.useSharedVertices)
                mesh->addBoneAssignment({vertex, 0, 1});
            else
                part.addBoneAssignment({vertex, 0, 1});
        mBody = scene.stage.sceneManager().createEntity("bending");
        node->attachObject(mBody);
    }

    std::string drawn(const std::string& material) {
        LogCollector log;
        mBody->setMaterialName(material);
        scene.draw();
        scene.draw();
        return log.all();
    }

    MaterialScene scene{Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver"};
    Ogre::Entity* mBody = nullptr;
};

TEST_F(Bending, LeftToTheSurfaceAloneIsNamedForCasterAndReceiver) {
    LogCollector log;
    drawn("Test/Bent");
    EXPECT_EQ(log.count("what wears material 'Test/Bent' is bent by its vertex program, and shadow "
                        "caster material 'Lixel/Caster' does not bend it"),
              1U)
        << log.all();
    EXPECT_EQ(log.count("shadow receiver material 'Lixel/Receiver' does not bend it"), 1U)
        << log.all();
    EXPECT_EQ(log.count("Lixel:"), 2U) << log.all();
}

TEST_F(Bending, OfAllProgramsIsNoNews) {
    EXPECT_EQ(drawn("Test/BentInAll"), "");
}

TEST_F(Bending, ByOgreIsNoNews) {
    EXPECT_EQ(drawn("Lixel/Surface"), "");
}

} // namespace
} // namespace Lixel::Tests

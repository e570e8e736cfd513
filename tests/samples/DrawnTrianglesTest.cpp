// The truth's triangles against what OGRE draws of the same objects.

#include "JointedPost.h"
#include "TestStage.h"
#include "VertexPrograms.h"

#include "common/MeshBuilder.h"
#include "common/OracleView.h"

#include <OgreInstanceManager.h>
#include <OgreInstancedEntity.h>

namespace Lixel::Samples {
namespace {

using Ogre::Vector3;

/// White objects on black, without shadows.
class DrawnSilhouette : public ::testing::Test {
protected:
    DrawnSilhouette() {
        scene.box->setVisible(false);
        scene.ground->setVisible(false);
        manager().setShadowTechnique(Ogre::SHADOWTYPE_NONE);
    }

    Ogre::SceneManager& manager() { return scene.stage.sceneManager(); }
    Ogre::SceneNode& child(const Vector3& position) {
        return *manager().getRootSceneNode()->createChildSceneNode(position);
    }

    /// Draws what is collected, and counts pixels that are drawn and collected, or one of both.
    void expectDrawnAsCollected() {
        const ShadowOracle oracle(collectTriangles(manager()));
        const auto width = static_cast<int>(scene.stage.window().getWidth());
        const auto height = static_cast<int>(scene.stage.window().getHeight());
        const VisiblePoints points =
            oracle.visiblePoints(oracleView(scene.stage.camera(), width, height, 0.0));
        scene.stage.drawFrame();
        const std::vector<std::uint8_t> picture = scene.stage.picture();
        int both = 0;
        int one = 0;
        for (std::size_t i = 0; i < points.pixels.size(); ++i) {
            const bool drawn = picture[3 * i] > 127;
            both += drawn && points.pixels[i] ? 1 : 0;
            one += drawn != points.pixels[i].has_value() ? 1 : 0;
        }
        EXPECT_GT(both, 1000);
        EXPECT_LT(one, 10) << "beside " << both << " pixels that agree";
    }

    Tests::BoxOnGround scene;
};

TEST_F(DrawnSilhouette, OfASkinThatAProgramBendsIsTheTruths) {
    addMaterial("skin", addVertexProgram("skin", SkinProgram, [](Ogre::GpuProgram& program) {
                            program.setSkeletalAnimationIncluded(true);
                        })->getName());
    makeJointedPost("post", false);
    Ogre::Entity* const entity = manager().createEntity("post");
    entity->setMaterialName("skin");
    Ogre::SceneNode& node = child({1, -1, 8});
    node.yaw(Ogre::Degree(20));
    node.attachObject(entity);
    Ogre::AnimationState& bend = *entity->getAnimationState("bend");
    bend.setEnabled(true);
    for (const float time : {0.4F, 0.8F}) {
        bend.setTimePosition(time);
        expectDrawnAsCollected();
    }
    EXPECT_TRUE(entity->isHardwareAnimationEnabled()) << "OGRE bends it: nothing was tested";
    bend.setEnabled(false);
    expectDrawnAsCollected();
}

TEST_F(DrawnSilhouette, OfInstancesIsTheTruths) {
    addMaterial("instanced",
                addVertexProgram("instance", InstanceProgram, [](Ogre::GpuProgram&) {})->getName());
    MeshBuilder builder;
    builder.cone(1, 0, 2);
    builder.build("cone");
    Ogre::InstanceManager* const instances = manager().createInstanceManager(
        "instances", "cone", Ogre::RGN_DEFAULT, Ogre::InstanceManager::HWInstancingBasic, 2);
    for (int i = 0; i < 5; ++i) {
        Ogre::SceneNode& node = child({static_cast<float>(2 * i - 4), 0, static_cast<float>(i)});
        node.roll(Ogre::Degree(static_cast<float>(50 * i)));
        node.setScale(1, 1.5F, i == 3 ? -0.5F : 0.5F);
        node.attachObject(instances->createInstancedEntity("instanced"));
    }
    expectDrawnAsCollected();
    manager().destroyInstanceManager(instances);
}

} // namespace
} // namespace Lixel::Samples

// Instances: lit, shadowed, and casting shadows.

#include "PlacedScene.h"

namespace Lixel::Tests {
namespace {

/// OGRE puts matrices after the mesh's own texture coordinates, however many sets there are.
TEST_F(ShaderSystemPlaced, InstancesWithTwoTextureCoordinatesCastShadows) {
    scene.manager().setShadowTextureSettings(2048, 4, Ogre::PF_FLOAT32_R);
    makePost(2);
    Ogre::SceneNode& node =
        *scene.manager().getRootSceneNode()->createChildSceneNode(Ogre::Vector3(-1, 0, 4));
    Ogre::Entity& post = *scene.manager().createEntity("post", "post");
    node.attachObject(&post);
    scene.draw();
    const Picture reference = scene.draw();
    scene.manager().destroyEntity(&post);
    EXPECT_TRUE(isOther(scene.draw(), reference));

    instanceFrom(2);
    Ogre::InstanceManager& instances = *scene.manager().createInstanceManager(
        "posts", "post", Ogre::ResourceGroupManager::AUTODETECT_RESOURCE_GROUP_NAME,
        Ogre::InstanceManager::HWInstancingBasic, 8);
    node.attachObject(instances.createInstancedEntity("Test/Instanced"));
    LogCollector log;
    scene.draw();
    const Picture drawn = scene.draw();
    scene.keepPicture("instances-two-texture-coordinates");
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
    // Maps are fitted to the batch as a whole, so their texels are others, and so are edges.
    EXPECT_LT(differenceOf(drawn, reference).percent, 0.3);
    instances.setSetting(Ogre::InstanceManager::CAST_SHADOWS, false);
    EXPECT_GT(differenceOf(drawn, scene.draw()).percent, 0.5) << "its shadow";
}

TEST_F(ShaderSystemPlaced, InstancesReceiveAndCastShadows) {
    scene.manager().setShadowTextureSettings(2048, 4, Ogre::PF_FLOAT32_R);
    const Ogre::Vector3 places[] = {{-6, 0.5F, -2}, {-3, 0.5F, -4}, {2, 0.5F, 5}, {4, 2.5F, 3}};
    const auto turned = [](int i) {
        return Ogre::Quaternion(Ogre::Degree(static_cast<float>(25 * i)), Ogre::Vector3::UNIT_Y);
    };
    std::vector<Ogre::SceneNode*> nodes;
    int count = 0;
    for (const Ogre::Vector3& place : places) {
        nodes.push_back(scene.addCube(place, Ogre::Vector3(1, 1, 2)));
        nodes.back()->setOrientation(turned(count++));
    }
    scene.wear(ShaderSystemScene::Plain);
    const Picture reference = scene.draw();
    scene.keepPicture("instances-reference");
    const Ogre::String mesh =
        static_cast<Ogre::Entity*>(nodes[0]->getAttachedObject(0))->getMesh()->getName();
    for (Ogre::SceneNode* node : nodes) {
        scene.manager().destroyEntity(static_cast<Ogre::Entity*>(node->getAttachedObject(0)));
        node->setScale(Ogre::Vector3(1, 1, 2) / 100);
    }
    EXPECT_TRUE(isOther(scene.draw(), reference));

    instanceFrom(1);
    Ogre::InstanceManager& instances = *scene.manager().createInstanceManager(
        "cubes", mesh, Ogre::ResourceGroupManager::AUTODETECT_RESOURCE_GROUP_NAME,
        Ogre::InstanceManager::HWInstancingBasic, 8);
    for (Ogre::SceneNode* node : nodes)
        node->attachObject(instances.createInstancedEntity("Test/Instanced"));
    LogCollector log;
    scene.draw();
    const Picture drawn = scene.draw();
    scene.keepPicture("instances");
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
    // Maps are fitted to the batch as a whole, so their texels are others, and so are edges.
    EXPECT_LT(differenceOf(drawn, reference).percent, 0.3);
    instances.setSetting(Ogre::InstanceManager::CAST_SHADOWS, false);
    EXPECT_GT(differenceOf(drawn, scene.draw()).percent, 1.5) << "their shadows";
}

} // namespace
} // namespace Lixel::Tests

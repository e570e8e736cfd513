// What vertex programs bend by bones, and instances: lit, shadowed, and casting shadows.

#include "ShaderSystemScene.h"

namespace Lixel::Tests {
namespace {

class ShaderSystemPlaced : public testing::Test {
protected:
    ShaderSystemPlaced() {
        scene.addSun();
        scene.addSpot();
        scene.setMaps(3, 1, 0);
        Lixel::ShaderSystem::enable(generator());
    }

    Ogre::RTShader::ShaderGenerator& generator() { return scene.shaderSystem.generator; }

    /// A post of many pieces, 4 high, whose upper end two bones bend.
    Ogre::Entity& addPost(int weights) {
        Ogre::ManualObject post("post");
        post.begin(ShaderSystemScene::Plain, Ogre::RenderOperation::OT_TRIANGLE_LIST);
        constexpr unsigned Rings = 17;
        const Ogre::Vector3 sides[] = {{1, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, -1}};
        for (unsigned side = 0; side < 4; ++side)
            for (unsigned ring = 0; ring < Rings; ++ring)
                for (const float across : {-0.4F, 0.4F}) {
                    const Ogre::Vector3& out = sides[side];
                    post.position(out * 0.4F + Ogre::Vector3(-out.z, 0, out.x) * across +
                                  Ogre::Vector3(0, 0.25F * static_cast<float>(ring), 0));
                    post.normal(out);
                }
        for (unsigned side = 0; side < 4; ++side)
            for (unsigned ring = 0; ring + 1 < Rings; ++ring) {
                const unsigned first = 2 * (side * Rings + ring);
                post.triangle(first, first + 2, first + 1);
                post.triangle(first + 1, first + 2, first + 3);
            }
        post.end();
        const Ogre::MeshPtr mesh = post.convertToMesh("post", Ogre::RGN_DEFAULT);
        Ogre::SkeletonPtr skeleton =
            Ogre::SkeletonManager::getSingleton().create("post", Ogre::RGN_DEFAULT, true);
        skeleton->load();
        Ogre::Bone* const foot = skeleton->createBone("foot", 0);
        foot->createChild(1, Ogre::Vector3(0, 2, 0));
        skeleton->setBindingPose();
        mesh->_notifySkeleton(skeleton);
        Ogre::SubMesh& part = *mesh->getSubMesh(0);
        for (unsigned vertex = 0; vertex < part.vertexData->vertexCount; ++vertex) {
            const float height = 0.25F * static_cast<float>(vertex / 2 % Rings);
            const float bent = std::clamp((height - 1) / 2, 0.0F, 1.0F);
            if (weights == 1) {
                part.addBoneAssignment({vertex, static_cast<unsigned short>(bent > 0.5F), 1});
                continue;
            }
            part.addBoneAssignment({vertex, 0, 1 - bent});
            part.addBoneAssignment({vertex, 1, bent});
        }
        mesh->_setBounds(Ogre::AxisAlignedBox(-4, 0, -4, 4, 4, 4));
        Ogre::Entity& entity = *scene.manager().createEntity("post", "post");
        scene.manager()
            .getRootSceneNode()
            ->createChildSceneNode(Ogre::Vector3(-1, 0, 4))
            ->attachObject(&entity);
        Ogre::Bone* const head = entity.getSkeleton()->getBone(1);
        head->setManuallyControlled(true);
        head->rotate(Ogre::Vector3::UNIT_Z, Ogre::Degree(60));
        return entity;
    }

    /// In the shader system's scheme; in others OGRE bends it.
    static bool isBentByProgram(Ogre::Entity& entity) {
        auto& materials = Ogre::MaterialManager::getSingleton();
        const Ogre::String own = materials.getActiveScheme();
        materials.setActiveScheme(StartedShaderSystem::Scheme);
        const bool bent = entity.isHardwareAnimationEnabled();
        materials.setActiveScheme(own);
        return bent;
    }

    ShaderSystemScene scene;
};

class ShaderSystemSkins : public ShaderSystemPlaced, public testing::WithParamInterface<int> {};

/// Against OGRE, which bends it before it is drawn where programs do not say that they do.
TEST_P(ShaderSystemSkins, ThatProgramsBendReceiveAndCastShadows) {
    Ogre::Entity& post = addPost(GetParam());
    const Picture straight = scene.draw();
    auto& schemeState = *generator().getRenderState(StartedShaderSystem::Scheme);
    schemeState.addTemplateSubRenderState(generator().createSubRenderState("SGX_HardwareSkinning"));
    Ogre::MaterialManager::getSingleton().create("Test/Skin", Ogre::RGN_DEFAULT);
    post.setMaterialName("Test/Skin");
    Ogre::RTShader::HardwareSkinningFactory::getSingleton().prepareEntityForSkinning(&post);
    generator().invalidateScheme(StartedShaderSystem::Scheme);
    LogCollector log;
    scene.draw();
    const Picture bent = scene.draw();
    scene.keepPicture("skinned-" + std::to_string(GetParam()));
    EXPECT_TRUE(isBentByProgram(post)) << "OGRE bends it: nothing was tested";
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
    const Picture reference = scene.drawLixels();
    scene.keepPicture("skinned-reference-" + std::to_string(GetParam()));
    EXPECT_TRUE(isSame(bent, reference));
}

INSTANTIATE_TEST_SUITE_P(Weights, ShaderSystemSkins, testing::Values(1, 2));

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

    ShaderSystemScene::parse("material Test/Instanced { technique { pass { rtshader_system { "
                             "transform_stage instanced } } } }");
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

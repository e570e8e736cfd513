// What vertex programs bend by bones, and instances: lit, shadowed, and casting shadows.

#include "ShaderSystemScene.h"

#include <array>

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

    /// A post of many pieces, 4 high, with this many sets of texture coordinates.
    static Ogre::MeshPtr makePost(int uvSets = 1) {
        Ogre::ManualObject post("post");
        post.begin(ShaderSystemScene::Plain, Ogre::RenderOperation::OT_TRIANGLE_LIST);
        const Ogre::Vector3 sides[] = {{1, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, -1}};
        for (unsigned side = 0; side < 4; ++side)
            for (unsigned ring = 0; ring < Rings; ++ring)
                for (const float across : {-0.4F, 0.4F}) {
                    const Ogre::Vector3& out = sides[side];
                    const float height = 0.25F * static_cast<float>(ring);
                    post.position(out * 0.4F + Ogre::Vector3(-out.z, 0, out.x) * across +
                                  Ogre::Vector3(0, height, 0));
                    post.normal(out);
                    for (int set = 0; set < uvSets; ++set)
                        post.textureCoord(across + 0.5F, height / 4);
                }
        for (unsigned side = 0; side < 4; ++side)
            for (unsigned ring = 0; ring + 1 < Rings; ++ring) {
                const unsigned first = 2 * (side * Rings + ring);
                post.triangle(first, first + 2, first + 1);
                post.triangle(first + 1, first + 2, first + 3);
            }
        post.end();
        return post.convertToMesh("post", Ogre::RGN_DEFAULT);
    }

    /// A post whose upper end is bent. Four weights are those of two bones and of two that follow
    /// the first.
    Ogre::Entity& addPost(int weights) {
        const Ogre::MeshPtr mesh = makePost();
        Ogre::SkeletonPtr skeleton =
            Ogre::SkeletonManager::getSingleton().create("post", Ogre::RGN_DEFAULT, true);
        skeleton->load();
        Ogre::Bone* const foot = skeleton->createBone("foot", 0);
        for (unsigned short handle = 1; handle < 4; ++handle) {
            Ogre::Bone* const child = skeleton->createBone(std::to_string(handle), handle);
            foot->addChild(child);
            child->setPosition(0, 2, 0);
        }
        skeleton->setBindingPose();
        mesh->_notifySkeleton(skeleton);
        Ogre::SubMesh& part = *mesh->getSubMesh(0);
        // Where OGRE bends it, it replaces whole buffers: texture coordinates need one of their own.
        Ogre::VertexData& vertices = *part.vertexData;
        vertices.reorganiseBuffers(
            vertices.vertexDeclaration->getAutoOrganisedDeclaration(true, false, false));
        for (unsigned vertex = 0; vertex < part.vertexData->vertexCount; ++vertex) {
            const float height = 0.25F * static_cast<float>(vertex / 2 % Rings);
            const float bent = std::clamp((height - 1) / 2, 0.0F, 1.0F);
            const std::array<float, 4> all =
                weights == 1
                    ? std::array{bent > 0.5F ? 0.0F : 1.0F, bent > 0.5F ? 1.0F : 0.0F, 0.0F, 0.0F}
                : weights == 2
                    ? std::array{1 - bent, bent, 0.0F, 0.0F}
                    : std::array{0.7F * (1 - bent), bent, 0.2F * (1 - bent), 0.1F * (1 - bent)};
            for (unsigned short bone = 0; bone < all.size(); ++bone)
                if (all[bone] > 0 || (bone < weights && weights > 1))
                    part.addBoneAssignment({vertex, bone, all[bone]});
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

    /// Has programs bend it from now on, in a material that nothing else wears.
    void skin(Ogre::Entity& entity, const std::string& material) {
        auto& schemeState = *generator().getRenderState(StartedShaderSystem::Scheme);
        schemeState.addTemplateSubRenderState(
            generator().createSubRenderState("SGX_HardwareSkinning"));
        entity.setMaterialName(material);
        Ogre::RTShader::HardwareSkinningFactory::getSingleton().prepareEntityForSkinning(&entity);
        generator().invalidateScheme(StartedShaderSystem::Scheme);
    }

    /// Adds a material for instances whose matrices begin at this set of texture coordinates.
    void instanceFrom(int set) {
        const auto material =
            Ogre::MaterialManager::getSingleton().create("Test/Instanced", Ogre::RGN_DEFAULT);
        generator().createShaderBasedTechnique(material->getTechnique(0),
                                               StartedShaderSystem::Scheme);
        auto& state = *generator().getRenderState(StartedShaderSystem::Scheme, "Test/Instanced",
                                                  Ogre::RGN_DEFAULT, 0);
        Ogre::RTShader::SubRenderState* const transform =
            generator().createSubRenderState("FFP_Transform");
#if OGRE_VERSION_MAJOR >= 14
        transform->setParameter("instanced", std::to_string(set));
#else
        // Its script keyword takes no number in 1.12.
        static_cast<Ogre::RTShader::FFPTransform*>(transform)->setInstancingParams(true, set);
#endif
        state.addTemplateSubRenderState(transform);
    }

    /// An alpha-tested material, seen from both sides, whose texture has these rows of alpha.
    static void addHoles(const std::string& name, const std::vector<std::uint8_t>& alphas) {
        std::vector<std::uint8_t> texels;
        for (const std::uint8_t alpha : alphas)
            for (std::size_t column = 0; column < alphas.size(); ++column)
                texels.insert(texels.end(), {255, 255, 255, alpha});
        ShaderSystemScene::addTexture(name, texels);
        const auto material = Ogre::MaterialManager::getSingleton().create(name, Ogre::RGN_DEFAULT);
        Ogre::Pass& pass = *material->getTechnique(0)->getPass(0);
        pass.setAlphaRejectSettings(Ogre::CMPF_GREATER, 128);
        pass.setCullingMode(Ogre::CULL_NONE);
        pass.createTextureUnitState(name)->setTextureFiltering(Ogre::TFO_NONE);
    }

    static constexpr unsigned Rings = 17;

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

/// Reference: software skinning.
TEST_P(ShaderSystemSkins, ThatProgramsBendReceiveAndCastShadows) {
    Ogre::Entity& post = addPost(GetParam());
    Ogre::MaterialManager::getSingleton().create("Test/Skin", Ogre::RGN_DEFAULT);
    skin(post, "Test/Skin");
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

INSTANTIATE_TEST_SUITE_P(Weights, ShaderSystemSkins, testing::Values(1, 2, 4));

/// OGRE lends Lixel/Caster the textures of one object after the other.
TEST_F(ShaderSystemPlaced, SkinsCastWholeShadowsAfterAlphaTestedCasters) {
    addHoles("Test/Nothing", {0, 0}); // Lixel/Caster reads no texture of one texel
    for (const auto& [name, object] : scene.manager().getMovableObjects("Entity"))
        if (object->getCastShadows())
            static_cast<Ogre::Entity*>(object)->setMaterialName("Test/Nothing");
    Ogre::Entity& post = addPost(2);
    scene.draw();
    const Picture reference = scene.draw();
    scene.keepPicture("skinned-after-alpha-tested-reference");
    post.setCastShadows(false);
    EXPECT_TRUE(isOther(scene.draw(), reference)) << "its shadow";
    const auto& last = *Ogre::MaterialManager::getSingleton().getByName("Lixel/Caster");
    ASSERT_GT(last.getTechnique(0)->getPass(0)->getNumTextureUnitStates(), 0U);
    Ogre::MaterialManager::getSingleton().create("Test/Skin", Ogre::RGN_DEFAULT);
    skin(post, "Test/Skin");
    scene.draw();
    post.setCastShadows(true);
    scene.draw();
    const Picture drawn = scene.draw();
    scene.keepPicture("skinned-after-alpha-tested");
    EXPECT_TRUE(isBentByProgram(post)) << "OGRE bends it: nothing was tested";
    EXPECT_TRUE(isSame(drawn, reference));
}

/// Reference: software skinning, for which OGRE lends Lixel/Caster the texture and the culling.
TEST_F(ShaderSystemPlaced, AlphaTestedSkinsCastShadowsWithHoles) {
    const std::vector<std::uint8_t> stripes{0, 255, 255, 0, 255, 0, 0, 255};
    Ogre::Entity& post = addPost(2);
    scene.draw();
    const Picture whole = scene.draw();
    addHoles("Test/Striped", stripes);
    post.setMaterialName("Test/Striped");
    scene.draw();
    const Picture reference = scene.draw();
    scene.keepPicture("skinned-alpha-tested-reference");
    EXPECT_TRUE(isOther(reference, whole));
    addHoles("Test/StripedSkin", stripes);
    skin(post, "Test/StripedSkin");
    LogCollector log;
    scene.draw();
    const Picture drawn = scene.draw();
    scene.keepPicture("skinned-alpha-tested");
    EXPECT_TRUE(isBentByProgram(post)) << "OGRE bends it: nothing was tested";
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
    // Where a stripe ends, a pixel may be on either side.
    EXPECT_LT(differenceOf(drawn, reference).percent, 0.02);
}

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

#include "PlacedScene.h"

#include <algorithm>
#include <array>

namespace Lixel::Tests {
namespace {

constexpr unsigned Rings = 17;

} // namespace

ShaderSystemPlaced::ShaderSystemPlaced() {
    scene.addSun();
    scene.addSpot();
    scene.setMaps(3, 1, 0);
    Lixel::ShaderSystem::enable(generator());
}

Ogre::MeshPtr ShaderSystemPlaced::makePost(int uvSets) {
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

Ogre::Entity& ShaderSystemPlaced::addPost(int weights) {
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

void ShaderSystemPlaced::skin(Ogre::Entity& entity, const std::string& material,
                              Ogre::RTShader::SkinningType type, bool antipodal, bool scales) {
    auto& schemeState = *generator().getRenderState(StartedShaderSystem::Scheme);
    schemeState.addTemplateSubRenderState(generator().createSubRenderState("SGX_HardwareSkinning"));
    entity.setMaterialName(material);
    Ogre::RTShader::HardwareSkinningFactory::getSingleton().prepareEntityForSkinning(
        &entity, type, antipodal, scales);
    generator().invalidateScheme(StartedShaderSystem::Scheme);
}

void ShaderSystemPlaced::instanceFrom(int set) {
    const auto material =
        Ogre::MaterialManager::getSingleton().create("Test/Instanced", Ogre::RGN_DEFAULT);
    generator().createShaderBasedTechnique(material->getTechnique(0), StartedShaderSystem::Scheme);
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

void ShaderSystemPlaced::addHoles(const std::string& name,
                                  const std::vector<std::uint8_t>& alphas) {
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

bool ShaderSystemPlaced::isBentByProgram(Ogre::Entity& entity) {
    auto& materials = Ogre::MaterialManager::getSingleton();
    const Ogre::String own = materials.getActiveScheme();
    materials.setActiveScheme(StartedShaderSystem::Scheme);
    const bool bent = entity.isHardwareAnimationEnabled();
    materials.setActiveScheme(own);
    return bent;
}

} // namespace Lixel::Tests

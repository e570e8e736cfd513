// What vertex programs bend by dual quaternions, which OGRE itself does not do on the CPU.

#include "PlacedScene.h"

#include <OgreDualQuaternion.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace Lixel::Tests {
namespace {

using Quaternion8 = std::array<float, 8>; ///< (w, x, y, z) of the turn, then of the shift

Quaternion8 quaternionOf(const Ogre::Affine3& bone) {
    Ogre::DualQuaternion q;
    q.fromTransformationMatrix(bone);
    return {q.w, q.x, q.y, q.z, q.dw, q.dx, q.dy, q.dz};
}

/// The transform of a vertex (Kavan et al. 2008, algorithm 1).
Ogre::Affine3 blend(const std::vector<std::pair<float, Quaternion8>>& weighted, bool antipodal) {
    Quaternion8 sum{};
    const Quaternion8& first = weighted.front().second;
    for (const auto& [weight, q] : weighted) {
        float cosine = 0;
        for (std::size_t i = 0; i < 4; ++i)
            cosine += first[i] * q[i];
        const float sign = antipodal && cosine < 0 ? -1.0F : 1.0F;
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += sign * weight * q[i];
    }
    const Ogre::Quaternion turn(sum[0], sum[1], sum[2], sum[3]);
    const float length = turn.Norm();
    Ogre::DualQuaternion blended;
    blended =
        Ogre::DualQuaternion(sum[0] / length, sum[1] / length, sum[2] / length, sum[3] / length,
                             sum[4] / length, sum[5] / length, sum[6] / length, sum[7] / length);
    Ogre::Affine3 matrix;
    blended.toTransformationMatrix(matrix);
    return matrix;
}

/// Transforms one element of each vertex.
void transform(Ogre::VertexData& vertices, Ogre::VertexElementSemantic semantic,
               const std::function<Ogre::Vector3(std::size_t, const Ogre::Vector3&)>& moved) {
    const Ogre::VertexElement& element =
        *vertices.vertexDeclaration->findElementBySemantic(semantic);
    const auto buffer = vertices.vertexBufferBinding->getBuffer(element.getSource());
    auto* bytes = static_cast<unsigned char*>(buffer->lock(Ogre::HardwareBuffer::HBL_NORMAL));
    for (std::size_t i = 0; i < vertices.vertexCount; ++i, bytes += buffer->getVertexSize()) {
        float* at = nullptr;
        element.baseVertexPointerToElement(bytes, &at);
        const Ogre::Vector3 to = moved(i, Ogre::Vector3(at));
        std::copy(to.ptr(), to.ptr() + 3, at);
    }
    buffer->unlock();
}

struct Skinning {
    const char* name;
    bool antipodal;
    bool scales;
    float footDegrees;
    float headDegrees;
};

class QuaternionSkins : public ShaderSystemPlaced, public testing::WithParamInterface<Skinning> {
protected:
    /// A mesh that is as the entity's, bent as it is now.
    static Ogre::MeshPtr bentMeshOf(Ogre::Entity& entity, bool antipodal) {
        const Ogre::MeshPtr bent = entity.getMesh()->clone("bent");
        bent->setSkeletonName("");
        std::array<Ogre::Affine3, 4> bones;
        entity.getSkeleton()->_getBoneMatrices(bones.data());
        const Ogre::SubMesh& part = *entity.getMesh()->getSubMesh(0);
        std::vector<std::vector<std::pair<float, Quaternion8>>> weighted(
            part.vertexData->vertexCount);
        for (const auto& [vertex, assigned] : part.getBoneAssignments())
            if (assigned.weight > 0)
                weighted[vertex].emplace_back(assigned.weight,
                                              quaternionOf(bones.at(assigned.boneIndex)));
        Ogre::VertexData& vertices = *bent->getSubMesh(0)->vertexData;
        transform(vertices, Ogre::VES_POSITION, [&](std::size_t i, const Ogre::Vector3& at) {
            return blend(weighted[i], antipodal) * at;
        });
        transform(vertices, Ogre::VES_NORMAL, [&](std::size_t i, const Ogre::Vector3& along) {
            return blend(weighted[i], antipodal).linear() * along;
        });
        return bent;
    }
};

TEST_P(QuaternionSkins, ReceiveAndCastShadows) {
    const Skinning& skinning = GetParam();
    Ogre::Entity& post = addPost(2);
    Ogre::SkeletonInstance& skeleton = *post.getSkeleton();
    skeleton.getBone(static_cast<unsigned short>(0))->setManuallyControlled(true);
    skeleton.getBone(static_cast<unsigned short>(0))
        ->rotate(Ogre::Vector3::UNIT_Z, Ogre::Degree(skinning.footDegrees));
    skeleton.getBone(1)->setOrientation(
        Ogre::Quaternion(Ogre::Degree(skinning.headDegrees), Ogre::Vector3::UNIT_Z));
    Ogre::MaterialManager::getSingleton().create("Test/Skin", Ogre::RGN_DEFAULT);
    skin(post, "Test/Skin", Ogre::RTShader::ST_DUAL_QUATERNION, skinning.antipodal,
         skinning.scales);
    LogCollector log;
    scene.draw();
    const Picture drawn = scene.draw();
    scene.keepPicture(std::string("quaternions-") + skinning.name);
    EXPECT_TRUE(isBentByProgram(post)) << "OGRE bends it: nothing was tested";
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();

    Ogre::SceneNode& node = *post.getParentSceneNode();
    post.setVisible(false);
    EXPECT_TRUE(isOther(scene.draw(), drawn));
    const Ogre::MeshPtr bent = bentMeshOf(post, skinning.antipodal);
    Ogre::Entity* const reference = scene.manager().createEntity("bent", "bent");
    reference->setMaterialName(ShaderSystemScene::Plain);
    node.attachObject(reference);
    scene.draw();
    const Picture expected = scene.draw();
    scene.keepPicture(std::string("quaternions-reference-") + skinning.name);
    EXPECT_TRUE(isSame(drawn, expected));
}

INSTANTIATE_TEST_SUITE_P(Kinds, QuaternionSkins,
                         testing::Values(Skinning{"plain", false, false, 0, 60},
                                         Skinning{"scales", false, true, 0, 60},
                                         Skinning{"antipodal", true, false, 100, -200},
                                         Skinning{"both", true, true, 100, -200}),
                         [](const testing::TestParamInfo<Skinning>& tested) {
                             return std::string(tested.param.name);
                         });

/// One that the shader system draws writes the depth that OGRE's receivers read.
TEST_F(ShaderSystemPlaced, CastersOfTheShaderSystemGiveWayToLixels) {
    Ogre::Entity& post = addPost(2);
    auto& materials = Ogre::MaterialManager::getSingleton();
    materials.create("Test/Skin", Ogre::RGN_DEFAULT);
    materials.create("Test/OgresCaster", Ogre::RGN_DEFAULT);
    auto& factory = Ogre::RTShader::HardwareSkinningFactory::getSingleton();
    const Ogre::MaterialPtr caster = materials.getByName("Test/OgresCaster");
    factory.setCustomShadowCasterMaterials(Ogre::RTShader::ST_LINEAR, caster, caster, caster,
                                           caster);
    skin(post, "Test/Skin");
    LogCollector log;
    scene.draw();
    const Picture drawn = scene.draw();
    scene.keepPicture("caster-of-the-shader-system");
    const Ogre::MaterialPtr none;
    factory.setCustomShadowCasterMaterials(Ogre::RTShader::ST_LINEAR, none, none, none, none);
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
    EXPECT_TRUE(isBentByProgram(post)) << "OGRE bends it: nothing was tested";
    EXPECT_TRUE(isSame(drawn, scene.drawLixels()));
}

} // namespace
} // namespace Lixel::Tests

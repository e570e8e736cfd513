// What vertex programs bend by dual quaternions, which OGRE itself does not do on the CPU.

#include "PlacedScene.h"

#include <Lixel/scene/OgreVersions.h>
#include <Lixel/setup/FittedShadowCameraSetup.h>

#include <OgreDualQuaternion.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace Lixel::Tests {
namespace {

/// A turn and a shift, (w, x, y, z) of each, after a scale and shear.
struct QuaternionBone {
    std::array<float, 8> quaternion;
    Ogre::Matrix3 scale;
};

/// How OGRE takes a bone apart. It gives programs U + D - 1 of the parts Q D U of a matrix, where
/// D U would be right: the same without shear, and what programs are given they have to show.
QuaternionBone partsOf(const Ogre::Affine3& bone, bool scales) {
    Ogre::DualQuaternion q;
    q.fromTransformationMatrix(bone);
    QuaternionBone parts{{q.w, q.x, q.y, q.z, q.dw, q.dx, q.dy, q.dz}, Ogre::Matrix3::IDENTITY};
    if (!scales) return parts;
    Ogre::Matrix3 turn;
    Ogre::Vector3 scale, shear;
    bone.linear().QDUDecomposition(turn, scale, shear);
    parts.scale = Ogre::Matrix3(scale.x, shear.x, shear.y, 0, scale.y, shear.z, 0, 0, scale.z);
    return parts;
}

/// The transform of a vertex (Kavan et al. 2008, algorithm 1), after its scale and shear, which are
/// blended as matrices.
Ogre::Affine3 blend(const std::vector<std::pair<float, QuaternionBone>>& weighted, bool antipodal) {
    std::array<float, 8> sum{};
    Ogre::Matrix3 scale = Ogre::Matrix3::ZERO;
    const std::array<float, 8>& first = weighted.front().second.quaternion;
    for (const auto& [weight, bone] : weighted) {
        const std::array<float, 8>& q = bone.quaternion;
        float cosine = 0;
        for (std::size_t i = 0; i < 4; ++i)
            cosine += first[i] * q[i];
        const float sign = antipodal && cosine < 0 ? -1.0F : 1.0F;
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += sign * weight * q[i];
        scale = scale + bone.scale * weight;
    }
    const Ogre::Quaternion turn(sum[0], sum[1], sum[2], sum[3]);
    const float length = turn.Norm();
    Ogre::DualQuaternion blended;
    blended =
        Ogre::DualQuaternion(sum[0] / length, sum[1] / length, sum[2] / length, sum[3] / length,
                             sum[4] / length, sum[5] / length, sum[6] / length, sum[7] / length);
    Ogre::Affine3 matrix;
    blended.toTransformationMatrix(matrix);
    Ogre::Affine3 scaling = Ogre::Affine3::IDENTITY;
    scaling = scale;
    return matrix * scaling;
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

/// How a bone is rotated about z, and scaled.
struct Pose {
    float degrees;
    Ogre::Vector3 scale = Ogre::Vector3::UNIT_SCALE;
};

struct Skinning {
    const char* name;
    bool antipodal;
    bool scales;
    Pose foot;
    Pose head;
    /// Of the object. Where it is not uniform, turned bones are sheared in the world.
    Ogre::Vector3 scale = Ogre::Vector3::UNIT_SCALE;
};

void pose(Ogre::Bone& bone, const Pose& posed) {
    bone.setManuallyControlled(true);
    bone.setOrientation(Ogre::Quaternion(Ogre::Degree(posed.degrees), Ogre::Vector3::UNIT_Z));
    bone.setScale(posed.scale);
}

class QuaternionSkins : public ShaderSystemPlaced, public testing::WithParamInterface<Skinning> {
protected:
    /// A mesh in the world that is as the entity's, bent as it is now.
    static Ogre::MeshPtr bentMeshOf(Ogre::Entity& entity, const Skinning& skinning) {
        const Ogre::MeshPtr bent = entity.getMesh()->clone("bent");
        bent->setSkeletonName("");
        std::array<Ogre::Affine3, 4> bones;
        entity.getSkeleton()->_getBoneMatrices(bones.data());
        const Ogre::Affine3 wsNode(entity._getParentNodeFullTransform());
        const bool inObject = bonesAreInObject();
        const Ogre::Affine3 wsFromBent = inObject ? wsNode : Ogre::Affine3::IDENTITY;
        const Ogre::SubMesh& part = *entity.getMesh()->getSubMesh(0);
        std::vector<std::vector<std::pair<float, QuaternionBone>>> weighted(
            part.vertexData->vertexCount);
        for (const auto& [vertex, assigned] : part.getBoneAssignments()) {
            if (assigned.weight == 0) continue;
            const Ogre::Affine3& bone = bones.at(assigned.boneIndex);
            weighted[vertex].emplace_back(
                assigned.weight, partsOf(inObject ? bone : wsNode * bone, skinning.scales));
        }
        const auto wsFromVertex = [&](std::size_t vertex) {
            return wsFromBent * blend(weighted[vertex], skinning.antipodal);
        };
        Ogre::VertexData& vertices = *bent->getSubMesh(0)->vertexData;
        transform(vertices, Ogre::VES_POSITION,
                  [&](std::size_t i, const Ogre::Vector3& at) { return wsFromVertex(i) * at; });
        transform(vertices, Ogre::VES_NORMAL, [&](std::size_t i, const Ogre::Vector3& along) {
            const Ogre::Matrix3 inverse = wsFromVertex(i).linear().Inverse();
            return (inverse.Transpose() * along).normalisedCopy();
        });
        bent->_setBounds(entity.getWorldBoundingBox(true), false); // maps are fitted to them
        return bent;
    }
};

TEST_P(QuaternionSkins, ReceiveAndCastShadows) {
    const Skinning& skinning = GetParam();
    // What bends has a box alone, and maps are fitted to it.
    for (const char* const light : {"sun", "spot"})
        dynamic_cast<FittedShadowCameraSetup&>(
            *scene.manager().getLight(light)->getCustomShadowCameraSetup())
            .setMeshHulls(false);
    Ogre::Entity& post = addPost(2);
    Ogre::SceneNode& node = *post.getParentSceneNode();
    node.setScale(skinning.scale);
    Ogre::SkeletonInstance& skeleton = *post.getSkeleton();
    pose(*skeleton.getBone(static_cast<unsigned short>(0)), skinning.foot);
    pose(*skeleton.getBone(1), skinning.head);
    // OGRE takes the matrix of the first bone for the object's (before 14, where bones are in its
    // space): normals are wrong where that scales, or shears. So such a post glows, for which none
    // are needed.
    const auto& unit = Ogre::Vector3::UNIT_SCALE;
    const float lit = skinning.scale == unit && skinning.foot.scale == unit ? 1.0F : 0.0F;
    for (const char* const name : {"Test/Skin", "Test/Bent"}) {
        const auto material = Ogre::MaterialManager::getSingleton().create(name, Ogre::RGN_DEFAULT);
        Ogre::Pass& pass = *material->getTechnique(0)->getPass(0);
        pass.setDiffuse(lit, lit, lit, 1);
        pass.setSelfIllumination(0.5F * (1 - lit), 0, 0);
    }
    skin(post, "Test/Skin", Ogre::RTShader::ST_DUAL_QUATERNION, skinning.antipodal,
         skinning.scales);
    LogCollector log;
    scene.draw();
    const Picture drawn = scene.draw();
    scene.keepPicture(std::string("quaternions-") + skinning.name);
    EXPECT_TRUE(isBentByProgram(post)) << "OGRE bends it: nothing was tested";
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();

    const Ogre::MeshPtr bent = bentMeshOf(post, skinning);
    pose(*skeleton.getBone(static_cast<unsigned short>(0)), {skinning.foot.degrees});
    pose(*skeleton.getBone(1), {skinning.head.degrees});
    if (skinning.scales) {
        EXPECT_TRUE(isOther(scene.draw(), drawn)) << "bones have no scales";
    }

    // Never in a frame without either: maps follow what is seen.
    post.setVisible(false);
    Ogre::Entity* const reference = scene.manager().createEntity("bent", "bent");
    reference->setMaterialName("Test/Bent");
    scene.manager().getRootSceneNode()->attachObject(reference);
    scene.draw();
    const Picture expected = scene.draw();
    scene.keepPicture(std::string("quaternions-reference-") + skinning.name);
    EXPECT_TRUE(isSame(drawn, expected));
    reference->setVisible(false);
    EXPECT_TRUE(isOther(scene.draw(), drawn));
}

const Ogre::Vector3 Broad(1.5F, 0.8F, 1.2F);
const Ogre::Vector3 Slim(0.5F, 1.2F, 0.7F);

INSTANTIATE_TEST_SUITE_P(
    Kinds, QuaternionSkins,
    testing::Values(
        Skinning{"plain", false, false, {0}, {60}},
        Skinning{"scales", false, true, {0}, {60, Slim}},
        Skinning{"allScale", false, true, {0, Broad}, {60, Slim}},
        Skinning{"shears", false, true, {20, Broad}, {60, Slim}, Ogre::Vector3(0.6F, 1, 0.9F)},
        Skinning{"antipodal", true, false, {100}, {-200}},
        Skinning{"both", true, true, {100, Broad}, {-200, Slim}}),
    [](const testing::TestParamInfo<Skinning>& tested) { return std::string(tested.param.name); });

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

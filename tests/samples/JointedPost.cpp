#include "JointedPost.h"

#include "common/MeshBuilder.h"

#include <Lixel/scene/MeshBuffers.h>

#include <Ogre.h>

#include <algorithm>
#include <utility>

namespace Lixel::Samples {
namespace {

Ogre::SkeletonPtr makeSkeleton(const std::string& name) {
    Ogre::SkeletonPtr skeleton =
        Ogre::SkeletonManager::getSingleton().create(name, Ogre::RGN_DEFAULT, true);
    skeleton->load();
    Ogre::Bone* const foot = skeleton->createBone("foot", 0);
    Ogre::Bone* const head = foot->createChild(1, Ogre::Vector3(0, 2, 0));
    skeleton->setBindingPose();
    Ogre::NodeAnimationTrack* const track =
        skeleton->createAnimation("bend", 1)->createNodeTrack(1, head);
    track->createNodeKeyFrame(0);
    track->createNodeKeyFrame(1)->setRotation(
        Ogre::Quaternion(Ogre::Degree(90), Ogre::Vector3::UNIT_Z));
    return skeleton;
}

} // namespace

Ogre::MeshPtr makePost(const std::string& name) {
    MeshBuilder builder;
    for (int piece = 0; piece < 8; ++piece)
        builder.boxOn(Ogre::Vector3(0, 0.5F * static_cast<float>(piece), 0), 1, 0.5F, 1);
    return builder.build(name);
}

Ogre::MeshPtr makeJointedPost(const std::string& name, bool shared) {
    Ogre::MeshPtr mesh = makePost(name);
    Ogre::SkeletonPtr skeleton = makeSkeleton(name); // 1.12 takes no temporary one
    mesh->_notifySkeleton(skeleton);
    Ogre::SubMesh& part = *mesh->getSubMesh(0);
    // Where OGRE blends, it replaces whole buffers: positions and normals get one of their own.
    part.vertexData->reorganiseBuffers(
        part.vertexData->vertexDeclaration->getAutoOrganisedDeclaration(true, false, false));
    const std::vector<Vec3> positions = readPositions(*part.vertexData);
    if (shared) {
        mesh->sharedVertexData = std::exchange(part.vertexData, nullptr);
        part.useSharedVertices = true;
    }
    for (unsigned vertex = 0; vertex < positions.size(); ++vertex) {
        // At the joint, both bones.
        const auto height = static_cast<float>(positions[vertex].y());
        const float onHead = std::clamp(height - 1.5F, 0.0F, 1.0F);
        for (const auto& [bone, weight] : {std::pair<unsigned short, float>{0, 1 - onHead},
                                           std::pair<unsigned short, float>{1, onHead}}) {
            const Ogre::VertexBoneAssignment assignment{vertex, bone, weight};
            shared ? mesh->addBoneAssignment(assignment) : part.addBoneAssignment(assignment);
        }
    }
    return mesh;
}

} // namespace Lixel::Samples

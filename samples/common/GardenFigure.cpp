#include "common/GardenFigure.h"

#include "common/MeshBuilder.h"

#include <Lixel/scene/MeshBuffers.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Lixel::Samples {
namespace {

using Ogre::Degree;
using Ogre::Quaternion;
using Ogre::Vector3;

enum Joint : unsigned short {
    Hips,
    Spine,
    Head,
    ArmL,
    ForearmL,
    ArmR,
    ForearmR,
    ThighL,
    ShinL,
    FootL,
    ThighR,
    ShinR,
    FootR
};

/// A bone and where its joint is while the mesh is not bent, in the mesh's space.
struct BoneShape {
    const char* name;
    int parent; ///< -1 for none
    Vector3 joint;
};

const std::array<BoneShape, 13> Bones{{{"hips", -1, {0.0F, 0.93F, 0.0F}},
                                       {"spine", Hips, {0.0F, 1.04F, 0.0F}},
                                       {"head", Spine, {0.0F, 1.47F, 0.0F}},
                                       {"armL", Spine, {0.18F, 1.36F, 0.0F}},
                                       {"forearmL", ArmL, {0.45F, 1.36F, 0.0F}},
                                       {"armR", Spine, {-0.18F, 1.36F, 0.0F}},
                                       {"forearmR", ArmR, {-0.45F, 1.36F, 0.0F}},
                                       {"thighL", Hips, {0.1F, 0.88F, 0.0F}},
                                       {"shinL", ThighL, {0.1F, 0.48F, 0.0F}},
                                       {"footL", ShinL, {0.1F, 0.09F, 0.0F}},
                                       {"thighR", Hips, {-0.1F, 0.88F, 0.0F}},
                                       {"shinR", ThighR, {-0.1F, 0.48F, 0.0F}},
                                       {"footR", ShinR, {-0.1F, 0.09F, 0.0F}}}};
constexpr float HandReach = 0.29F; ///< from the elbow to the middle of a hand

/// Which bones bend a vertex, one after the other from the trunk outwards, and in which direction.
struct Chain {
    std::array<Joint, 4> bones;
    Vector3 outwards;
};

const Chain& chainOf(const Vector3& place) {
    static const Chain LegL{{Hips, ThighL, ShinL, FootL}, {0, -1, 0}};
    static const Chain LegR{{Hips, ThighR, ShinR, FootR}, {0, -1, 0}};
    static const Chain LeftArm{{Spine, ArmL, ForearmL, ForearmL}, {1, 0, 0}};
    static const Chain RightArm{{Spine, ArmR, ForearmR, ForearmR}, {-1, 0, 0}};
    static const Chain Trunk{{Hips, Spine, Head, Head}, {0, 1, 0}};
    if (place.y < 0.9F) return place.x > 0.0F ? LegL : LegR;
    if (place.y > 1.2F && place.y < 1.46F && std::abs(place.x) > 0.13F)
        return place.x > 0.0F ? LeftArm : RightArm;
    return Trunk;
}

/// Two bones and how much each of them moves a vertex.
struct Weights {
    std::array<unsigned short, 2> bones;
    float second;
};

Weights weightsAt(const Vector3& place) {
    constexpr float Bend = 0.06F; // a joint bends what is nearer than this
    const Chain& chain = chainOf(place);
    Weights weights{{chain.bones[0], chain.bones[1]}, 0.0F};
    for (std::size_t i = 1; i < chain.bones.size() && chain.bones[i] != chain.bones[i - 1]; ++i) {
        const float beyond = (place - Bones[chain.bones[i]].joint).dotProduct(chain.outwards);
        if (beyond < -Bend) break;
        weights.bones = {chain.bones[i - 1], chain.bones[i]};
        weights.second = std::min(1.0F, 0.5F + 0.5F * beyond / Bend);
    }
    return weights;
}

/// A round limb between two points, thick as given at its ends, which are half balls.
void addLimb(MeshBuilder& mesh, const Vector3& from, const Vector3& to, float thickFrom,
             float thickTo) {
    constexpr int Rings = 10, CapRings = 4;
    const Vector3 along = to - from;
    const float length = along.length();
    std::vector<ProfilePoint> profile{{0.0F, -thickFrom}};
    for (int i = 1; i < CapRings; ++i) {
        const float angle = Ogre::Math::HALF_PI * static_cast<float>(i) / CapRings;
        profile.push_back({thickFrom * std::sin(angle), -thickFrom * std::cos(angle), true});
    }
    for (int i = 0; i <= Rings; ++i) {
        const float t = static_cast<float>(i) / Rings;
        profile.push_back({std::lerp(thickFrom, thickTo, t), t * length, true});
    }
    for (int i = 1; i < CapRings; ++i) {
        const float angle = Ogre::Math::HALF_PI * static_cast<float>(i) / CapRings;
        profile.push_back({thickTo * std::cos(angle), length + thickTo * std::sin(angle), true});
    }
    profile.push_back({0.0F, length + thickTo});
    mesh.transform = Ogre::Affine3(from, Vector3::UNIT_Y.getRotationTo(along / length));
    mesh.lathe(profile, 16);
    mesh.transform = Ogre::Affine3::IDENTITY;
}

/// The gardener's clothes, each of one material.
struct Clothes {
    MeshBuilder skin, shirt, trousers, straw, leather;
};

void dressTrunk(Clothes& clothes) {
    clothes.shirt.lathe(
        std::array{ProfilePoint{0.0F, 0.93F}, ProfilePoint{0.155F, 0.95F, true},
                   ProfilePoint{0.16F, 1.08F, true}, ProfilePoint{0.172F, 1.22F, true},
                   ProfilePoint{0.178F, 1.32F, true}, ProfilePoint{0.14F, 1.42F, true},
                   ProfilePoint{0.07F, 1.465F, true}, ProfilePoint{0.0F, 1.47F}},
        24);
    clothes.trousers.lathe(std::array{ProfilePoint{0.0F, 0.8F}, ProfilePoint{0.1F, 0.81F, true},
                                      ProfilePoint{0.165F, 0.88F, true},
                                      ProfilePoint{0.17F, 0.97F, true}, ProfilePoint{0.166F, 1.02F},
                                      ProfilePoint{0.0F, 1.02F}},
                           24);
    // A bib, and its straps over the shoulders.
    clothes.trousers.box({-0.1F, 1.0F, 0.1F}, {0.1F, 1.27F, 0.186F});
    for (const float x : {-0.085F, 0.085F}) {
        addLimb(clothes.trousers, {x, 1.25F, 0.17F}, {x, 1.36F, 0.148F}, 0.016F, 0.016F);
        addLimb(clothes.trousers, {x, 1.36F, 0.148F}, {x, 1.44F, 0.06F}, 0.016F, 0.016F);
        addLimb(clothes.trousers, {x, 1.44F, 0.06F}, {x, 1.37F, -0.14F}, 0.016F, 0.016F);
        addLimb(clothes.trousers, {x, 1.37F, -0.14F}, {x, 1.0F, -0.165F}, 0.016F, 0.016F);
    }
    clothes.skin.cylinder(0.06F, 1.44F, 1.55F, 14);
    clothes.skin.sphere({0.0F, 1.61F, 0.0F}, 0.125F, 24);
    clothes.skin.sphere({0.0F, 1.595F, 0.125F}, 0.025F, 10);
    for (const float x : {-0.042F, 0.042F})
        clothes.leather.sphere({x, 1.622F, 0.112F}, 0.016F, 10);
    addLimb(clothes.leather, {-0.035F, 1.562F, 0.112F}, {0.035F, 1.562F, 0.112F}, 0.017F, 0.017F);
    clothes.straw.lathe(std::array{ProfilePoint{0.0F, 1.665F}, ProfilePoint{0.28F, 1.64F},
                                   ProfilePoint{0.285F, 1.655F}, ProfilePoint{0.14F, 1.69F, true},
                                   ProfilePoint{0.125F, 1.77F, true},
                                   ProfilePoint{0.08F, 1.81F, true}, ProfilePoint{0.0F, 1.815F}},
                        28);
    clothes.leather.cylinder(0.139F, 1.688F, 1.715F, 24);
}

void dressLimbs(Clothes& clothes) {
    for (const float side : {1.0F, -1.0F}) {
        const auto at = [&](float x, float y, float z) { return Vector3(side * x, y, z); };
        addLimb(clothes.shirt, at(0.15F, 1.36F, 0), at(0.5F, 1.36F, 0), 0.066F, 0.052F);
        addLimb(clothes.skin, at(0.48F, 1.36F, 0), at(0.69F, 1.36F, 0), 0.043F, 0.033F);
        addLimb(clothes.skin, at(0.71F, 1.36F, 0), at(0.77F, 1.36F, 0), 0.045F, 0.04F);
        addLimb(clothes.trousers, at(0.095F, 0.84F, 0), at(0.1F, 0.31F, 0), 0.09F, 0.068F);
        addLimb(clothes.leather, at(0.1F, 0.3F, 0), at(0.1F, 0.08F, 0), 0.074F, 0.06F);
        addLimb(clothes.leather, at(0.1F, 0.055F, 0), at(0.1F, 0.05F, 0.15F), 0.055F, 0.05F);
    }
}

Ogre::SkeletonPtr makeSkeleton(const std::string& name) {
    auto& skeletons = Ogre::SkeletonManager::getSingleton();
    if (const Ogre::SkeletonPtr old = skeletons.getByName(name, Ogre::RGN_DEFAULT))
        skeletons.remove(old);
    const Ogre::SkeletonPtr skeleton = skeletons.create(name, Ogre::RGN_DEFAULT, true);
    skeleton->load();
    for (unsigned short handle = 0; handle < Bones.size(); ++handle) {
        const BoneShape& shape = Bones[handle];
        Ogre::Bone* const bone = skeleton->createBone(shape.name, handle);
        if (shape.parent < 0) {
            bone->setPosition(shape.joint);
            continue;
        }
        const auto parent = static_cast<unsigned short>(shape.parent);
        skeleton->getBone(parent)->addChild(bone);
        bone->setPosition(shape.joint - Bones[parent].joint);
    }
    skeleton->setBindingPose();
    return skeleton;
}

/// Adds the part that a builder has made to a mesh, with the bones that bend it.
void addPart(Ogre::Mesh& mesh, const MeshBuilder& builder, const char* material) {
    const Ogre::MeshPtr alone = builder.build(mesh.getName() + "/part");
    const Ogre::SubMesh& made = *alone->getSubMesh(0);
    Ogre::SubMesh& part = *mesh.createSubMesh();
    part.useSharedVertices = false;
    part.vertexData = made.vertexData->clone();
    OGRE_DELETE part.indexData;
    part.indexData = made.indexData->clone();
    part.setMaterialName(material);
    // Where OGRE bends it, it replaces whole buffers: texture coordinates need one of their own.
    part.vertexData->reorganiseBuffers(
        part.vertexData->vertexDeclaration->getAutoOrganisedDeclaration(true, false, false));
    unsigned vertex = 0;
    for (const Vec3& place : readPositions(*part.vertexData)) {
        const Weights weights =
            weightsAt(Vector3(static_cast<float>(place.x()), static_cast<float>(place.y()),
                              static_cast<float>(place.z())));
        // Two for each vertex, so that every part has the same number of weights.
        part.addBoneAssignment({vertex, weights.bones[0], 1.0F - weights.second});
        part.addBoneAssignment({vertex, weights.bones[1], weights.second});
        ++vertex;
    }
    Ogre::MeshManager::getSingleton().remove(alone);
}

void turn(Ogre::Skeleton& skeleton, Joint joint, const Quaternion& orientation) {
    Ogre::Bone& bone = *skeleton.getBone(joint);
    bone.setManuallyControlled(true);
    bone.setOrientation(orientation);
}

} // namespace

Ogre::MeshPtr gardenerMesh(const std::string& name) {
    Clothes clothes;
    dressTrunk(clothes);
    dressLimbs(clothes);
    auto& meshes = Ogre::MeshManager::getSingleton();
    if (const Ogre::MeshPtr old = meshes.getByName(name, Ogre::RGN_DEFAULT)) meshes.remove(old);
    const Ogre::MeshPtr mesh = meshes.createManual(name, Ogre::RGN_DEFAULT);
    addPart(*mesh, clothes.skin, "Garden/Skin");
    addPart(*mesh, clothes.shirt, "Garden/Shirt");
    addPart(*mesh, clothes.trousers, "Garden/Trousers");
    addPart(*mesh, clothes.straw, "Garden/Straw");
    addPart(*mesh, clothes.leather, "Garden/Leather");
    Ogre::SkeletonPtr skeleton = makeSkeleton(name + "/bones");
    mesh->_notifySkeleton(skeleton);
    // Of both poses.
    mesh->_setBounds(Ogre::AxisAlignedBox(-0.85F, -0.05F, -0.75F, 0.85F, 1.9F, 0.75F), false);
    mesh->_setBoundingSphereRadius(2.1F);
    mesh->load();
    return mesh;
}

void poseWalking(Ogre::Entity& gardener) {
    Ogre::Skeleton& skeleton = *gardener.getSkeleton();
    // About x a positive angle moves what hangs down backwards; about y it moves what points to the
    // left backwards.
    const auto swing = [](float degrees) { return Quaternion(Degree(degrees), Vector3::UNIT_X); };
    const auto turned = [](float degrees) { return Quaternion(Degree(degrees), Vector3::UNIT_Y); };
    const auto dropped = [](float degrees) { return Quaternion(Degree(degrees), Vector3::UNIT_Z); };
    turn(skeleton, Hips, turned(-6));
    skeleton.getBone(Hips)->setPosition(Bones[Hips].joint - Vector3(0.0F, 0.045F, 0.0F));
    turn(skeleton, Spine, turned(12) * swing(5));
    turn(skeleton, Head, turned(14) * swing(2));
    turn(skeleton, ThighL, swing(-27));
    turn(skeleton, ShinL, swing(9));
    turn(skeleton, FootL, swing(-4));
    turn(skeleton, ThighR, swing(19));
    turn(skeleton, ShinR, swing(24));
    turn(skeleton, FootR, swing(12));
    turn(skeleton, ArmL, swing(14) * dropped(-76));
    turn(skeleton, ForearmL, turned(-14));
    turn(skeleton, ArmR, swing(-30) * dropped(74));
    turn(skeleton, ForearmR, turned(42));
}

Vector3 leftHandOf(Ogre::Entity& gardener) {
    const Ogre::Skeleton& skeleton = *gardener.getSkeleton();
    const Ogre::Bone& forearm = *skeleton.getBone(ForearmL);
    return forearm._getDerivedPosition() +
           forearm._getDerivedOrientation() * Vector3(HandReach, 0.0F, 0.0F);
}

} // namespace Lixel::Samples

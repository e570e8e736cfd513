#include "Meshes.h"

#include "HeadlessOgre.h"
#include "Materials.h"

#include <OgreAnimation.h>
#include <OgreBone.h>
#include <OgreKeyFrame.h>
#include <OgreLodStrategy.h>
#include <OgreManualObject.h>
#include <OgreMesh.h>
#include <OgreMeshManager.h>
#include <OgrePlane.h>
#include <OgreSkeleton.h>
#include <OgreSkeletonManager.h>
#include <OgreSubMesh.h>

namespace Lixel::Tests {
namespace {

using Ogre::Vector3;

Ogre::MeshPtr cloneCube(Ogre::SceneManager& manager, const std::string& name) {
    return Ogre::MeshManager::getSingleton()
        .getByName(cubeMesh(manager), Ogre::RGN_DEFAULT)
        ->clone(name);
}

/// Two triangles of two materials, one above the other.
void makePair(Ogre::SceneManager& manager) {
    Ogre::ManualObject* pair = manager.createManualObject();
    for (const char* material : {"lit", "transparent"}) {
        const float y = material == std::string("lit") ? 0.0f : 1.0f;
        pair->begin(material, Ogre::RenderOperation::OT_TRIANGLE_LIST);
        for (const Vector3& corner : {Vector3(-1, y, 0), Vector3(1, y, 0.3f), Vector3(0, y + 1, 0)})
            pair->position(corner);
        pair->triangle(0, 1, 2);
        pair->end();
    }
    pair->convertToMesh("pair", Ogre::RGN_DEFAULT);
    manager.destroyManualObject(pair);
}

/// A square whose two parts share their vertices.
void makeShared() {
    const Ogre::MeshPtr square = Ogre::MeshManager::getSingleton().createPlane(
        "shared", Ogre::RGN_DEFAULT, Ogre::Plane(Vector3::UNIT_Y, 0), 3, 3, 1, 1, true, 1, 1, 1,
        Vector3::UNIT_Z);
    square->getSubMesh(0)->setMaterialName("passes");
    Ogre::SubMesh* second = square->createSubMesh();
    second->useSharedVertices = true;
    delete second->indexData;
    second->indexData = square->getSubMesh(0)->indexData->clone();
    second->setMaterialName("levels");
}

Ogre::SkeletonPtr makeSkeleton() {
    Ogre::SkeletonPtr skeleton =
        Ogre::SkeletonManager::getSingleton().create(JointedMesh, Ogre::RGN_DEFAULT, true);
    skeleton->load();
    Ogre::Bone* const foot = skeleton->createBone("foot", 0);
    Ogre::Bone* const head = foot->createChild(1, Vector3(0, 0.5f, 0));
    skeleton->setBindingPose();
    Ogre::NodeAnimationTrack* const track =
        skeleton->createAnimation("bend", 1)->createNodeTrack(1, head);
    track->createNodeKeyFrame(0);
    track->createNodeKeyFrame(1)->setRotation(Ogre::Quaternion(Ogre::Degree(90), Vector3::UNIT_Z));
    return skeleton;
}

void makeJointed(Ogre::SceneManager& manager) {
    const Ogre::MeshPtr mesh = cloneCube(manager, JointedMesh);
    Ogre::SkeletonPtr skeleton = makeSkeleton(); // 1.12 takes no temporary one
    mesh->_notifySkeleton(skeleton);
    for (unsigned vertex = 0; vertex < 8; ++vertex) // those with y = 0.5 to the head
        mesh->getSubMesh(0)->addBoneAssignment(
            {vertex, static_cast<unsigned short>((vertex >> 1U) & 1U), 1.0f});
    mesh->_compileBoneAssignments();
    mesh->getSubMesh(0)->_compileBoneAssignments();
}

/// A cube that is a pair of triangles from afar.
void makeLevelled(Ogre::SceneManager& manager) {
    const Ogre::MeshPtr mesh = cloneCube(manager, "levelled");
    Ogre::MeshLodUsage afar;
    afar.userValue = 15;
    afar.value = mesh->getLodStrategy()->transformUserValue(afar.userValue);
    afar.manualName = "pair";
    mesh->_setLodInfo(2);
    mesh->_setLodUsage(1, afar);
}

std::vector<std::string> makeMeshes(Ogre::SceneManager& manager) {
    materials();
    makePair(manager);
    makeShared();
    makeJointed(manager);
    cloneCube(manager, ChangingMesh);
    Ogre::MeshManager::getSingleton().createPlane(ReloadedMesh, Ogre::RGN_DEFAULT,
                                                  Ogre::Plane(Vector3::UNIT_Z, 0), 2, 2);
    makeLevelled(manager);
    cloneCube(manager, "boundless")->_setBounds(Ogre::AxisAlignedBox(), false);
    cloneCube(manager, InfiniteMesh)->_setBounds(Ogre::AxisAlignedBox::BOX_INFINITE, false);
    return {"cube",       "pair",     "shared",    JointedMesh, ChangingMesh,
            ReloadedMesh, "levelled", "boundless", InfiniteMesh};
}

} // namespace

const std::vector<std::string>& meshes(Ogre::SceneManager& manager) {
    static const std::vector<std::string> names = makeMeshes(manager);
    return names;
}

} // namespace Lixel::Tests

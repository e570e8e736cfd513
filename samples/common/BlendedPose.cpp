#include "common/BlendedPose.h"

#include <Ogre.h>

namespace Lixel::Samples {
namespace {

Ogre::VertexAnimationType vertexAnimationOf(Ogre::SubEntity& part) {
    const Ogre::SubMesh& mesh = *part.getSubMesh();
    return mesh.useSharedVertices ? mesh.parent->getSharedVertexDataAnimationType()
                                  : mesh.getVertexAnimationType();
}

void refusePoses(Ogre::Entity& entity) {
    for (Ogre::SubEntity* part : entity.getSubEntities())
        if (part->isVisible() && vertexAnimationOf(*part) == Ogre::VAT_POSE)
            OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                        "'" + entity.getName() +
                            "' has pose animation in hardware, which cannot be read back",
                        "BlendedPose");
}

/// Has OGRE blend anew, whatever it has blended before. It would else keep the buffers of an
/// earlier request, and bones of the same frame.
void notifyPoseChanged(Ogre::Entity& entity) {
    entity.getAllAnimationStates()->_notifyDirty();
    if (!entity.hasSkeleton()) return;
    Ogre::SkeletonInstance& skeleton = *entity.getSkeleton();
    if (!entity.getSkipAnimationStateUpdate())
        skeleton.setAnimationState(*entity.getAllAnimationStates());
    skeleton._notifyManualBonesDirty();
}

} // namespace

void BlendedPose::TakeRequestBack::operator()(Ogre::Entity* entity) const {
    entity->removeSoftwareAnimationRequest(false);
}

BlendedPose::BlendedPose(Ogre::Entity& entity) {
    if (!entity.hasSkeleton() && !entity.hasVertexAnimation()) return;
    if (entity.isHardwareAnimationEnabled()) {
        refusePoses(entity);
        entity.addSoftwareAnimationRequest(false);
        mRequested.reset(&entity);
    }
    notifyPoseChanged(entity);
    entity._updateAnimation();
}

Ogre::VertexData* BlendedPose::verticesOf(Ogre::SubEntity& part, Ogre::VertexData* drawn) const {
    if (!mRequested) return drawn;
    const bool shared = part.getSubMesh()->useSharedVertices;
    if (mRequested->hasSkeleton())
        return shared ? mRequested->_getSkelAnimVertexData() : part._getSkelAnimVertexData();
    if (vertexAnimationOf(part) == Ogre::VAT_NONE) return drawn;
    return shared ? mRequested->_getSoftwareVertexAnimVertexData()
                  : part._getSoftwareVertexAnimVertexData();
}

} // namespace Lixel::Samples

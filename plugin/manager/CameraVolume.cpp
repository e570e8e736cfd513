#include "manager/CameraVolume.h"

#include "scene/CasterVolume.h"
#include "scene/OgreMath.h"

#include <OgreCamera.h>

#include <typeinfo>

namespace Lixel {
namespace {

NodeCuller planesOf(const Ogre::Frustum& frustum) {
    NodeCuller volume;
    const Ogre::Plane* const planes = frustum.getFrustumPlanes();
    for (int i = 0; i < 6; ++i) {
        // An infinite far plane culls nothing.
        if (i == Ogre::FRUSTUM_PLANE_FAR && frustum.getFarClipDistance() == 0) continue;
        volume.add(toDouble(planes[i].normal), static_cast<double>(planes[i].d), Vec3::Zero());
    }
    return volume;
}

} // namespace

CameraVolume volumeOf(const Ogre::Camera& camera) {
    if (typeid(camera) != typeid(Ogre::Camera)) return {{}, false};
    const Ogre::Frustum* const culling = camera.getCullingFrustum();
    if (culling == nullptr) return {planesOf(camera), true};
    if (const auto* const casters = dynamic_cast<const CasterVolume*>(culling))
        return {casters->volume(), true};
    const std::type_info& type = typeid(*culling);
    if (type == typeid(Ogre::Frustum) || type == typeid(Ogre::Camera))
        return {planesOf(*culling), true};
    return {{}, false};
}

} // namespace Lixel

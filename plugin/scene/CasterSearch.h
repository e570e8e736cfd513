#pragma once

#include "scene/CasterSweep.h"
#include "scene/Survey.h"

namespace Lixel {

/** Finds the casters that can matter to one light, and keeps their boxes.

    Those behind the viewer are among them: what decides is whether a light ray goes through the
    caster's box to a point that is in view, within the receivers' bounds and the shadow distance.
    A fit gives the same result with these casters as with all of the scene's; only where no
    receiver is in view it may say instead that nothing is shadowed. Casters without
    bounds are always counted.
*/
class LIXEL_API CasterSearch {
public:
    /// @param survey of the scene as it is now
    /// @param light relative to the survey's origin
    /// @param shadowDistance as ShadowViewer::shadowDistance
    /// @param margin share by which the view is widened, as the survey was taken with
    /// @return the casters, good until the next search
    const BoxSet& find(const Survey& survey, const ShadowLight& light, double shadowDistance,
                       double margin = 0.0);

    /// The casters in a volume.
    const BoxSet& findIn(const Survey& survey, const NodeCuller& volume);

    /// Hulls of the casters found. They read the objects: good until one is moved or destroyed.
    const BodyShapes& shapes() const { return mShapes; }

    /// The casters found that have bounds.
    std::span<const Ogre::MovableObject* const> objects() const { return mShapes.objects(); }
    /// Name of a caster without bounds; empty if there is none.
    const std::string& unboundedName() const { return mUnboundedName; }

    /// All casters of the scene, whatever they may shadow.
    const BoxSet& findAll(const Survey& survey);

private:
    void clear(const Survey& survey);
    void collect(const Survey& survey, const NodeCuller& volume);
    /// Adds what casts.
    void addCaster(const Ogre::MovableObject& object, const Ogre::AxisAlignedBox& bounds,
                   const Vec3& wsOrigin);

    BoxSet mCasters;
    ObjectShapes mShapes;
    std::string mUnboundedName;
    CasterSweep mReach;
    NodeWalk mWalk;
};

} // namespace Lixel

#pragma once

#include "fit/geometry/ConvexVolume.h"
#include "fit/geometry/Polygon2.h"
#include "fit/problem/ShadowProblem.h"
#include "scene/NodeCuller.h"

namespace Lixel {

/** From where a caster can shadow what is seen, before anything is known of the casters.

    For a light that shines too wide for one map, a box around it and all points in view within the
    receivers' bounds and its range. For any other, all light rays that meet a point in view within
    the receivers' bounds, from the light (or from infinity) to the farthest such point.
    CasterVolume is the same around a fit's focus region; this one is larger, and decides which
    casters that fit is told of.
*/
class CasterSweep {
public:
    /** @param viewer with the light's shadow distance
        @param light one that `isUsable` is true for
        @param receivers bounds of the receivers in view, relative to `wsOrigin`
        @return false where no receiver is in view within that distance and lit: no caster matters
    */
    bool set(const ShadowViewer& viewer, const ShadowLight& light, const Aabb& receivers,
             const Vec3& wsOrigin);

    const NodeCuller& volume() const { return mVolume; }

    /// Whether a light's numbers mean something.
    static bool isUsable(const ShadowLight& light);

private:
    bool setBox(const ConvexVolume& seen, const Aabb& bounds, const ShadowLight& light,
                const Vec3& wsOrigin);

    NodeCuller mVolume;
    // Scratch memory.
    ClipScratch mClip;
    std::vector<Vec3> mWsPoints;
    std::vector<Vec2> mPoints;
    Polygon2 mHull;
};

} // namespace Lixel

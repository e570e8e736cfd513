#pragma once

#include "fit/geometry/ConvexVolume.h"
#include "fit/problem/ShadowProblem.h"

namespace Lixel {

/** What the viewer sees: the planes of its clip volume and of the shadow distance.

    Planes by Gribb and Hartmann's rows (w ± x, w ± y, w ± z) of the product of the viewer's
    matrices. Holds for off-axis and oblique projections, and without a far plane.
*/
ConvexVolume viewVolume(const ShadowViewer& viewer);

/// Where the viewer is, in world axes relative to the problem's origin.
Vec3 wsEyeOf(const ShadowViewer& viewer);

/** A viewer that sees more, all around and farther away: what it will see after it has turned and
    gone on a little.

    @param share by which width, height and shadow distance grow; 0 for the viewer itself. A
    perspective viewer without shadow distance gets that of its far plane, grown too.
*/
ShadowViewer widened(const ShadowViewer& viewer, double share);

/// The projection with clip z growing away from the viewer: z is negated if it falls with depth
/// (reversed Z). So the nearer of two points on a view ray always has the lesser z.
Mat4 withDepthAhead(const Mat4& clipFromView);

/// Finds a box that holds what the viewer sees, for bodies without bounds.
/// @return false where the view has no bounds either
bool viewBounds(const ShadowViewer& viewer, Aabb& box);

} // namespace Lixel

#pragma once

#include "fit/geometry/BoxSet.h"
#include "fit/geometry/SurfaceCloud.h"

#include <limits>
#include <span>

namespace Lixel {
/// @addtogroup LixelFit
/// @{

enum class LightKind { Directional, Spot, Point };

/// The light of a shadow map. Positions are in world axes, relative to the problem's origin.
struct ShadowLight {
    LightKind kind = LightKind::Directional;
    /// The direction in which light travels (directional) or the cone's axis (spot); any length
    /// but zero.
    Vec3 wsDirection = Vec3(0.0, -1.0, 0.0);
    /// Spot and point lights.
    Vec3 wsPosition = Vec3::Zero();
    /// Half of the spot's outer cone angle in radians, in (0, π); one map serves up to 89.5°.
    double outerHalfAngle = 0.7;
    /// Local lights: nothing nearer than this casts a shadow, in world units; > 0.
    double nearDistance = 0.1;
    /// Local lights: nothing farther than this is lit, in world units.
    double range = std::numeric_limits<double>::infinity();
};

/// Who looks at the shadows.
struct ShadowViewer {
    /// View space from world axes relative to the problem's origin; a rigid motion, or one with a
    /// mirror: a matrix that scales or shears by more than 1 % is invalid. View space looks along
    /// -z.
    Mat4 viewFromWorld = Mat4::Identity();
    /// OpenGL clip space (-w <= x, y, z <= w) from view space: perspective, orthographic, off-axis
    /// or oblique, with or without a far plane.
    Mat4 clipFromView = Mat4::Identity();
    /// How far shadows reach, as depth in front of the viewer in world units; 0: to the far plane.
    double shadowDistance = 0.0;
};

/// A point of a receiver that the viewer sees, in world axes relative to the problem's origin.
struct VisiblePoint {
    Vec3 ws = Vec3::Zero();
    /// Unit normal on the side that is seen.
    Vec3 wsNormal = Vec3::UnitY();
};

class BodyShapes;
class SeenPicture;
struct ShadowPart;

/** One light, one viewer and this frame's bodies: everything that a fit depends on.

    All positions are in world axes relative to one origin, by convention the viewer's position, in
    double precision, so that a fit is as exact far from the world's origin as near it.
*/
struct ShadowProblem {
    ShadowViewer viewer;
    ShadowLight light;
    const BoxSet* casters = nullptr;
    const BoxSet* receivers = nullptr;
    /// Shapes of casters and of receivers, where more is known than their boxes: @see BodyHull.h
    const BodyShapes* casterShapes = nullptr;
    const BodyShapes* receiverShapes = nullptr;
    /// Receivers whose surface is known better than from their boxes, by ascending `receiver`.
    std::span<const KnownSurface> surfaces{};
    /** What the viewer sees of the receivers, if it is known better than from all these: points
        spread evenly over the viewer's picture, such as a depth buffer read back. */
    std::span<const VisiblePoint> visiblePoints{};
    /// What an earlier frame showed, where there are no visiblePoints: for the cells of the picture
    /// that it knows. Null without.
    const SeenPicture* seen = nullptr;
    /// Which receivers the map is for, where the light has several maps; null for all of them.
    /// @see LightPartition.h
    const ShadowPart* part = nullptr;
    /// Size of the shadow map in texels.
    int mapWidth = 1024;
    int mapHeight = 1024;
    /// How far the receiver's filter reaches from the texel that it looks up, in texels: 0 for one
    /// nearest tap, 1 for bilinear comparison.
    double filterRadius = 1.0;
    /// Whether the render system clamps the depth of casters in front of the near plane instead of
    /// clipping them. Where it cannot, the depth range is stretched over all casters.
    bool depthClamp = true;
    /// Where the problem's origin is in the world: for techniques that are given something there.
    Vec3 wsOrigin = Vec3::Zero();
};

static_assert(HasOneLayout<ShadowProblem>);
static_assert(HasOneLayout<VisiblePoint>);

/// @}
} // namespace Lixel

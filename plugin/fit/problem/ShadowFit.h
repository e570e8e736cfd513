#pragma once

#include "fit/geometry/Types.h"

#include <array>
#include <span>

namespace Lixel {
/// @addtogroup LixelFit
/// @{

/// What kept a technique from its ideal; None where nothing did.
enum class FitReason {
    None,
    /// The view runs along the light: the warp has faded to a uniform map, which is the best there.
    LightAlongView,
    /// The technique's warp was pulled into the safe set of the focus region, or to where texels
    /// are no finer than what float positions tell apart.
    WarpClamped,
    /// A body without bounds: the map is focused on everything the viewer sees.
    UnboundedBody,
    /// The plane that the map is made for is edge-on to the light, and the warp has faded; or its
    /// exact map does not serve all that is seen, and wsServed says what it does; or it serves
    /// nothing (the plane is edge-on to the viewer too, or turned away), and the map is uniform.
    PlaneCannotServe,
    /// A stable map was asked for a view that has neither a far plane nor a shadow distance: the
    /// map is focused.
    ViewWithoutEnd,
    /// A point light or a wide spot, which takes more maps than it has: its only one serves the light
    /// rays within a cone (WidestAim) around what is seen, and what lies outside is lit.
    PartOfLight,
    // From here on there is no map to draw.
    /// No receiver is in view.
    NoReceivers,
    /// No caster is between the light and a visible receiver.
    NothingShadowed,
    /// A receiver without bounds, seen by a viewer without a far plane or shadow distance.
    Unbounded,
    /// A NaN, an infinity, a zero direction or a singular matrix in the input, or a map too small
    /// for its filter.
    InvalidInput,
    /// A point light or a wide spot, which takes more maps than this one.
    TooFewMaps,
};

/// A short English name for logs and statistics, such as "warp clamped".
LIXEL_API const char* toString(FitReason reason) noexcept;

/// Whether there is a map to draw for this reason.
constexpr bool hasMap(FitReason reason) noexcept {
    return reason < FitReason::NoReceivers;
}

/// The vertices of a convex polygon in the light image, counter-clockwise; at most Capacity.
struct FocusPolygon {
    static constexpr std::size_t Capacity = 16;
    std::array<Vec2, Capacity> vertices;
    std::size_t count = 0;

    std::span<const Vec2> span() const { return {vertices.data(), count}; }
};

/** One shadow map: a homography of the light's image plane, a depth row, and why it is as it is.

    Light space (`ls`) has its origin at `wsEye` and looks along -z: along the light's direction
    for a directional light, along the cone's axis for a spot.
    The light image (`li`) is (x, y) for a directional light and (x, y) / -z for a local one.
*/
struct ShadowFit {
    FitReason reason = FitReason::InvalidInput;
    bool directional = true;

    /// Where the shadow camera stands, in world axes relative to the problem's origin.
    Vec3 wsEye = Vec3::Zero();
    /// Rotates world axes into light space; its rows are light space's axes in the world.
    Mat3 lsFromWs = Mat3::Identity();
    /// OpenGL clip space from light space. Its rows x, y and w are the homography, its row z the
    /// depth.
    Mat4 clipFromLight = Mat4::Identity();
    /// OpenGL clip space from world axes relative to the problem's origin.
    Mat4 clipFromWorld = Mat4::Identity();

    /// Stored depth = scale * z + offset, for z the third clip coordinate *before* the division.
    /// It is affine in world space, 0 at the nearest and 1 at the farthest receiver.
    double depthScale = 1.0;
    double depthOffset = 0.0;
    /// Change of stored depth for one world unit along the light's axis (Gusev 2007, §3.10).
    double depthPerWorldUnit = 0.0;
    /// Range of distances along the light's axis that is mapped to stored depths 0 to 1.
    double lsNear = 0.0;
    double lsFar = 1.0;

    /// The light rays that matter, as a polygon that contains the focus region and what a
    /// receiver's filter reaches beyond it.
    FocusPolygon liFocus;
    /// Interior point of the focus region and warp about it: the denominator at q is
    /// 1 + liWarp . (q - liCentre), positive all over the focus region.
    Vec2 liCentre = Vec2::Zero();
    Vec2 liWarp = Vec2::Zero();
    /// Direction of the normals of the map's left and right sides in the warped light image, in
    /// radians in [0, π); 0 for a map that the technique gave whole.
    double mapAngle = 0.0;
    /// How far the normals of its other two sides are from a right angle with these, in radians in
    /// (-π/2, π/2): 0 for a rectangle, positive to the left.
    double mapSkew = 0.0;
    /// Half spaces n . x + d >= 0 as (n, d), in world axes relative to the problem's origin,
    /// bounded by planes through the light: receivers outside of any of them have no place in this
    /// map. The first `servedCount` count; there are none for a map that was fitted, which serves
    /// everything.
    std::array<Vec4, 4> wsServed{};
    std::size_t servedCount = 0;

    bool hasMap() const noexcept { return Lixel::hasMap(reason); }
};

/** Kozlov's texel matrix M' (2004, §14.2.3), in homogeneous world axes relative to the origin.

    For a world point x, dehomogenise(M' x) is the point that lies one texel further in both map
    axes at the same depth value; its distance from x is Kozlov's L_texel.

    @return the identity where the fit has no map.
*/
LIXEL_API Mat4 texelMatrix(const ShadowFit& fit, int mapWidth, int mapHeight) noexcept;

static_assert(HasOneLayout<ShadowFit>);

/// @}
} // namespace Lixel

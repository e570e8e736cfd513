#pragma once

#include "fit/SpotAim.h"

#include <array>
#include <numbers>
#include <span>

/** One light in several maps: who is served by which.

    Each map has an affine function of world points, and serves the points at which its function is
    the greatest of all. Slices of the view, faces of a cube around a light and faces of the view
    volume itself are all of this kind, so a receiver finds its map by a few dot products, and no
    point has none or two.
*/
namespace Lixel {

/// Widest cone of a single map, as half angle in radians: tan(89.5°) = 115 spreads the map, but no
/// plane holds the rays of 90°.
inline constexpr double WidestHalfAngle = 89.5 * std::numbers::pi / 180.0;

/// Whether the light shines too wide for one map: a point light, or a spot of more than
/// WidestHalfAngle.
LIXEL_API bool needsParts(const ShadowLight& light);

/// What one of a light's maps is for.
struct ShadowPart {
    /// The most that a light has.
    static constexpr std::size_t Most = 8;
    /// A part has a bound with each of the others.
    static constexpr std::size_t MostBounds = Most - 1;

    /// The light as this map sees it: a face of a point light is a spot.
    ShadowLight light;
    /// (n, d): n . x + d is the part's function, in world axes relative to the problem's origin.
    Vec4 wsRow = Vec4::Zero();
    /// The half spaces in which that is greatest, and somewhat more where slices overlap.
    std::array<Plane, MostBounds> wsBounds{};
    std::size_t boundCount = 0;
    /// Depth in front of the viewer at which a slice ends, in world units; infinite for the last
    /// one, and for parts of another kind.
    double vsEnd = std::numeric_limits<double>::infinity();
    /// The plane (n, d) of the viewer's volume through which the part's light rays leave it; 0 for
    /// parts of another kind.
    Vec4 wsExit = Vec4::Zero();

    std::span<const Plane> bounds() const { return {wsBounds.data(), boundCount}; }
};

/// The parts of a problem, one map each.
struct ShadowParts {
    static constexpr std::size_t Capacity = ShadowPart::Most;
    std::array<ShadowPart, Capacity> parts{};
    std::size_t count = 0;

    std::span<const ShadowPart> span() const { return {parts.data(), count}; }
    /// The part that serves a world point.
    LIXEL_API std::size_t serving(const Vec3& ws) const;
};

/// All in one part.
LIXEL_API ShadowParts wholeLight(const ShadowLight& light);

/** Slices of the view, by depth in front of the viewer.

    @param vsSplits where slices meet, ascending, in world units; at most Capacity - 1 of them count
    @param vsPadding how much farther than to where it meets the next a slice's map reaches, at both
    ends, for receivers that find slices in another way
    @return one part more than splits
*/
LIXEL_API ShadowParts sliceView(const ShadowViewer& viewer, const ShadowLight& light,
                                std::span<const double> vsSplits, double vsPadding = 0.0);

/** A point light, or a spot too wide for one map, in a single part: the narrowest spot that will
   do.
    @return none where it would have to be too wide. @see SpotAim.h */
LIXEL_API ShadowParts aimedSpot(const ShadowProblem& problem, AimScratch& scratch);

/** Faces of a cube around a local light, with world axes: six spots of which none depends on the
    viewer. A spot's own cone is not regarded: it is for those that are too wide for one map. */
LIXEL_API ShadowParts cubeAround(const ShadowLight& light);

/** Kozlov's cube map of post-projective space (2004, §14.2.2, "Using Cube Maps"): faces of the
    viewer's volume that look away from the light, one to five of them for a directional light
   (Kozlov has three to five; a light straight from behind needs but the far one), all six for a
   light within.

    A light ray belongs to the face through which it leaves the volume. In homogeneous world
    coordinates, with planes n_i (positive inside) and the light L, x - t L runs away from the light
    as t grows, and leaves at the least of

        t_i = (n_i . x) / (n_i . L)    over the faces with n_i . L > 0,

    his a = max(...) without post-projective space, and so without its inverted lights: it also
    holds for a light behind the viewer. A shadow distance is a face too.

    A point light's parts are spots around what is seen of them. Where neither the view nor the
    light's range has an end, or a part is too wide for one map, they are cubeAround's instead.
*/
LIXEL_API ShadowParts facesOfView(const ShadowViewer& viewer, const ShadowLight& light,
                                  AimScratch& scratch);

/// The problem of one part: its light, and its share of the receivers. The part has to outlive it.
LIXEL_API ShadowProblem problemOf(const ShadowProblem& problem, const ShadowPart& part);

} // namespace Lixel

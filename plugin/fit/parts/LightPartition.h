#pragma once

#include "fit/focus/LightImage.h"
#include "fit/parts/SpotAim.h"
#include "fit/problem/ShadowPart.h"

#include <array>
#include <span>

/** One light in several maps: who is served by which.

    Each map has an affine function of world points, and serves the points at which its function is
    the greatest of all. Slices of the view, faces of a cube around a light and faces of the view
    volume itself are all of this kind, so a receiver finds its map by a few dot products, and no
    point has none or two.
*/
namespace Lixel {

/// The parts of a problem, one map each.
struct LightPartition {
    static constexpr std::size_t Capacity = ShadowPart::Most;
    std::array<ShadowPart, Capacity> parts{};
    std::size_t count = 0;
    /// Whether each light ray is in one of the parts.
    bool servesAll = true;

    std::span<const ShadowPart> span() const { return {parts.data(), count}; }
    /// The part that serves a world point.
    LIXEL_API std::size_t serving(const Vec3& ws) const;
};

/// All in one part.
LIXEL_API LightPartition wholeLight(const ShadowLight& light);

/** Slices of the view, by depth in front of the viewer.

    @param vsSplits where slices meet, ascending, in world units; at most Capacity - 1 of them count
    @param vsPadding how far each slice's map reaches beyond its splits, at both ends, in world
    units: for receivers that choose slices in another way
    @return one part more than splits
*/
LIXEL_API LightPartition sliceView(const ShadowViewer& viewer, const ShadowLight& light,
                                   std::span<const double> vsSplits, double vsPadding = 0.0);

/** Strips of the light image: between lines across one direction, so that no light ray is in two.

    The maps of slices by depth overlap in the light image wherever what is seen reaches through
    several of them along the light; strips' maps never do.

    @param liDirection unit direction across the strips, in `image`
    @param liSplits where strips meet along it, ascending; at most Capacity - 1 of them count
    @return one part more than splits
*/
LIXEL_API LightPartition stripLight(const ShadowLight& light, const LightImage& image,
                                    const Vec2& liDirection, std::span<const double> liSplits);

/** A point light, or a spot too wide for one map, in a single part: the narrowest spot that will
    do.
    @return none where it would have to be too wide. @see SpotAim.h */
LIXEL_API LightPartition aimedSpot(const ShadowProblem& problem, AimScratch& scratch);

/// The same in a single part whatever it takes: where no spot will do, the widest one around what
/// the viewer sees, which serves no light rays outside of its cone.
LIXEL_API LightPartition widestPart(const ShadowProblem& problem, AimScratch& scratch,
                                    std::optional<Vec3>& wsAxis);

/** Faces of a cube around a local light, with world axes: six spots, none of them depending on the
    viewer. A spot's own cone is not regarded: it is for those that are too wide for one map. */
LIXEL_API LightPartition cubeAround(const ShadowLight& light);

/** Kozlov's cube map of post-projective space (2004, §14.2.2, "Using Cube Maps"): faces of the
    viewer's volume that look away from the light, one to five of them for a directional light
    (Kozlov has three to five; a light straight from behind needs only the far one), all six for a
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
LIXEL_API LightPartition facesOfView(const ShadowViewer& viewer, const ShadowLight& light,
                                     AimScratch& scratch);

/// The problem of one part: its light, and its share of the receivers. The part has to outlive it.
LIXEL_API ShadowProblem problemOf(const ShadowProblem& problem, const ShadowPart& part);

} // namespace Lixel

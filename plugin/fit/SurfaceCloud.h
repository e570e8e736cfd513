#pragma once

#include "fit/Types.h"

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace Lixel {

/// A small piece of a surface: a disc that is seen from the side its normal points to.
struct Surfel {
    Vec3 centre = Vec3::Zero();
    /// Unit length.
    Vec3 normal = Vec3::UnitY();
    double radius = 0.0;
};

/** A body's surface as few discs, in the body's own space: made once, and moved with the body.

    A box says all about a crate, and little about a room or a landscape that the viewer stands in:
    its faces are not where the surface is. The discs are spread evenly by area over the triangles,
    and overlap enough for view rays not to slip through.
*/
struct SurfaceCloud {
    std::vector<Surfel> surfels;
};

/** Spreads discs over triangles.

    @param positions vertices; what is not finite is left out with its triangles
    @param triangles three vertices each, counter-clockwise seen from the side that is drawn; with
           an index beyond the vertices they are left out
    @param count discs to make; fewer only where nothing has an area
*/
SurfaceCloud makeSurfaceCloud(std::span<const Vec3> positions,
                              std::span<const std::array<std::uint32_t, 3>> triangles,
                              std::size_t count);

/// A receiver whose surface is known better than from its box.
struct KnownSurface {
    /// Index of its box among the problem's receivers.
    std::size_t receiver = 0;
    const SurfaceCloud* cloud = nullptr;
    /// World axes relative to the problem's origin from the cloud's space.
    Eigen::Affine3d wsFromCloud = Eigen::Affine3d::Identity();
};

} // namespace Lixel

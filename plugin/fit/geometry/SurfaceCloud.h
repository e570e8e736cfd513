#pragma once

#include "fit/geometry/Types.h"

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace Lixel {
/// @addtogroup LixelFit
/// @{

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

/** Makes a cloud of triangles that come one at a time, and are not kept: twice the same ones, in
    the same order. Gives what makeSurfaceCloud gives. */
class SurfaceCloudBuilder {
public:
    /// @param count as for makeSurfaceCloud
    explicit SurfaceCloudBuilder(std::size_t count) : mCount(count) {}

    /// All triangles are measured first. What is not finite has no area.
    void measure(const Vec3& a, const Vec3& b, const Vec3& c);
    /// Twice the area so far.
    double measured() const { return mSum; }
    /// Then each of them gets the discs that fall to it.
    void spread(const Vec3& a, const Vec3& b, const Vec3& c);
    /// Skips the next triangles, up to the one after which measured() was `sum`, unless any of them
    /// gets a disc. @return whether they were skipped
    bool skip(double sum);
    /// The discs so far: all of them when the last triangle that has an area has got its own.
    const SurfaceCloud& cloud() const { return mCloud; }

private:
    /// Whether the next disc lies before the triangles' sum is that.
    bool isNextBefore(double sum) const;

    std::size_t mCount = 0;
    /// Twice the area of all triangles.
    double mSum = 0.0;
    /// And of those that have got their discs.
    double mPassed = 0.0;
    SurfaceCloud mCloud;
};

/// A receiver whose surface is known better than from its box.
struct KnownSurface {
    /// Index of its box among the problem's receivers.
    std::size_t receiver = 0;
    const SurfaceCloud* cloud = nullptr;
    /// World axes relative to the problem's origin from the cloud's space.
    Transform3 wsFromCloud = Transform3::Identity();
};

static_assert(HasOneLayout<KnownSurface>);
static_assert(HasOneLayout<SurfaceCloud>);

/// @}
} // namespace Lixel

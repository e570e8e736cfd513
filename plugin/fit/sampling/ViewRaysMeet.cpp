// What view rays meet first.
#include "fit/geometry/Multiversion.h"
#include "fit/geometry/Simd.h"
#include "fit/sampling/ViewRays.h"

#include <bit>

namespace Lixel {
namespace {

using Rays = ViewRays::Rays;
static_assert(ViewRays::Columns % 4 == 0);

/// A point or direction in clip space for each lane, as x, y and w: z does not matter.
using FourClips = std::array<Four, 3>;

/// The rows x, y and w of a matrix to clip space.
using ClipRows = std::array<std::array<double, 4>, 3>;

ClipRows clipRows(const Mat4& clipFromWorld) {
    ClipRows rows;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 4; ++k)
            rows[i][k] = clipFromWorld(static_cast<Eigen::Index>(i < 2 ? i : 3),
                                       static_cast<Eigen::Index>(k));
    return rows;
}

/// Cells of the picture whose rays may meet a body: first and last column and row, for each lane.
struct Cells {
    std::array<std::array<double, 4>, 2> first;
    std::array<std::array<double, 4>, 2> last;
    /// Bounds in device coordinates.
    std::array<std::array<double, 4>, 2> lower;
    std::array<std::array<double, 4>, 2> upper;
};

constexpr std::array<double, 2> CellCounts = {static_cast<double>(ViewRays::Columns),
                                              static_cast<double>(ViewRays::Rows)};

/** Finds the cells that four boxes reach into: all of them for one that reaches behind the viewer.
    @return the lanes of boxes that reach into the picture, as bits */
[[gnu::always_inline]] inline unsigned findCells(const FourVectors& centre, const FourVectors& half,
                                                 const ClipRows& rows, Cells& cells) {
    FourClips clip;
    FourClips reach;
    for (std::size_t i = 0; i < 3; ++i) {
        clip[i] = (rows[i][0] * centre[0] + rows[i][1] * centre[1]) +
                  (rows[i][2] * centre[2] + rows[i][3]);
        reach[i] = (std::abs(rows[i][0]) * half[0] + std::abs(rows[i][1]) * half[1]) +
                   std::abs(rows[i][2]) * half[2];
    }
    const Four least = clip[2] - reach[2];
    const Four greatest = clip[2] + reach[2];
    const FourMask before = greatest > 0.0;
    const FourMask across = (clip[0] - reach[0] <= greatest) & (clip[0] + reach[0] >= -greatest);
    const FourMask up = (clip[1] - reach[1] <= greatest) & (clip[1] + reach[1] >= -greatest);
    const unsigned inPicture = bitsOf(before & across & up);
    if (inPicture == 0) return 0;
    const FourMask wholly = least > 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
        // x / w is least and greatest at one of the bounds of w.
        const Four from = clip[i] - reach[i];
        const Four to = clip[i] + reach[i];
        Four lower = from / (from < 0.0 ? least : greatest);
        Four upper = to / (to > 0.0 ? least : greatest);
        lower = wholly ? lower : Four{} - 1.0;
        upper = wholly ? upper : Four{} + 1.0;
        store(lower, cells.lower[i].data());
        store(upper, cells.upper[i].data());
        const double count = CellCounts[i];
        Four first;
        Four last;
        greater(Four((lower + 1.0) * (0.5 * count)), Four{}, first);
        greater(Four((upper + 1.0) * (0.5 * count)), Four{}, last);
        lesser(first, Four{} + (count - 1.0), first);
        lesser(last, Four{} + (count - 1.0), last);
        store(first, cells.first[i].data());
        store(last, cells.last[i].data());
    }
    return inPicture;
}

/// Shortens four rays to the box.
[[gnu::always_inline]] inline void meetFour(const std::array<double, 3>& lower,
                                            const std::array<double, 3>& upper, Rays& rays,
                                            std::size_t first) {
    FourVectors in;
    FourVectors out;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Four origin;
        Four inverse;
        load(&rays.origin[axis][first], origin);
        load(&rays.inverse[axis][first], inverse);
        const Four a = (lower[axis] - origin) * inverse;
        const Four b = (upper[axis] - origin) * inverse;
        lesser(a, b, in[axis]);
        greater(a, b, out[axis]);
    }
    Four entry;
    Four exit;
    greater(in[0], in[1], entry);
    greater(entry, in[2], entry);
    lesser(out[0], out[1], exit);
    lesser(exit, out[2], exit);
    Four nearest;
    load(&rays.nearest[first], nearest);
    const FourMask inside = entry < 0.0;
    const Four at = inside ? exit : entry;
    const FourMask met = (entry <= exit) & (exit >= 0.0) & (at < nearest);
    Four axis;
    load(&rays.axis[first], axis);
    const FourMask x = inside ? (out[0] == exit) : (in[0] == entry);
    const FourMask y = inside ? (out[1] == exit) : (in[1] == entry);
    const Four face = x ? Four{} : (y ? Four{} + 1.0 : Four{} + 2.0);
    nearest = met ? at : nearest;
    axis = met ? face : axis;
    store(nearest, &rays.nearest[first]);
    store(axis, &rays.axis[first]);
}

/// Shortens four rays to the front of the disc.
[[gnu::always_inline]] inline void meetFour(const Surfel& disc, Rays& rays, std::size_t first) {
    Four nearest;
    load(&rays.nearest[first], nearest);
    FourVectors direction;
    FourVectors away;
    Four towards{};
    Four height{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        Four origin;
        load(&rays.origin[axis][first], origin);
        load(&rays.direction[axis][first], direction[axis]);
        away[axis] = origin - disc.centre[i];
        towards -= direction[axis] * disc.normal[i];
        height += away[axis] * disc.normal[i];
    }
    const Four at = height / towards;
    Four squared{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Four across = away[axis] + at * direction[axis];
        squared += across * across;
    }
    const FourMask met = (towards > 0.0) & (at >= 0.0) & (at < nearest) &
                         (squared <= Four{} + disc.radius * disc.radius);
    if (bitsOf(met) == 0) return;
    store(met ? at : nearest, &rays.nearest[first]);
    Four axis;
    load(&rays.axis[first], axis);
    store(met ? Four{} + ViewRays::Disc : axis, &rays.axis[first]);
    for (std::size_t k = 0; k < 3; ++k) {
        Four normal;
        load(&rays.normal[k][first], normal);
        store(met ? Four{} + disc.normal[static_cast<Eigen::Index>(k)] : normal,
              &rays.normal[k][first]);
    }
}

/// Calls `visit` with the first of each four rays that may meet the body of that lane.
template <typename Visit>
[[gnu::always_inline]] inline void forRaysTo(const Cells& cells, std::size_t lane, const Rays& rays,
                                             const Visit& visit) {
    const auto firstColumn = static_cast<std::size_t>(cells.first[0][lane]);
    const auto lastColumn = static_cast<std::size_t>(cells.last[0][lane]);
    const auto firstRow = static_cast<std::size_t>(cells.first[1][lane]);
    const auto lastRow = static_cast<std::size_t>(cells.last[1][lane]);
    const Four left = Four{} + cells.lower[0][lane];
    const Four right = Four{} + cells.upper[0][lane];
    const Four bottom = Four{} + cells.lower[1][lane];
    const Four top = Four{} + cells.upper[1][lane];
    const std::array<ViewRays::Column, 2>& ndc = rays.ndc();
    for (std::size_t row = firstRow; row <= lastRow; ++row)
        for (std::size_t column = firstColumn / 4 * 4; column <= lastColumn; column += 4) {
            const std::size_t first = row * ViewRays::Columns + column;
            Four x;
            Four y;
            load(&ndc[0][first], x);
            load(&ndc[1][first], y);
            // Most small bodies lie beside the few rays of their cells.
            if (bitsOf((x >= left) & (x <= right) & (y >= bottom) & (y <= top)) != 0) visit(first);
        }
}

LIXEL_MULTIVERSION
void meetBlock(const BoxSet::Block& block, unsigned lanes, const ClipRows& rows, Rays& rays) {
    for (std::size_t part = 0; part < BoxSet::BlockSize; part += 4) {
        FourVectors centre;
        FourVectors half;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            load(block.centre[axis].data() + part, centre[axis]);
            load(block.halfExtents[axis].data() + part, half[axis]);
        }
        Cells cells;
        unsigned rest = findCells(centre, half, rows, cells) & (lanes >> part);
        for (; rest != 0; rest &= rest - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
            std::array<double, 3> lower;
            std::array<double, 3> upper;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double at = block.centre[axis][part + lane];
                lower[axis] = at - block.halfExtents[axis][part + lane];
                upper[axis] = at + block.halfExtents[axis][part + lane];
            }
            forRaysTo(
                cells, lane, rays, [&](std::size_t first) __attribute__((always_inline)) {
                    meetFour(lower, upper, rays, first);
                });
        }
    }
}

/// Four discs at most, with their bounds.
struct FourDiscs {
    explicit FourDiscs(std::span<const Surfel> some) : discs(some) {
        for (std::size_t lane = 0; lane < discs.size(); ++lane) {
            // Half extent along an axis: the radius times the sine of its angle to the normal.
            const Surfel& disc = discs[lane];
            const Vec3 reach =
                disc.radius * (Vec3::Ones() - disc.normal.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                centre[axis][lane] = disc.centre[static_cast<Eigen::Index>(axis)];
                half[axis][lane] = reach[static_cast<Eigen::Index>(axis)];
            }
        }
    }
    std::span<const Surfel> discs;
    std::array<std::array<double, 4>, 3> centre{};
    std::array<std::array<double, 4>, 3> half{};
};

LIXEL_MULTIVERSION
void meetDiscs(const FourDiscs& four, const ClipRows& rows, Rays& rays) {
    FourVectors centre;
    FourVectors half;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        load(four.centre[axis].data(), centre[axis]);
        load(four.half[axis].data(), half[axis]);
    }
    Cells cells;
    unsigned rest = findCells(centre, half, rows, cells) & ((1U << four.discs.size()) - 1);
    for (; rest != 0; rest &= rest - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
        const Surfel& disc = four.discs[lane];
        forRaysTo(
            cells, lane, rays, [&](std::size_t first) __attribute__((always_inline)) {
                meetFour(disc, rays, first);
            });
    }
}

} // namespace

void ViewRays::meet(const BoxSet& boxes, std::span<const KnownSurface> surfaces) {
    const ClipRows rows = clipRows(mClipFromWorld);
    std::size_t first = 0;
    for (const BoxSet::Block& block : boxes.blocks()) {
        unsigned lanes = boxes.lanes(first / BoxSet::BlockSize);
        for (; !surfaces.empty() && surfaces[0].receiver < first + BoxSet::BlockSize;
             surfaces = surfaces.subspan(1))
            if (surfaces[0].receiver >= first) lanes &= ~(1U << (surfaces[0].receiver - first));
        meetBlock(block, lanes, rows, mRays[0]);
        first += BoxSet::BlockSize;
    }
}

void ViewRays::meet(std::span<const Surfel> discs) {
    const ClipRows rows = clipRows(mClipFromWorld);
    while (!discs.empty()) {
        const std::size_t count = std::min<std::size_t>(discs.size(), 4);
        meetDiscs(FourDiscs(discs.first(count)), rows, mRays[0]);
        discs = discs.subspan(count);
    }
}

} // namespace Lixel

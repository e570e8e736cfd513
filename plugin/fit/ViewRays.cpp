#include "fit/ViewRays.h"

#include "fit/Lanes.h"
#include "fit/LowDiscrepancy.h"
#include "fit/VectorClones.h"

#include <Eigen/LU>

#include <bit>
#include <limits>

namespace Lixel {
namespace {

using Rays = ViewRays::Rays;
static_assert(ViewRays::Columns % 4 == 0);

constexpr double Infinity = std::numeric_limits<double>::infinity();

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
        // The bounds of x / w are those at one of w's.
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

/// Shortens the rays of those cells to the box.
[[gnu::always_inline]] inline void meetCells(const Cells& cells, std::size_t lane,
                                             const std::array<double, 3>& lower,
                                             const std::array<double, 3>& upper, Rays& rays) {
    const auto firstColumn = static_cast<std::size_t>(cells.first[0][lane]);
    const auto lastColumn = static_cast<std::size_t>(cells.last[0][lane]);
    const auto firstRow = static_cast<std::size_t>(cells.first[1][lane]);
    const auto lastRow = static_cast<std::size_t>(cells.last[1][lane]);
    const Four left = Four{} + cells.lower[0][lane];
    const Four right = Four{} + cells.upper[0][lane];
    const Four bottom = Four{} + cells.lower[1][lane];
    const Four top = Four{} + cells.upper[1][lane];
    for (std::size_t row = firstRow; row <= lastRow; ++row)
        for (std::size_t column = firstColumn / 4 * 4; column <= lastColumn; column += 4) {
            const std::size_t first = row * ViewRays::Columns + column;
            Four x;
            Four y;
            load(&rays.ndc[0][first], x);
            load(&rays.ndc[1][first], y);
            // Most small bodies lie beside the few rays of their cells.
            if (bitsOf((x >= left) & (x <= right) & (y >= bottom) & (y <= top)) != 0)
                meetFour(lower, upper, rays, first);
        }
}

LIXEL_VECTOR_CLONES
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
            meetCells(cells, lane, lower, upper, rays);
        }
    }
}

/// Where rays through the picture's points start and go, given by homogeneous points of the middle
/// and by how they change across and up.
struct Pencil {
    std::array<double, 4> nearMiddle, farMiddle, across, up;
};

LIXEL_VECTOR_CLONES
void castRays(const Pencil& pencil, Rays& rays) {
    for (std::size_t i = 0; i < ViewRays::Count; i += 4) {
        Four x;
        Four y;
        load(&rays.ndc[0][i], x);
        load(&rays.ndc[1][i], y);
        std::array<Four, 4> begin;
        std::array<Four, 4> end;
        for (std::size_t k = 0; k < 4; ++k) {
            const Four beside = pencil.across[k] * x + pencil.up[k] * y;
            begin[k] = pencil.nearMiddle[k] + beside;
            end[k] = pencil.farMiddle[k] + beside;
        }
        const Four scale = 1.0 / begin[3];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Four origin = begin[axis] * scale;
            // Also right where the far point is at infinity.
            const Four direction = end[axis] - end[3] * origin;
            store(origin, &rays.origin[axis][i]);
            store(direction, &rays.direction[axis][i]);
            store(1.0 / direction, &rays.inverse[axis][i]);
        }
        store(Four{} + Infinity, &rays.nearest[i]);
    }
}

/// One point in each cell of the picture.
void placeRays(std::array<ViewRays::Column, 2>& ndc) {
    for (std::size_t i = 0; i < ViewRays::Count; ++i) {
        const Vec2 within = lowDiscrepancy(i);
        const auto column = static_cast<double>(i % ViewRays::Columns);
        const auto row = static_cast<double>(i / ViewRays::Columns);
        ndc[0][i] = 2.0 * (column + within.x()) / CellCounts[0] - 1.0;
        ndc[1][i] = 2.0 * (row + within.y()) / CellCounts[1] - 1.0;
    }
}

std::array<double, 4> parts(const Vec4& v) {
    return {v.x(), v.y(), v.z(), v.w()};
}

} // namespace

void ViewRays::cast(const Mat4& clipFromWorld) {
    if (mRays.empty()) {
        mRays.resize(1);
        placeRays(mRays[0].ndc);
    }
    mClipFromWorld = clipFromWorld;
    const Mat4 worldFromClip = clipFromWorld.inverse();
    const Vec4 middle = worldFromClip.col(3);
    castRays({parts(middle - worldFromClip.col(2)), parts(middle + worldFromClip.col(2)),
              parts(worldFromClip.col(0)), parts(worldFromClip.col(1))},
             mRays[0]);
}

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

void ViewRays::meet(const Surfel& disc) {
    Rays& rays = mRays[0];
    // Where a disc ends along an axis: its radius by the sine to its normal.
    const Vec3 half =
        disc.radius * (Vec3::Ones() - disc.normal.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
    FourVectors centres;
    FourVectors halves;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        centres[axis] = Four{} + disc.centre[static_cast<Eigen::Index>(axis)];
        halves[axis] = Four{} + half[static_cast<Eigen::Index>(axis)];
    }
    Cells cells;
    if (findCells(centres, halves, clipRows(mClipFromWorld), cells) == 0) return;
    const auto meetOne = [&](std::size_t i) {
        const Vec3 origin(rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]);
        const Vec3 direction(rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]);
        const double towards = -direction.dot(disc.normal);
        if (!(towards > 0.0)) return;
        const Vec3 away = origin - disc.centre;
        const double t = away.dot(disc.normal) / towards;
        if (!(t >= 0.0) || !(t < rays.nearest[i])) return;
        if ((away + t * direction).squaredNorm() > disc.radius * disc.radius) return;
        rays.nearest[i] = t;
        rays.axis[i] = Disc;
        for (std::size_t axis = 0; axis < 3; ++axis)
            rays.normal[axis][i] = disc.normal[static_cast<Eigen::Index>(axis)];
    };
    const auto lastColumn = static_cast<std::size_t>(cells.last[0][0]);
    const auto lastRow = static_cast<std::size_t>(cells.last[1][0]);
    for (auto row = static_cast<std::size_t>(cells.first[1][0]); row <= lastRow; ++row)
        for (auto column = static_cast<std::size_t>(cells.first[0][0]); column <= lastColumn;
             ++column)
            meetOne(row * Columns + column);
}

VisiblePoint ViewRays::point(std::size_t ray) const {
    const Rays& rays = mRays[0];
    const auto at = [ray](const Columns3& columns) {
        return Vec3(columns[0][ray], columns[1][ray], columns[2][ray]);
    };
    VisiblePoint point;
    point.ws = at(rays.origin) + rays.nearest[ray] * at(rays.direction);
    if (rays.axis[ray] == Disc) {
        point.wsNormal = at(rays.normal);
    } else {
        const auto axis = static_cast<std::size_t>(rays.axis[ray]);
        point.wsNormal.setZero();
        point.wsNormal[static_cast<Eigen::Index>(axis)] =
            rays.direction[axis][ray] > 0.0 ? -1.0 : 1.0;
    }
    return point;
}

} // namespace Lixel

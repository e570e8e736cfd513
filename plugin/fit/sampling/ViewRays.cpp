#include "fit/sampling/ViewRays.h"

#include "fit/geometry/LowDiscrepancy.h"
#include "fit/geometry/Multiversion.h"
#include "fit/geometry/Simd.h"

#include <Eigen/LU>

#include <limits>

namespace Lixel {
namespace {

using Rays = ViewRays::Rays;

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Where rays through the picture's points start and go, given by homogeneous points of the middle
/// and by how they change across and up.
struct Pencil {
    std::array<double, 4> nearMiddle, farMiddle, across, up;
};

LIXEL_MULTIVERSION
void castRays(const Pencil& pencil, Rays& rays) {
    for (std::size_t i = 0; i < ViewRays::Count; i += 4) {
        Four x;
        Four y;
        load(&rays.ndc()[0][i], x);
        load(&rays.ndc()[1][i], y);
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

void placeRays(Rays& rays) {
    for (std::size_t round = 0; round < ViewRays::Rounds; ++round)
        for (std::size_t i = 0; i < ViewRays::Count; ++i) {
            const Vec2 place = ViewRays::placeOf(i, round);
            rays.places[round][0][i] = place.x();
            rays.places[round][1][i] = place.y();
        }
}

} // namespace

/// One point in each cell of the picture; half a cell away from it, across and up, that of the next
/// round; those of later rounds between them.
Vec2 ViewRays::placeOf(std::size_t ray, std::size_t round) {
    const Vec2 shift =
        round < 2 ? Vec2(Vec2::Constant(0.5 * static_cast<double>(round))) : lowDiscrepancy(round);
    const Vec2 within = lowDiscrepancy(ray);
    const auto place = [](std::size_t cell, double at, std::size_t cells) {
        return 2.0 * (static_cast<double>(cell) + at - std::floor(at)) /
                   static_cast<double>(cells) -
               1.0;
    };
    return {place(ray % Columns, within.x() + shift.x(), Columns),
            place(ray / Columns, within.y() + shift.y(), Rows)};
}

void ViewRays::cast(const Mat4& clipFromWorld, std::size_t round) {
    if (mRays.empty()) {
        mRays.resize(1);
        placeRays(mRays[0]);
    }
    mRays[0].round = round;
    mClipFromWorld = clipFromWorld;
    const Mat4 worldFromClip = clipFromWorld.inverse();
    const Vec4 middle = worldFromClip.col(3);
    castRays({parts(middle - worldFromClip.col(2)), parts(middle + worldFromClip.col(2)),
              parts(worldFromClip.col(0)), parts(worldFromClip.col(1))},
             mRays[0]);
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

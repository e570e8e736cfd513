#include "fit/geometry/Cone.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <utility>

namespace Lixel {
namespace {

/// Rounding within which a direction counts as inside a cone, as a chord on the unit sphere: some
/// units in the last place of 1, and of the chord that it is compared with.
constexpr double UnitRounding = 0x1p-50;
constexpr double ChordRounding = 1e-12;

/// A cone by its axis and the chord between axis and rim, both on the unit sphere. Chords keep
/// their precision where cosines of small angles are all 1.
struct Cone {
    Vec3 axis;
    double reach;

    Cone(const Vec3& unitAxis, const Vec3& rim)
        : axis(unitAxis), reach((rim - unitAxis).norm() * (1.0 + ChordRounding) + UnitRounding) {}
    bool holds(const Vec3& direction) const { return (direction - axis).norm() <= reach; }
};

Cone through(const Vec3& a, const Vec3& b) {
    const Vec3 sum = a + b;
    const double length = sum.norm();
    return {length > 0.0 ? Vec3(sum / length) : a, a};
}

Cone through(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 normal = ab.cross(ac);
    const double length = normal.norm();
    // Two of the three are one direction.
    if (!(length > 0.0)) return through(a, ab.squaredNorm() > ac.squaredNorm() ? b : c);
    // The axis runs through the centre of the circle through the three, which is exact where they
    // are close together; and across its plane, which is exact where the cone is wide.
    const Vec3 unit = normal / length;
    const Vec3 centre =
        a +
        (ac.squaredNorm() * unit.cross(ab) + ab.squaredNorm() * ac.cross(unit)) / (2.0 * length);
    constexpr double Wide = 0.5; // its plane cuts the sphere at 60°
    if (centre.norm() > Wide) return {centre.normalized(), a};
    return {unit * std::copysign(1.0, unit.dot(a)), a};
}

/// A fixed order that has nothing to do with how the directions came: a linear congruential
/// generator (Knuth's MMIX constants) deals them.
void shuffle(std::span<Vec3> directions) {
    std::uint64_t random = 1;
    for (std::size_t i = directions.size(); i > 1; --i) {
        random = random * 6364136223846793005U + 1442695040888963407U;
        std::swap(directions[i - 1], directions[(random >> 32U) % i]);
    }
}

/// Whether the cone holds all directions, with a slack for the rounding of its axis.
bool holdsAll(const Cone& cone, std::span<const Vec3> directions) {
    constexpr double AxisRounding = 1e-6;
    for (const Vec3& direction : directions)
        if (!((direction - cone.axis).norm() <= cone.reach + AxisRounding)) return false;
    return true;
}

} // namespace

Vec3 smallestConeAxis(std::span<Vec3> directions, double widest) {
    if (directions.empty()) return Vec3::Zero();
    shuffle(directions);
    // Cones only grow. If no half space holds all directions, the cones also stop holding earlier
    // ones. In a random order, either shows after a few directions.
    const double widestReach = 2.0 * std::sin(widest / 2.0) * (1.0 + ChordRounding);
    Cone cone(directions[0], directions[0]);
    for (std::size_t i = 1; i < directions.size(); ++i) {
        if (cone.holds(directions[i])) continue;
        cone = Cone(directions[i], directions[i]);
        for (std::size_t j = 0; j < i; ++j) {
            if (cone.holds(directions[j])) continue;
            cone = through(directions[i], directions[j]);
            for (std::size_t k = 0; k < j; ++k)
                if (!cone.holds(directions[k]))
                    cone = through(directions[i], directions[j], directions[k]);
        }
        if (!(cone.reach <= widestReach) || !holdsAll(cone, directions.first(i)))
            return Vec3::Zero();
    }
    return cone.axis;
}

} // namespace Lixel

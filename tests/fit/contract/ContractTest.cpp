/** The contract of a fit (plugin/README.md), which every technique passes, for any valid scene.

    What a fit says is checked against rays and points (Oracle.h), never against its own hulls.
*/
#include "fit/Oracle.h"
#include "fit/Trials.h"

#include "fit/geometry/Polygon2.h"
#include "fit/problem/SeenPicture.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <iomanip>
#include <limits>
#include <numbers>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

constexpr std::size_t RaysPerScene = 150;

/// Most that two points of one light ray may differ in float, in texels.
constexpr double FloatTexels = 0.25;

/// What an earlier frame may have shown: points of the scene or of none, some of them not finite.
SeenSurfaces anythingSeen(const Scene& scene, Dice& dice) {
    SeenSurfaces seen;
    const double spread = dice.chance(0.5) ? 1.0 : 10.0;
    for (std::size_t i = dice.below(1000); i > 0; --i)
        seen.points.push_back({scene.size * spread * dice.cube(), dice.direction()});
    for (std::size_t i = dice.below(100); i > 0; --i) {
        const Vec3 at = scene.size * dice.cube();
        seen.empty.emplace_back(at.x(), at.y(), at.z(), dice.chance(0.5) ? 0.0 : 1.0);
    }
    if (!seen.points.empty() && dice.chance(0.1))
        seen.points.front().ws.setConstant(std::numeric_limits<double>::quiet_NaN());
    return seen;
}

class Contract : public testing::TestWithParam<Trial> {
protected:
    /** Checks `property(scene, fit, state, dice)` for any scene. It returns whether it had
        something to check, so that a property that never has is noticed. */
    template <typename Property>
    void forAny(const rc::Gen<Scene>& scenes, const Property& property) {
        std::size_t checked = 0;
        const bool holds = rc::check([&] {
            const Scene scene = *scenes;
            Dice dice(*anySeed());
            FitState state;
            // Every other time with options drawn at random.
            mTrial = dice.chance(0.5) ? drawn(GetParam(), dice) : GetParam();
            RC_LOG() << mTrial.name << "\n";
            ShadowProblem problem = scene.problem();
            SeenPicture seen;
            if (mMayHaveSeen && dice.chance(0.3)) {
                seen.take(anythingSeen(scene, dice), scene.viewer, scene.size * dice.cube());
                problem.seen = &seen;
            }
            const ShadowFit fit = mTrial.fit(problem, state);
            RC_LOG() << std::setprecision(9) << "reason: " << toString(fit.reason) << "\n";
            if (property(scene, fit, state, dice)) ++checked;
        });
        EXPECT_TRUE(holds);
        EXPECT_GT(checked, 0U);
    }

    template <typename Property>
    void forAnyScene(const Property& property) {
        forAny(anySceneOfHulls(), property);
    }

    /// The same over the fits that have a map and at least one shadowed point that it serves.
    template <typename Property>
    void forAnyShadow(const Property& property, const rc::Gen<Scene>& scenes = anySceneOfHulls()) {
        forAny(scenes,
               [&](const Scene& scene, const ShadowFit& fit, const FitState& state, Dice& dice) {
                   if (!fit.hasMap()) return false;
                   auto points = shadowedPoints(scene, dice, RaysPerScene);
                   std::erase_if(points, [&](const ShadowedPoint& point) {
                       return !isServed(scene, fit, point);
                   });
                   if (points.empty()) return false;
                   property(scene, fit, state, points);
                   return true;
               });
    }

    /// Whether a map promises a place for the receiver's light ray. Only a technique that may leave
    /// something out has any that it does not; near its borders rounding decides.
    static bool isServed(const Scene& scene, const ShadowFit& fit, const ShadowedPoint& point) {
        if (GetParam().servesAll()) return true;
        constexpr double Rounding = 1e-6;
        const auto isInside = [&](const Vec3& ws) {
            return servedMargin(fit, ws) > Rounding * (ws.norm() + scene.size);
        };
        return isInside(point.wsReceiver) && isInside(point.wsOccluder);
    }

    /// Texels that the map keeps free between what it serves and its border.
    static double border(const Scene& scene, const ShadowFit& fit) {
        const bool keepsNone = !GetParam().servesAll() && fit.servedCount > 0;
        return keepsNone ? 0.0 : scene.filterRadius + 1.0;
    }

    /** Receiver and occluder meet within a quarter of a texel when the graphics card computes both.

        Where texels are as fine as the steps of float it is within those steps: a caster 5 units
        before a light that is 7000 from the viewer, the near end of a strong warp. Texels coarser
        than the steps would cost all other shadows, and mend nothing. Such scenes are rare. */
    void isOneTexelInFloat(const rc::Gen<Scene>& scenes);

    static void liesInsideTheBorder(const Scene& scene, const ShadowFit& fit, const FitState&,
                                    const std::vector<ShadowedPoint>& points);

    /// What this case is tried with.
    Trial mTrial;
    /// Whether problems may know what an earlier frame showed.
    bool mMayHaveSeen = true;
};

void expectInvertible(const Mat4& m) {
    RC_ASSERT(m.allFinite());
    const Mat4 inverse = m.inverse();
    RC_ASSERT(inverse.allFinite());
    // Relative to the sizes of what is summed, which span the square of the scene's scale.
    const Mat4 error = m * inverse - Mat4::Identity();
    const Mat4 scale = m.cwiseAbs() * inverse.cwiseAbs();
    RC_ASSERT((error.array().abs() <= 1e-9 * (scale.array() + 1.0)).all());
}

/** Texels by which four products and their sum in float may miss a point's address, whatever the
    order: Higham, Accuracy and Stability of Numerical Algorithms, (3.5), for factors that are
    rounded too. */
double texelsOfRounding(const Scene& scene, const ShadowFit& fit, const Vec3& ws) {
    const Vec4 clip = clipOf(fit.clipFromWorld, ws);
    const Mat4 magnitudes = fit.clipFromWorld.cwiseAbs();
    const Vec4 error = 6.0 * 0x1p-24 * (magnitudes * Vec4(ws.cwiseAbs().homogeneous()));
    const Vec2 ndc = clip.head<2>() / clip.w();
    const Vec2 miss = (error.head<2>() + ndc.cwiseAbs() * error.w()) / clip.w();
    return miss.cwiseProduct(Vec2(scene.mapWidth, scene.mapHeight) / 2.0).norm();
}

/// Every shadowed point is w > 0 and within the map's border with the matrix of the graphics card.
void Contract::liesInsideTheBorder(const Scene& scene, const ShadowFit& fit, const FitState&,
                                   const std::vector<ShadowedPoint>& points) {
    const Mat4 rounded = roundedToFloat(fit.clipFromWorld);
    for (const ShadowedPoint& point : points) {
        const Vec3& x = point.wsReceiver;
        const Vec2 texel = texelOf(rounded, scene, x);
        RC_LOG() << "receiver " << x.transpose() << " clip " << clipOf(rounded, x).transpose()
                 << " texel " << texel.transpose() << " unrounded "
                 << texelOf(fit.clipFromWorld, scene, x).transpose() << "\n";
        RC_ASSERT(clipOf(rounded, x).w() > 0.0);
        // A map that keeps no border has the fine texels that it has.
        const double free = border(scene, fit);
        const double rounding = free > 0.0 ? 0.0 : texelsOfRounding(scene, fit, x);
        RC_ASSERT(insideBorder(texel, scene) >= free - rounding);
    }
}

void Contract::isOneTexelInFloat(const rc::Gen<Scene>& scenes) {
    std::size_t checked = 0;
    std::size_t excused = 0;
    const auto meets = [&](const Scene& scene, const ShadowFit& fit, const FitState&,
                           const std::vector<ShadowedPoint>& points) {
        const Eigen::Matrix4f m = fit.clipFromWorld.cast<float>();
        const Eigen::Vector2f size(static_cast<float>(scene.mapWidth),
                                   static_cast<float>(scene.mapHeight));
        const auto texel = [&](const Vec3& ws) {
            const Eigen::Vector4f clip = m * Eigen::Vector3f(ws.cast<float>()).homogeneous();
            return Eigen::Vector2f(clip.head<2>() / clip.w()).cwiseProduct(size / 2.0F).eval();
        };
        bool within = true;
        for (const ShadowedPoint& point : points) {
            const Eigen::Vector2f receiver = texel(point.wsReceiver);
            const Eigen::Vector2f occluder = texel(point.wsOccluder);
            const double rounding = texelsOfRounding(scene, fit, point.wsReceiver) +
                                    texelsOfRounding(scene, fit, point.wsOccluder);
            const double distance = (receiver - occluder).cast<double>().norm();
            RC_LOG() << "receiver " << point.wsReceiver.transpose() << " occluder "
                     << point.wsOccluder.transpose() << " texels " << receiver.transpose()
                     << " and " << occluder.transpose() << ", of rounding " << rounding << "\n";
            RC_ASSERT(distance <= std::max(FloatTexels, rounding));
            within = within && distance <= FloatTexels;
        }
        ++checked;
        if (!within) ++excused;
    };
    forAnyShadow(meets, scenes);
    // A map that is given whole has the texels that it has.
    const std::size_t allowed = GetParam().servesAll() ? 1 + checked / 1000 : checked;
    EXPECT_LE(excused, allowed);
}

/// One receiver at distance 1, of a size from a thousandth down to a millionth, and a caster over
/// it: what an address in float can still tell apart.
rc::Gen<Scene> smallFarReceiver() {
    return rc::gen::map(anySeed(), [](std::uint64_t seed) {
        Dice dice(seed);
        Scene scene;
        const Vec3 at = dice.direction();
        scene.viewer.viewFromWorld = lookAlong(Vec3::Zero(), at);
        scene.viewer.clipFromView = perspective(dice.in(0.1, 1.5), 1.5, 1e-3, 10.0);
        scene.light.wsDirection = dice.direction();
        const double size = std::pow(10.0, dice.in(-6.0, -3.0));
        scene.receivers.add({at, size * dice.cube().cwiseAbs()});
        scene.casters.add({at - 0.3 * scene.light.wsDirection, Vec3::Constant(0.05)});
        return scene;
    });
}

/// A narrow view down onto a floor, across the edge of a thin wall: the best warp makes texels at
/// its near end finer than float positions are.
Scene narrowViewOfFloor() {
    Scene scene;
    scene.viewer.viewFromWorld << //
        -0.99983985450815693,
        0.0, -0.017895958680876033, 0.67351483294963732, -0.00052811764627213036,
        0.99956447207147325, 0.029505715789128608, -0.95232379603599371, 0.017888164491062751,
        0.029510441753337703, -0.99940439632746447, -1.0187716700644984, //
        0.0, 0.0, 0.0, 1.0;
    scene.viewer.clipFromView << //
        9.190197650286267,
        0.0, 0.44979224773470983, 0.0, //
        0.0, 6.5465222130652903, 0.86585974245958874, 0.0, 0.0, 0.0, -1.0044616654603671,
        -0.072143657557836055, //
        0.0, 0.0, -1.0, 0.0;
    scene.viewer.shadowDistance = 0.61787400237458401;
    scene.light.wsDirection = Vec3(0.78503598111435791, 0.52398943711057788, -0.77003584661726643);
    scene.mapWidth = 2048;
    scene.mapHeight = 1024;
    scene.filterRadius = 2.5;
    scene.depthClamp = false;
    for (const Aabb& box :
         {Aabb{{0.69112798879674797, 0.68197343445520819, -0.97801269702984661}, {20.0, 0.0, 20.0}},
          Aabb{{0.75490187448904389, 0.88784583858416721, -0.69665216881486824},
               {0.31603505245445007, 0.20700237709176458, 0.0050343761086320089}},
          Aabb{{0.70860291114986163, 0.92171757986399427, -0.88937727079179874},
               {0.0059723448075804705, 0.092504118199390806, 0.44309975247468358}}}) {
        scene.addBody(box);
    }
    return scene;
}

} // namespace

INSTANTIATE_TEST_SUITE_P(EveryTechnique, Contract, testing::ValuesIn(trials()), ByName{});

/// Clause 2.
TEST_P(Contract, MatricesAreFiniteAndInvertible) {
    forAnyScene([](const Scene&, const ShadowFit& fit, const FitState&, Dice&) {
        if (!fit.hasMap()) return false;
        expectInvertible(fit.clipFromLight);
        expectInvertible(fit.clipFromWorld);
        RC_ASSERT(fit.lsFromWs.isUnitary(1e-12));
        RC_ASSERT(fit.lsNear < fit.lsFar);
        RC_ASSERT(fit.depthScale > 0.0);
        RC_ASSERT(std::isfinite(fit.depthOffset));
        RC_ASSERT(std::abs(fit.depthPerWorldUnit * (fit.lsFar - fit.lsNear) - 1.0) < 1e-9);
        RC_ASSERT(fit.mapAngle >= 0.0);
        RC_ASSERT(fit.mapAngle < std::numbers::pi);
        RC_ASSERT(std::abs(fit.mapSkew) < std::numbers::pi / 2.0);
        return true;
    });
}

/// Clause 2.
TEST_P(Contract, ValidInputIsNotCalledInvalid) {
    forAnyScene([](const Scene&, const ShadowFit& fit, const FitState&, Dice&) {
        RC_ASSERT(fit.reason < FitReason::Unbounded);
        return true;
    });
}

/// Clause 2.
TEST_P(Contract, NothingToDrawOnlyWhereTheOracleFindsNoShadow) {
    forAnyScene([](const Scene& scene, const ShadowFit& fit, const FitState&, Dice& dice) {
        if (fit.hasMap()) return false;
        const auto points = shadowedPoints(scene, dice, 3 * RaysPerScene);
        if (!points.empty())
            RC_LOG() << "shadowed: " << points[0].wsReceiver.transpose() << " by "
                     << points[0].wsOccluder.transpose() << "\n";
        RC_ASSERT(points.empty());
        return true;
    });
}

/// Clause 3.
TEST_P(Contract, ShadowedPointsLieInsideTheMapsBorder) {
    forAnyShadow(liesInsideTheBorder);
}

/// Clause 3.
TEST_P(Contract, ShadowedPointsOfASmallFarReceiverLieInsideTheMapsBorder) {
    forAnyShadow(liesInsideTheBorder, smallFarReceiver());
}

/// Clause 3.
TEST_P(Contract, ShadowedPointsOfANarrowViewOfAFloorLieInsideTheMapsBorder) {
    const Scene scene = narrowViewOfFloor();
    FitState state;
    const ShadowFit fit = GetParam().fit(scene.problem(), state);
    ASSERT_TRUE(fit.hasMap());
    Dice dice(1);
    const auto points = shadowedPoints(scene, dice, 100 * RaysPerScene);
    ASSERT_FALSE(points.empty());
    const Mat4 rounded = roundedToFloat(fit.clipFromWorld);
    double least = 1e30;
    for (const ShadowedPoint& point : points)
        least = std::min(least, insideBorder(texelOf(rounded, scene, point.wsReceiver), scene));
    EXPECT_GE(least, border(scene, fit));
}

/// Clause 4.
TEST_P(Contract, OccludersAreDrawn) {
    forAnyShadow([](const Scene& scene, const ShadowFit& fit, const FitState&,
                    const std::vector<ShadowedPoint>& points) {
        constexpr double Rounding = 1e-9;
        for (const ShadowedPoint& point : points) {
            const Vec4 clip = clipOf(fit.clipFromWorld, point.wsOccluder);
            RC_LOG() << "receiver " << point.wsReceiver.transpose() << " occluder "
                     << point.wsOccluder.transpose() << " clip " << clip.transpose() << "\n";
            RC_ASSERT(clip.w() > 0.0);
            RC_ASSERT(insideBorder(texelOf(fit.clipFromWorld, scene, point.wsOccluder), scene) >=
                      border(scene, fit));
            RC_ASSERT(clip.z() <= (1.0 + Rounding) * clip.w());
            // In front of the range it is clamped, if the render system can.
            RC_ASSERT(scene.depthClamp || clip.z() >= -(1.0 + Rounding) * clip.w());
        }
    });
}

/// Clause 4.
TEST_P(Contract, StoredDepthOfReceiversIsBetweenZeroAndOne) {
    forAnyShadow([](const Scene&, const ShadowFit& fit, const FitState&,
                    const std::vector<ShadowedPoint>& points) {
        for (const ShadowedPoint& point : points) {
            const Vec4 clip = clipOf(fit.clipFromWorld, point.wsReceiver);
            const double stored = fit.depthScale * clip.z() + fit.depthOffset;
            RC_LOG() << "receiver " << point.wsReceiver.transpose() << " stored " << stored << "\n";
            RC_ASSERT(stored >= 0.0);
            RC_ASSERT(stored <= 1.0);
            RC_ASSERT(std::abs(clip.z()) <= clip.w());
        }
    });
}

/// Clause 4.
TEST_P(Contract, StoredDepthGrowsAlongTheLight) {
    forAnyShadow([](const Scene& scene, const ShadowFit& fit, const FitState&,
                    const std::vector<ShadowedPoint>& points) {
        for (const ShadowedPoint& point : points) {
            const Vec3 step = (point.wsOccluder - point.wsReceiver) / 4.0;
            if (step.norm() < 1e-6 * scene.size) continue;
            for (int i = 0; i < 4; ++i) {
                const Vec4 far = clipOf(fit.clipFromWorld, point.wsReceiver + i * step);
                const Vec4 near = clipOf(fit.clipFromWorld, point.wsReceiver + (i + 1) * step);
                RC_ASSERT(near.z() < far.z());
                RC_ASSERT(near.z() / near.w() < far.z() / far.w());
            }
        }
    });
}

/// Clause 4.
TEST_P(Contract, WindingSeenFromTheLightIsKept) {
    forAnyShadow([](const Scene& scene, const ShadowFit& fit, const FitState&,
                    const std::vector<ShadowedPoint>& points) {
        for (const ShadowedPoint& point : points) {
            const Vec3 normal = towardsLight(scene.light, point.wsReceiver);
            const Vec3 a = normal.unitOrthogonal();
            const Vec3 b = normal.cross(a); // counter-clockwise for who looks against the normal
            const Vec3& x = point.wsReceiver;
            // The Jacobian of the dehomogenised map along a and b, exactly.
            const Vec4 clip = clipOf(fit.clipFromWorld, x);
            const auto derivative = [&](const Vec3& d) {
                const Vec4 step = fit.clipFromWorld * Vec4(d.x(), d.y(), d.z(), 0.0);
                return Vec2((step.head<2>() * clip.w() - clip.head<2>() * step.w()) /
                            (clip.w() * clip.w()));
            };
            RC_ASSERT(cross(derivative(a), derivative(b)) > 0.0);
        }
    });
}

/// Clause 5.
TEST_P(Contract, OneRayIsOneTexel) {
    forAnyShadow([](const Scene& scene, const ShadowFit& fit, const FitState&,
                    const std::vector<ShadowedPoint>& points) {
        for (const ShadowedPoint& point : points) {
            const Vec2 receiver = texelOf(fit.clipFromWorld, scene, point.wsReceiver);
            const Vec2 occluder = texelOf(fit.clipFromWorld, scene, point.wsOccluder);
            RC_LOG() << "texels " << receiver.transpose() << " and " << occluder.transpose()
                     << "\n";
            RC_ASSERT((receiver - occluder).norm() <= 0.01);
        }
    });
}

/// Where the map has the receivers' rays, by the fit's own numbers in long double: the whole chain
/// from the world to clip space, without the products of matrices.
/// Clause 5.
TEST_P(Contract, TheMatrixAgreesWithALongerArithmetic) {
    forAnyShadow([](const Scene& scene, const ShadowFit& fit, const FitState&,
                    const std::vector<ShadowedPoint>& points) {
        using Long = long double;
        for (const ShadowedPoint& point : points) {
            std::array<Long, 3> ls{};
            for (Eigen::Index row = 0; row < 3; ++row)
                for (Eigen::Index axis = 0; axis < 3; ++axis)
                    ls[static_cast<std::size_t>(row)] +=
                        Long(fit.lsFromWs(row, axis)) *
                        (Long(point.wsReceiver[axis]) - Long(fit.wsEye[axis]));
            std::array<Long, 4> clip{};
            for (Eigen::Index row = 0; row < 4; ++row) {
                const auto i = static_cast<std::size_t>(row);
                clip[i] = Long(fit.clipFromLight(row, 3));
                for (Eigen::Index axis = 0; axis < 3; ++axis)
                    clip[i] +=
                        Long(fit.clipFromLight(row, axis)) * ls[static_cast<std::size_t>(axis)];
            }
            const Vec2 reference(
                static_cast<double>((clip[0] / clip[3] + 1) * Long(scene.mapWidth) / 2),
                static_cast<double>((clip[1] / clip[3] + 1) * Long(scene.mapHeight) / 2));
            const Vec2 texel = texelOf(fit.clipFromWorld, scene, point.wsReceiver);
            RC_LOG() << "texel " << texel.transpose() << " reference " << reference.transpose()
                     << "\n";
            // Far below what the contract leaves to a light ray in double.
            RC_ASSERT((texel - reference).norm() <= 1e-4);
        }
    });
}

/// Clause 5.
TEST_P(Contract, OneRayIsOneTexelInFloat) {
    isOneTexelInFloat(anySceneOfHulls());
}

/// Clause 5.
TEST_P(Contract, OneRayOfASmallFarReceiverIsOneTexelInFloat) {
    isOneTexelInFloat(smallFarReceiver());
}

/// Clause 6.
TEST_P(Contract, TheMapIsTight) {
    forAnyScene([](const Scene& scene, const ShadowFit& fit, const FitState& state, Dice&) {
        // A map that the technique gives whole is not fitted to the region.
        if (!fit.hasMap() || fit.servedCount > 0) return false;
        const Polygon2& hull = state.region.liHull;
        Vec2 least = Vec2::Constant(std::numeric_limits<double>::infinity());
        Vec2 greatest = -least;
        Vec2 warpedLeast = least;
        Vec2 warpedGreatest = greatest;
        const double across = fit.mapAngle + std::numbers::pi / 2.0 + fit.mapSkew;
        Eigen::Matrix2d axes;
        axes << std::cos(fit.mapAngle), std::sin(fit.mapAngle), std::cos(across), std::sin(across);
        for (const Vec2& q : hull) {
            // The ray's light-space point at depth 0 or, for a local light, 1.
            const Vec4 ls(q.x(), q.y(), fit.directional ? 0.0 : -1.0, 1.0);
            const Vec4 clip = fit.clipFromLight * ls;
            RC_ASSERT(clip.w() > 0.0);
            const Vec2 ndc = clip.head<2>() / clip.w();
            const Vec2 texel =
                (ndc + Vec2::Ones()).cwiseProduct(Vec2(scene.mapWidth, scene.mapHeight)) / 2.0;
            least = least.cwiseMin(texel);
            greatest = greatest.cwiseMax(texel);
            const Vec2 d = q - fit.liCentre;
            const Vec2 warped = axes * Vec2(d / (1.0 + fit.liWarp.dot(d)));
            warpedLeast = warpedLeast.cwiseMin(warped);
            warpedGreatest = warpedGreatest.cwiseMax(warped);
        }
        const Vec2 sides = warpedGreatest - warpedLeast;
        // Where float has steps of 2^-24 of: the farthest that the matrix is used at; for a local
        // light as an angle, seen from it at the nearest receiver (or a 64th of the farthest's
        // depth).
        double reach =
            fit.directional
                ? std::max({std::abs(fit.lsNear), std::abs(fit.lsFar), state.region.vsReceiverFar})
                : std::max(state.region.lsReceiverFar, fit.wsEye.norm()) /
                      std::max(state.region.lsReceiverNear, state.region.lsReceiverFar / 64.0);
        for (const Vec2& q : hull)
            reach = std::max(reach, q.norm());
        const Vec2 size(scene.mapWidth, scene.mapHeight);
        const double border = scene.filterRadius + 1.0;
        RC_LOG() << "warped sides " << sides.transpose() << ", texels " << least.transpose()
                 << " to " << greatest.transpose() << "\n";
        bool checked = false;
        for (Eigen::Index axis = 0; axis < 2; ++axis) {
            // Degenerate: thinner than one texel of a map of 4096, or than what leaves 64 steps of
            // a float's 2^-24 in a texel.
            if (sides[axis] < sides.maxCoeff() / 4000.0) continue;
            if (sides[axis] < reach * size.maxCoeff() * 0x1p-17) continue;
            RC_ASSERT(least[axis] >= border);
            RC_ASSERT(least[axis] <= border + 2.0);
            RC_ASSERT(greatest[axis] <= size[axis] - border);
            RC_ASSERT(greatest[axis] >= size[axis] - border - 2.0);
            checked = true;
        }
        return checked;
    });
}

/// Clause 6.
TEST_P(Contract, TheFocusPolygonHoldsTheFocusRegion) {
    forAnyScene([](const Scene&, const ShadowFit& fit, const FitState& state, Dice&) {
        if (!fit.hasMap()) return false;
        const auto focus = fit.liFocus.span();
        RC_ASSERT(!focus.empty());
        RC_ASSERT(focus.size() <= FocusPolygon::Capacity);
        for (const Vec2& q : focus)
            RC_LOG() << "focus " << q.transpose() << "\n";
        double extent = 0.0;
        for (const Vec2& q : state.region.liHull)
            extent = std::max(extent, q.cwiseAbs().maxCoeff());
        for (const Vec2& q : focus)
            extent = std::max(extent, q.cwiseAbs().maxCoeff());
        // Vertices are exact to some units in their last place; an edge may be as short as that.
        const double rounding = 1e-12 * extent * extent;
        for (std::size_t i = 0; i < focus.size() && focus.size() > 2; ++i) {
            const Vec2 edge = focus[(i + 1) % focus.size()] - focus[i];
            for (const Vec2& q : state.region.liHull) {
                const bool inside = cross(edge, q - focus[i]) >= -rounding;
                if (!inside) RC_LOG() << "vertex " << q.transpose() << " edge " << i << "\n";
                RC_ASSERT(inside);
            }
            // Interior, so that the denominator is 1 somewhere on the region.
            RC_ASSERT(cross(edge, fit.liCentre - focus[i]) >= -rounding);
        }
        for (const Vec2& q : state.region.liHull)
            RC_ASSERT(1.0 + fit.liWarp.dot(q - fit.liCentre) > 0.0);
        return true;
    });
}

/// Clause 8.
TEST_P(Contract, HasNoHiddenUnit) {
    mMayHaveSeen = false; // the scaled problem would have to have seen the same
    forAnyScene([this](const Scene& scene, const ShadowFit& fit, const FitState&, Dice&) {
        for (const double factor : {1024.0, 1.0 / 1024.0}) {
            const Scene other = scaled(scene, factor);
            FitState state;
            const ShadowFit same = mTrial.fit(other.problem(), state);
            RC_ASSERT(same.reason == fit.reason);
            if (!fit.hasMap()) continue;
            // Clip coordinates of the scaled point, up to a positive factor.
            Mat4 unscaled = same.clipFromWorld;
            unscaled.leftCols<3>() *= factor;
            const Mat4 a = fit.clipFromWorld;
            unscaled *= a.norm() / unscaled.norm();
            RC_LOG() << "factor " << factor << "\n" << a << "\nscaled\n" << unscaled << "\n";
            RC_ASSERT((unscaled - a).norm() <= 1e-9 * a.norm());
        }
        return fit.hasMap();
    });
}

/// Clause 3 to 5, from a warm state.
TEST_P(Contract, AUsedStateGivesTheSameGuarantees) {
    // Another scene's fit before this one must not show but in the choice of orientation.
    const bool holds = rc::check([&] {
        const Scene before = *anyScene();
        const Scene scene = *anyScene();
        Dice dice(*anySeed());
        mTrial = drawn(GetParam(), dice);
        FitState used;
        FitState fresh;
        (void)mTrial.fit(before.problem(), used);
        const ShadowFit a = mTrial.fit(scene.problem(), used);
        const ShadowFit b = mTrial.fit(scene.problem(), fresh);
        RC_ASSERT(a.reason == b.reason);
        if (!a.hasMap()) return;
        RC_ASSERT(a.liWarp == b.liWarp);
        RC_ASSERT(a.liCentre == b.liCentre);
        RC_ASSERT(a.lsNear == b.lsNear);
        RC_ASSERT(a.lsFar == b.lsFar);
        RC_ASSERT(used.region.liHull == fresh.region.liHull);
    });
    EXPECT_TRUE(holds);
}

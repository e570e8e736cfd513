// The caster volume against brute force: it shows every box that reaches into the light rays of the
// focus region, before the farthest receiver, and hides those that clearly do not.
#include "scene/CasterVolume.h"

#include "SceneTest.h"

#include "fit/core/FitState.h"
#include "fit/technique/Uniform.h"
#include "fit/technique/Xpsm.h"
#include "scene/OgreMath.h"

#include <Eigen/Geometry>

#include <OgreAxisAlignedBox.h>
#include <OgrePlane.h>
#include <OgreSphere.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <ostream>
#include <random>

namespace Lixel::Tests {
namespace {

/// Rounding of OGRE's floats, relative to the size of a coordinate: what a test allows, which is
/// more than what the volume does.
constexpr double FloatRounding = 0x1p-19;

class Dice {
public:
    explicit Dice(unsigned seed) : mEngine(seed) {}
    double in(double lower, double upper) {
        return std::uniform_real_distribution<double>(lower, upper)(mEngine);
    }
    /// Of any size between two powers of ten.
    double power(double lower, double upper) { return std::pow(10.0, in(lower, upper)); }
    Vec3 cube() { return {in(-1.0, 1.0), in(-1.0, 1.0), in(-1.0, 1.0)}; }
    Vec3 direction() {
        for (;;) {
            const Vec3 v = cube();
            if (v.norm() > 0.1 && v.norm() < 1.0) return v.normalized();
        }
    }

private:
    std::mt19937 mEngine;
};

/// A fit of a random scene, and its volume.
struct Fitted {
    ShadowFit fit;
    FocusRegion region;
    CasterVolume volume;
    Vec3 wsOrigin = Vec3::Zero();
    /// Rough size of the scene: all receivers are within it.
    double size = 100.0;

    /// The world point on the light ray q, at a distance along the light's axis.
    Vec3 wsPoint(const Vec2& q, double depth) const {
        const Vec3 ls = fit.directional ? Vec3(q.x(), q.y(), -depth)
                                        : Vec3(q.x() * depth, q.y() * depth, -depth);
        return wsOrigin + fit.wsEye + fit.lsFromWs.transpose() * ls;
    }
    Vec2 liInside(Dice& dice) const {
        Vec2 sum = Vec2::Zero();
        double total = 0.0;
        for (const Vec2& q : region.liHull) {
            const double weight = dice.power(-3.0, 0.0);
            sum += weight * q;
            total += weight;
        }
        return sum / total;
    }
    /// A depth from the light, or from far behind the viewer, to the farthest receiver.
    double lsDepth(Dice& dice) const {
        if (!fit.directional) return dice.in(fit.lsNear, region.lsReceiverFar);
        return region.lsReceiverFar - size * dice.power(-4.0, 2.0);
    }
};

struct Kind {
    const char* name;
    LightKind light;
    double originDistance;
};
void PrintTo(const Kind& kind, std::ostream* os) {
    *os << kind.name;
}

class CasterVolumeTest : public testing::TestWithParam<Kind> {
protected:
    // A frustum has a vertex buffer, for OGRE to show it with.
    CasterVolumeTest() { ogre(); }

    /// Null where the scene happens to have no shadows.
    std::unique_ptr<Fitted> fitRandom(Dice& dice) const {
        auto fitted = std::make_unique<Fitted>();
        Fitted& result = *fitted;
        ShadowProblem problem;
        const Vec3 forward = (dice.direction() - Vec3(0.0, 0.4, 0.0)).normalized();
        const Vec3 right = forward.cross(Vec3::UnitY()).normalized();
        problem.viewer.viewFromWorld.topLeftCorner<3, 3>() << right.transpose(),
            right.cross(forward).transpose(), -forward.transpose();
        const double tangent = dice.in(0.2, 1.5);
        const double near = dice.power(-3.0, 0.0);
        const double far = dice.power(2.0, 4.0);
        problem.viewer.clipFromView << 1.0 / tangent, 0.0, 0.0, 0.0, //
            0.0, 1.3 / tangent, 0.0, 0.0,                            //
            0.0, 0.0, -(far + near) / (far - near), -2.0 * far * near / (far - near), 0.0, 0.0,
            -1.0, 0.0;
        problem.light.kind = GetParam().light;
        problem.light.wsDirection = dice.direction() - Vec3(0.0, 0.8, 0.0);
        problem.light.wsPosition = 20.0 * dice.cube() + Vec3(0.0, 20.0, 0.0);
        problem.light.outerHalfAngle = dice.in(0.1, 1.4);
        BoxSet casters;
        BoxSet receivers;
        receivers.add({Vec3(0.0, -5.0, 0.0), Vec3(result.size, dice.in(0.0, 1.0), result.size)});
        for (int i = 0; i < 10; ++i) {
            const Aabb box{30.0 * dice.cube(), dice.in(0.1, 3.0) * (dice.cube() + Vec3::Ones())};
            casters.add(box);
            receivers.add(box);
        }
        problem.casters = &casters;
        problem.receivers = &receivers;
        FitState state;
        result.fit = dice.in(0.0, 1.0) < 0.5 ? fitMap(problem, XpsmOptions{}, state)
                                             : fitMap(problem, UniformOptions{}, state);
        if (!result.fit.hasMap()) return nullptr;
        result.region = state.region;
        result.wsOrigin = GetParam().originDistance * dice.direction();
        result.volume.set(result.fit, result.wsOrigin);
        return fitted;
    }

    /// Calls test(fitted, dice) for many scenes with shadows.
    template <typename Test>
    void forScenes(Test&& test) const {
        int scenes = 0;
        for (unsigned seed = 0; scenes < 60; ++seed) {
            ASSERT_LT(seed, 1000U) << "scenes without shadows only";
            Dice dice(seed);
            const std::unique_ptr<Fitted> fitted = fitRandom(dice);
            if (!fitted) continue;
            SCOPED_TRACE(testing::Message() << "seed " << seed);
            ++scenes;
            test(*fitted, dice);
            if (HasFatalFailure()) return;
        }
    }
};

INSTANTIATE_TEST_SUITE_P(Lights, CasterVolumeTest,
                         testing::Values(Kind{"Directional", LightKind::Directional, 0.0},
                                         Kind{"Spot", LightKind::Spot, 0.0},
                                         Kind{"DirectionalFarAway", LightKind::Directional, 1e6},
                                         Kind{"SpotFarAway", LightKind::Spot, 1e6}),
                         [](const auto& test) { return std::string(test.param.name); });

/// As OGRE has it: in floats, which still contain the box.
Ogre::AxisAlignedBox ogreBox(const Vec3& lower, const Vec3& upper) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const auto down = [](double x) { return std::nextafter(static_cast<float>(x), -infinity); };
    const auto up = [](double x) { return std::nextafter(static_cast<float>(x), infinity); };
    return {down(lower.x()), down(lower.y()), down(lower.z()),
            up(upper.x()),   up(upper.y()),   up(upper.z())};
}

/// As the octree asks.
bool visibleByPlanes(const CasterVolume& volume, const Ogre::AxisAlignedBox& box) {
    for (int i = 0; i < 6; ++i)
        if (volume.getFrustumPlanes()[i].getSide(box.getCenter(), box.getHalfSize()) ==
            Ogre::Plane::NEGATIVE_SIDE)
            return false;
    return true;
}

TEST_P(CasterVolumeTest, ShowsEveryBoxThatReachesIntoTheRegionsLight) {
    forScenes([](const Fitted& fitted, Dice& dice) {
        for (int i = 0; i < 300; ++i) {
            const Vec3 p = fitted.wsPoint(fitted.liInside(dice), fitted.lsDepth(dice));
            // Thin, flat and large boxes, with p anywhere in them, also on a corner.
            const Vec3 below(dice.power(-6.0, 1.5), dice.power(-6.0, 1.5), dice.power(-6.0, 1.5));
            const Vec3 above(dice.power(-6.0, 1.5), dice.power(-6.0, 1.5), dice.power(-6.0, 1.5));
            const Ogre::AxisAlignedBox box = ogreBox(p - below, p + above);
            ASSERT_TRUE(fitted.volume.isVisible(box)) << p.transpose();
            // Planes in floats cannot resolve less than this.
            const Vec3 grain = Vec3::Constant(FloatRounding * p.norm());
            const Ogre::AxisAlignedBox coarse = ogreBox(p - below - grain, p + above + grain);
            ASSERT_TRUE(visibleByPlanes(fitted.volume, coarse)) << p.transpose();
        }
    });
}

TEST_P(CasterVolumeTest, ShowsEverySphereThatReachesIntoTheRegionsLight) {
    forScenes([](const Fitted& fitted, Dice& dice) {
        for (int i = 0; i < 300; ++i) {
            const Vec3 p = fitted.wsPoint(fitted.liInside(dice), fitted.lsDepth(dice));
            const double radius = dice.power(-3.0, 1.5);
            const Vec3 centre = p + dice.in(0.0, 1.0) * radius * dice.direction();
            const Ogre::Vector3 rounded = toOgre(centre);
            const double grown = radius + (toDouble(rounded) - centre).norm();
            ASSERT_TRUE(
                fitted.volume.isVisible(Ogre::Sphere(rounded, static_cast<float>(grown * 1.001))));
            ASSERT_TRUE(fitted.volume.isVisible(toOgre(p)));
        }
    });
}

TEST_P(CasterVolumeTest, HidesWhatIsBesideTheRegion) {
    forScenes([](const Fitted& fitted, Dice& dice) {
        const auto focus = fitted.fit.liFocus.span();
        ASSERT_GE(focus.size(), 3U);
        double extent = 0.0;
        for (const Vec2& q : focus)
            extent = std::max(extent, (q - focus[0]).norm());
        for (int i = 0; i < 100; ++i) {
            const std::size_t k =
                static_cast<std::size_t>(dice.in(0.0, 0.999) * static_cast<double>(focus.size()));
            const Vec2 edge = focus[(k + 1) % focus.size()] - focus[k];
            if (edge.norm() < 1e-3 * extent) continue;
            const Vec2 outward = Vec2(edge.y(), -edge.x()).normalized();
            const double away = extent * dice.power(-2.0, 1.0);
            const Vec2 q = focus[k] + dice.in(0.0, 1.0) * edge + away * outward;
            const double depth = fitted.lsDepth(dice);
            const Vec3 p = fitted.wsPoint(q, depth);
            // Distance to the plane of light rays through that edge.
            double distance = away;
            if (!fitted.fit.directional) {
                const Vec2 at = focus[k];
                distance = away * depth / std::hypot(1.0, outward.dot(at));
            }
            const double room = distance - 4.0 * FloatRounding * p.cwiseAbs().sum();
            if (!(room > 0.0)) continue;
            // A box reaches √3 of its largest half extent at most.
            const Vec3 half = room / 2.0 * dice.cube().cwiseAbs();
            ASSERT_FALSE(fitted.volume.isVisible(ogreBox(p - half, p + half)));
            ASSERT_FALSE(
                fitted.volume.isVisible(Ogre::Sphere(toOgre(p), static_cast<float>(0.9 * room))));
            ASSERT_FALSE(fitted.volume.isVisible(toOgre(p)));
        }
    });
}

TEST_P(CasterVolumeTest, HidesWhatIsBehindTheFarthestReceiver) {
    forScenes([](const Fitted& fitted, Dice& dice) {
        for (int i = 0; i < 100; ++i) {
            const double behind = fitted.size * dice.power(-3.0, 2.0);
            const Vec3 p = fitted.wsPoint(fitted.liInside(dice), fitted.fit.lsFar + behind);
            const double room = behind - 8.0 * FloatRounding * p.cwiseAbs().sum();
            if (!(room > 0.0)) continue;
            const Vec3 half = room / 2.0 * dice.cube().cwiseAbs();
            const Ogre::AxisAlignedBox box = ogreBox(p - half, p + half);
            ASSERT_FALSE(fitted.volume.isVisible(box));
            ASSERT_FALSE(visibleByPlanes(fitted.volume, box));
            ASSERT_FALSE(
                fitted.volume.isVisible(Ogre::Sphere(toOgre(p), static_cast<float>(0.9 * room))));
        }
    });
}

TEST_P(CasterVolumeTest, SixPlanesHoldLittleMoreThanTheRegionsRectangle) {
    // What the octree draws: no more than what any rectangle around the region would.
    forScenes([](const Fitted& fitted, Dice& dice) {
        double extent = 0.0;
        for (const Vec2& q : fitted.fit.liFocus.span())
            extent = std::max(extent, (q - fitted.fit.liCentre).norm());
        for (int i = 0; i < 100; ++i) {
            const double turn = dice.in(0.0, 2.0 * std::numbers::pi);
            // Farther than the diagonal of the widest rectangle.
            const Vec2 q =
                fitted.fit.liCentre + 3.0 * extent * Vec2(std::cos(turn), std::sin(turn));
            const double depth = fitted.lsDepth(dice);
            const Vec3 p = fitted.wsPoint(q, depth);
            const double grain = 8.0 * FloatRounding * (p.norm() + fitted.wsOrigin.norm());
            const double reach = extent * (fitted.fit.directional ? 1.0 : depth);
            if (0.1 * reach < grain) continue;
            const Vec3 half = Vec3::Constant(0.01 * reach);
            ASSERT_FALSE(visibleByPlanes(fitted.volume, ogreBox(p - half, p + half)));
        }
    });
}

TEST(CasterVolume, WithoutAMapShowsNothing) {
    ogre();
    CasterVolume volume;
    const auto expectNothing = [&] {
        const Ogre::AxisAlignedBox box(-1e6f, -1e6f, -1e6f, 1e6f, 1e6f, 1e6f);
        EXPECT_FALSE(volume.isVisible(box));
        EXPECT_FALSE(volume.isVisible(Ogre::AxisAlignedBox::BOX_INFINITE));
        EXPECT_FALSE(volume.isVisible(Ogre::Sphere(Ogre::Vector3::ZERO, 1e6f)));
        EXPECT_FALSE(volume.isVisible(Ogre::Vector3::ZERO));
        EXPECT_FALSE(visibleByPlanes(volume, box));
    };
    expectNothing();
    ShadowFit fit;
    fit.reason = FitReason::NothingShadowed;
    volume.set(fit, Vec3(1e3, 0.0, 0.0));
    expectNothing();
}

TEST(CasterVolume, ShowsInfiniteBoxesAndNoNullOnes) {
    ogre();
    ShadowFit fit;
    fit.reason = FitReason::None;
    fit.liFocus.vertices = {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)};
    fit.liFocus.count = 4;
    CasterVolume volume;
    volume.set(fit, Vec3::Zero());
    EXPECT_TRUE(volume.isVisible(Ogre::AxisAlignedBox::BOX_INFINITE));
    EXPECT_FALSE(volume.isVisible(Ogre::AxisAlignedBox::BOX_NULL));
    EXPECT_TRUE(volume.isVisible(Ogre::Vector3::ZERO));
    EXPECT_FALSE(volume.isVisible(Ogre::Vector3(2, 0, 0)));
}

} // namespace
} // namespace Lixel::Tests

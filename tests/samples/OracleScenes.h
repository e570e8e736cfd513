#pragma once

// Small scenes for the exact-shadow oracle, and what is seen in them.

#include "common/ShadowOracle.h"

#include <gtest/gtest.h>

#include <optional>

namespace Lixel::Samples {

inline constexpr Triangle Caster{{}, true, true, false};
inline constexpr Triangle Receiver{{}, false, true, false};

/// A horizontal square of half side `half` about `centre`, seen from above.
void addGround(TriangleScene& scene, const Eigen::Vector3d& centre, double half,
               Triangle flags = Receiver);

/// A closed box, fronts outward.
void addBox(TriangleScene& scene, const Eigen::Vector3d& low, const Eigen::Vector3d& high,
            Triangle flags = Caster);

Eigen::Matrix4d lookAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& target);
Eigen::Matrix4d perspective(double fovY, double aspect, double near, double far);

/// 160 x 120 pixels, with shadows at any distance.
OracleView viewFrom(const Eigen::Vector3d& eye, const Eigen::Vector3d& target,
                    double far = std::numeric_limits<double>::infinity());

OracleLight directional(const Eigen::Vector3d& direction);

/// Where the pixel's ray meets the plane y = 0; nothing where it does not.
std::optional<Eigen::Vector3d> groundPoint(const OracleView& view, int column, int row);

std::size_t count(const ShadowTruth& truth, PixelClass wanted);

/** Checks every ground pixel that `expectation` is sure about.
    @param expectation from a ground point: 1 shadowed, 0 lit, -1 too near the border to say
*/
template <typename Expectation>
void expectGround(const ShadowOracle& oracle, const OracleView& view, const OracleLight& light,
                  const Expectation& expectation) {
    const ShadowTruth truth = oracle.classify(view, light);
    const auto points = oracle.visiblePoints(view);
    std::size_t checked[2] = {0, 0};
    for (int row = 0; row < view.height; ++row) {
        for (int column = 0; column < view.width; ++column) {
            const auto& point = points.at(column, row);
            if (!point || oracle.scene().triangles[point->triangle].casts) continue;
            const auto exact = groundPoint(view, column, row);
            ASSERT_TRUE(exact);
            ASSERT_NEAR((*exact - point->position).norm(), 0.0, 1e-9 * exact->norm());
            const int expected = expectation(*exact);
            if (expected < 0) continue;
            ++checked[expected];
            ASSERT_EQ(truth.at(column, row), expected == 1 ? PixelClass::Shadowed : PixelClass::Lit)
                << "pixel " << column << ", " << row << " at " << exact->transpose();
        }
    }
    EXPECT_GT(checked[0], 500U) << "too few lit pixels to mean anything";
    EXPECT_GT(checked[1], 100U) << "too few shadowed pixels to mean anything";
}

/// 1 inside, 0 outside, -1 within the margin.
inline int decide(double signedDistance, double margin) {
    return signedDistance < -margin ? 1 : (signedDistance > margin ? 0 : -1);
}

} // namespace Lixel::Samples

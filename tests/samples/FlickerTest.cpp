// What of a picture is followed into the next one, and what of it counts as flicker.

#include "common/Flicker.h"

#include "OracleScenes.h"

#include <algorithm>
#include <cmath>

namespace Lixel::Samples {
namespace {

/// A box on a ground, in front of the viewer and a little to the right.
class FollowedPoints : public testing::Test {
protected:
    FollowedPoints() : oracle(makeScene()) {}

    static TriangleScene makeScene() {
        TriangleScene scene;
        addGround(scene, {0, 0, 0}, 50.0);
        addBox(scene, {-1, 0, -1}, {1, 2, 1});
        return scene;
    }

    std::vector<std::size_t> follow(const OracleView& now, const OracleView& next) const {
        const VisiblePoints points = oracle.visiblePoints(now);
        return followedPixels(points, now, oracle.classify(points, now, sun),
                              oracle.visiblePoints(next), next);
    }

    ShadowOracle oracle;
    OracleLight sun = directional({0.3, -1.0, 0.2});
    OracleView view = viewFrom({-1.0, 3.0, 8.0}, {0.0, 0.5, 0.0});
};

TEST_F(FollowedPoints, AreAllButSilhouettesWhereNothingMoves) {
    const VisiblePoints points = oracle.visiblePoints(view);
    const ShadowTruth truth = oracle.classify(view, sun);
    const std::vector<std::size_t> followed = follow(view, view);
    const std::size_t counted = count(truth, PixelClass::Lit) + count(truth, PixelClass::Shadowed);
    // The box' outline is some 150 pixels long, and five pixels beside it are left out.
    EXPECT_LT(followed.size(), counted - 300);
    EXPECT_GT(followed.size(), counted - 2000);
    const auto onBox = [&](std::size_t pixel) {
        return points.pixels[pixel] &&
               oracle.scene().triangles[points.pixels[pixel]->triangle].casts;
    };
    // Where ground and box meet in the picture behind it, the ground is far behind the box.
    const auto width = static_cast<std::size_t>(view.width);
    for (const std::size_t pixel : followed)
        for (const std::size_t beside : {pixel - 1, pixel + 1, pixel - width, pixel + width}) {
            if (beside >= points.pixels.size() || onBox(pixel) == onBox(beside)) continue;
            ASSERT_TRUE(points.pixels[beside]);
            EXPECT_LT((points.pixels[pixel]->position - points.pixels[beside]->position).norm(),
                      1.0)
                << pixel;
        }
}

TEST_F(FollowedPoints, AreVisibleInBothFrames) {
    const OracleView next = viewFrom({1.0, 3.0, 8.0}, {1.0, 0.5, 0.0});
    const VisiblePoints points = oracle.visiblePoints(view);
    std::size_t onGround = 0;
    for (const std::size_t pixel : follow(view, next)) {
        const Eigen::Vector3d& p = points.pixels[pixel]->position;
        const Eigen::Vector4d clip = next.clipFromVs * next.vsFromWs * p.homogeneous();
        EXPECT_LE(std::abs(clip.x()), clip.w());
        EXPECT_LE(std::abs(clip.y()), clip.w());
        if (p.y() > 0.01) continue;
        ++onGround;
        // Nothing between it and the next eye: the box would be, at half its height.
        const Eigen::Vector3d eye(1.0, 3.0, 8.0);
        for (int step = 1; step < 200; ++step) {
            const Eigen::Vector3d between = p + step / 200.0 * (eye - p);
            EXPECT_FALSE(std::abs(between.x()) < 0.95 && std::abs(between.z()) < 0.95 &&
                         between.y() > 0.05 && between.y() < 1.95)
                << p.transpose();
        }
    }
    EXPECT_GT(onGround, 1000U);
    // A viewer who looks the other way sees none of them.
    EXPECT_TRUE(follow(view, viewFrom({-1.0, 3.0, 8.0}, {-1.0, 3.5, 20.0})).empty());
}

TEST(Flicker, IsWhatChangesAmongFollowedPixels) {
    const std::vector<std::size_t> followed{0, 2, 3};
    const std::vector<std::uint8_t> now{0, 0, 255, 255};
    EXPECT_EQ(changedPixels(followed, now, now), 0U);
    // The second pixel is not followed.
    EXPECT_EQ(changedPixels(followed, now, std::vector<std::uint8_t>{255, 255, 255, 0}), 2U);
}

} // namespace
} // namespace Lixel::Samples

// Holes that a texture's alpha cuts, against what is known in closed form.

#include "OracleScenes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace Lixel::Samples {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Wrap = AlphaMask::Wrap;

/// Columns of this alpha, all rows alike, read at the nearest texel.
AlphaMask columns(std::vector<std::uint8_t> alpha) {
    AlphaMask mask;
    mask.width = static_cast<int>(alpha.size());
    mask.height = 1;
    mask.alpha = std::move(alpha);
    mask.bilinear = false;
    return mask;
}

/// Bars and holes, `pairs` of them.
AlphaMask bars(std::size_t pairs) {
    std::vector<std::uint8_t> alpha(2 * pairs, 0);
    for (std::size_t bar = 0; bar < alpha.size(); bar += 2)
        alpha[bar] = 255;
    return columns(std::move(alpha));
}

/// A horizontal square that shows the mask once, u along x and v along z.
void addPanel(TriangleScene& scene, const AlphaMask& mask, const Vector3d& centre, double half,
              Triangle flags = Caster) {
    flags.mask = static_cast<std::uint32_t>(scene.masks.size());
    scene.masks.push_back(mask);
    const std::size_t first = scene.positions.size();
    addGround(scene, centre, half, flags);
    scene.uvs.resize(scene.positions.size(), Eigen::Vector2f::Zero());
    for (std::size_t i = first; i < scene.positions.size(); ++i) {
        const Vector3d place = (scene.positions[i] - centre) / (2.0 * half);
        scene.uvs[i] = Vector2d(place.x() + 0.5, place.z() + 0.5).cast<float>();
    }
}

/// The share of a fine grid of points below the panel that the light reaches.
double litShare(const AlphaMask& mask, const OracleLight& light) {
    TriangleScene scene;
    addGround(scene, Vector3d::Zero(), 40.0);
    addPanel(scene, mask, {0.0, 4.0, 0.0}, 2.0);
    const ShadowOracle oracle(std::move(scene));
    constexpr int Side = 600;
    // The panel's shadow, by the light through its corners.
    const auto below = [&](double x, double z) -> Vector3d {
        const Vector3d on(x, 4.0, z);
        const Vector3d along = light.kind == OracleLight::Kind::Directional
                                   ? light.direction
                                   : Vector3d(on - light.position);
        return on - on.y() / along.y() * along;
    };
    int lit = 0;
    for (int i = 0; i < Side; ++i)
        for (int k = 0; k < Side; ++k) {
            const auto across = [](int n) { return -2.0 + 4.0 * (n + 0.5) / Side; };
            const SurfacePoint point{below(across(i), across(k)), Vector3d::UnitY(), 0};
            lit += oracle.occluded(point, light) ? 0 : 1;
        }
    return static_cast<double>(lit) / (Side * Side);
}

TEST(AlphaMask, IsReadAsAProgramReadsATexture) {
    AlphaMask mask = columns({0, 100, 200, 40});
    struct Case {
        Wrap wrap;
        double u, nearest, bilinear;
    };
    // Texel centres are at u = 1/8, 3/8, 5/8, 7/8.
    for (const Case& c :
         {Case{Wrap::Repeat, 0.375, 100.0, 100.0}, Case{Wrap::Repeat, 0.4375, 100.0, 125.0},
          Case{Wrap::Repeat, 0.5625, 200.0, 175.0}, Case{Wrap::Repeat, 1.375, 100.0, 100.0},
          Case{Wrap::Repeat, -0.125, 40.0, 40.0}, Case{Wrap::Repeat, -1e6 + 0.375, 100.0, 100.0},
          Case{Wrap::Repeat, 0.0, 0.0, 20.0}, Case{Wrap::Mirror, 1.125, 40.0, 40.0},
          Case{Wrap::Mirror, -0.375, 100.0, 100.0}, Case{Wrap::Mirror, 2.375, 100.0, 100.0},
          Case{Wrap::Mirror, 1.0, 40.0, 40.0}, Case{Wrap::Clamp, 7.0, 40.0, 40.0},
          Case{Wrap::Clamp, -1e30, 0.0, 0.0}, Case{Wrap::Border, -0.25, 255.0, 255.0},
          Case{Wrap::Border, 0.0625, 0.0, 63.75}, Case{Wrap::Border, 0.875, 40.0, 40.0}}) {
        SCOPED_TRACE(testing::Message() << "wrap " << static_cast<int>(c.wrap) << ", u " << c.u);
        mask.wrap = {c.wrap, Wrap::Repeat};
        mask.bilinear = false;
        EXPECT_DOUBLE_EQ(mask.alphaAt({c.u, 0.5}), c.nearest);
        mask.bilinear = true;
        EXPECT_NEAR(mask.alphaAt({c.u, 0.5}), c.bilinear, 1e-6);
        // Turned, v is read as u was.
        AlphaMask turned = mask;
        std::swap(turned.width, turned.height);
        std::swap(turned.wrap[0], turned.wrap[1]);
        EXPECT_NEAR(turned.alphaAt({0.5, c.u}), c.bilinear, 1e-6);
    }
}

TEST(AlphaMask, RowsBeginAtZeroAndLeastIsDrawn) {
    AlphaMask mask;
    mask.width = mask.height = 2;
    mask.alpha = {10, 20, 30, 40};
    mask.bilinear = false;
    mask.least = 30.0;
    EXPECT_TRUE(mask.isHole({0.75, 0.25}));
    EXPECT_FALSE(mask.isHole({0.25, 0.75})) << "as much as the least is drawn";
    mask.bilinear = true;
    EXPECT_DOUBLE_EQ(mask.alphaAt({0.5, 0.5}), 25.0);
}

TEST(AlphaMask, HasHolesWhereAnyTexelIsLess) {
    AlphaMask mask = columns({128, 255});
    EXPECT_FALSE(mask.hasHoles());
    mask.borderAlpha = 0;
    EXPECT_FALSE(mask.hasHoles()) << "the border is not seen";
    mask.wrap[1] = Wrap::Border;
    EXPECT_TRUE(mask.hasHoles());
    EXPECT_TRUE(columns({255, 127}).hasHoles());
}

TEST(CutOut, BarsLetHalfOfTheLightThrough) {
    for (const OracleLight& light :
         {directional({0.0, -1.0, 0.0}), directional({0.5, -1.0, -0.3})}) {
        // 600 points across are 75 on each of 8 columns.
        EXPECT_DOUBLE_EQ(litShare(bars(4), light), 0.5);
        EXPECT_DOUBLE_EQ(litShare(columns({255, 0, 0, 0}), light), 0.75);
        EXPECT_DOUBLE_EQ(litShare(columns({0, 0}), light), 1.0);
    }
    OracleLight lamp;
    lamp.kind = OracleLight::Kind::Point;
    lamp.position = {0.3, 9.0, -0.7};
    EXPECT_DOUBLE_EQ(litShare(bars(4), lamp), 0.5);
}

TEST(CutOut, BetweenTexelsTheLeastAlphaSaysHowWideABarIs) {
    // From one texel to the next, alpha rises or falls evenly: the part of the panel whose alpha is
    // below the least is least / 255.
    AlphaMask mask = bars(2);
    mask.bilinear = true;
    for (const double least : {32.0, 128.0, 204.0}) {
        mask.least = least;
        EXPECT_NEAR(litShare(mask, directional({0.2, -1.0, 0.1})), least / 255.0, 0.01) << least;
    }
}

TEST(CutOut, ShadowsOfBarsAreWhereTheBarsAre) {
    constexpr double Half = 3.0;
    constexpr double Height = 5.0;
    constexpr int Pairs = 3;
    TriangleScene scene;
    addGround(scene, Vector3d::Zero(), 40.0);
    addPanel(scene, bars(Pairs), {0.0, Height, 0.0}, Half);
    const ShadowOracle oracle(std::move(scene));
    const OracleLight light = directional({0.7, -1.0, 0.4});
    const OracleView view = viewFrom({4.0, 4.0, 14.0}, {3.0, 0.0, 2.0});
    expectGround(oracle, view, light, [&](const Vector3d& p) {
        const Vector3d on = p + Height / light.direction.y() * light.direction;
        const double edge = std::max(std::abs(on.x()), std::abs(on.z())) - Half;
        if (edge > -1e-4) return decide(edge, 1e-4);
        const double bar = (on.x() + Half) / (2.0 * Half) * 2.0 * Pairs;
        if (std::abs(bar - std::round(bar)) < 1e-4) return -1;
        return static_cast<int>(std::floor(bar)) % 2 == 0 ? 1 : 0;
    });
}

TEST(CutOut, TheViewerSeesWhatIsBehindAHole) {
    TriangleScene scene;
    addGround(scene, Vector3d::Zero(), 40.0);
    addPanel(scene, bars(2), {0.0, 4.0, 0.0}, 2.0);
    const ShadowOracle oracle(std::move(scene));
    const OracleView view = viewFrom({0.3, 9.0, 0.6}, {0.0, 4.0, 0.0});
    const auto points = oracle.visiblePoints(view);
    const ShadowTruth truth = oracle.classify(view, directional({0.0, -1.0, 0.0}));
    const Vector3d eye = view.vsFromWs.inverse().topRightCorner<3, 1>();
    std::array<int, 2> seen{};
    for (int row = 0; row < view.height; ++row)
        for (int column = 0; column < view.width; ++column) {
            const Vector3d ground = *groundPoint(view, column, row);
            const Vector3d on = eye + (eye.y() - 4.0) / (eye.y() - ground.y()) * (ground - eye);
            if (std::max(std::abs(on.x()), std::abs(on.z())) > 1.999) continue;
            if (std::abs(on.x() - std::round(on.x())) < 1e-4) continue;
            const bool bar = static_cast<int>(std::floor(on.x())) % 2 == 0;
            ++seen[bar ? 1 : 0];
            const auto& point = points.at(column, row);
            ASSERT_TRUE(point);
            ASSERT_NEAR((point->position - (bar ? on : ground)).norm(), 0.0, 1e-6);
            // What is seen through a hole has its own light: the bars' shadows are on the ground.
            if (bar) {
                ASSERT_EQ(truth.at(column, row), PixelClass::Lit);
            }
        }
    EXPECT_GT(seen[0], 1000);
    EXPECT_GT(seen[1], 1000);
    EXPECT_GT(count(truth, PixelClass::Shadowed), 300U);
}

TEST(CutOut, AMapsRaysGoThroughHolesToTheNextCaster) {
    TriangleScene scene;
    addPanel(scene, bars(1), {0.0, 4.0, 0.0}, 1.0);
    addBox(scene, {-9.0, 0.0, -9.0}, {9.0, 1.0, 9.0});
    const ShadowOracle oracle(std::move(scene));
    const std::array rays{CasterRay{{-0.5, 6.0, 0.1}, -Vector3d::UnitY(), 20.0},
                          CasterRay{{0.5, 6.0, 0.1}, -Vector3d::UnitY(), 20.0},
                          CasterRay{{-0.5, 3.0, 0.1}, Vector3d::UnitY(), 20.0},
                          CasterRay{{0.5, 3.0, 0.1}, Vector3d::UnitY(), 20.0}};
    std::array<double, 4> distances{};
    oracle.firstCasters(rays, CasterFaces::Fronts, distances);
    EXPECT_NEAR(distances[0], 2.0, 1e-5);
    EXPECT_NEAR(distances[1], 5.0, 1e-5);
    EXPECT_TRUE(std::isinf(distances[2])) << "from below it shows its back";
    oracle.firstCasters(rays, CasterFaces::Backs, distances);
    EXPECT_NEAR(distances[0], 6.0, 1e-5) << "the box' bottom";
    EXPECT_NEAR(distances[2], 1.0, 1e-5);
    EXPECT_TRUE(std::isinf(distances[3]));
}

TEST(CutOut, WhatDoesNotCastHasHolesForTheViewerAlone) {
    TriangleScene scene;
    addGround(scene, Vector3d::Zero(), 40.0);
    addPanel(scene, bars(2), {0.0, 4.0, 0.0}, 2.0, Receiver);
    const ShadowOracle oracle(std::move(scene));
    const OracleView view = viewFrom({0.0, 9.0, 0.1}, {0.0, 4.0, 0.0});
    const auto points = oracle.visiblePoints(view);
    const auto onPanel = std::ranges::count_if(
        points.pixels, [](const auto& point) { return point && point->position.y() > 3.0; });
    const double pixel = std::pow(2.0 * 5.0 * std::tan(0.5) / view.height, 2.0);
    EXPECT_NEAR(static_cast<double>(onPanel) * pixel, 8.0, 0.3);
    const ShadowTruth truth = oracle.classify(view, directional({0.0, -1.0, 0.0}));
    EXPECT_EQ(count(truth, PixelClass::Shadowed), 0U);
}

TEST(CutOut, BadMasksAreRefusedByName) {
    TriangleScene good;
    addPanel(good, bars(2), Vector3d::Zero(), 1.0);
    EXPECT_NO_THROW(ShadowOracle{good});
    const auto refuses = [&](const auto& spoil) {
        TriangleScene scene = good;
        spoil(scene);
        EXPECT_THROW(ShadowOracle{scene}, std::invalid_argument);
    };
    refuses([](TriangleScene& scene) { scene.triangles[1].mask = 1; });
    refuses([](TriangleScene& scene) { scene.masks[0].alpha.pop_back(); });
    refuses([](TriangleScene& scene) { scene.masks[0].width = 0; });
    refuses([](TriangleScene& scene) { scene.uvs.pop_back(); });
    refuses([](TriangleScene& scene) { scene.uvs[0].x() = std::nanf(""); });
}

} // namespace
} // namespace Lixel::Samples

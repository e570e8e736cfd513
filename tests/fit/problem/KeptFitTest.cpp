// How a kept map is compared with a fresh one.
#include "fit/Trials.h"

#include "fit/problem/KeptFit.h"

#include <gtest/gtest.h>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

/// The same map, but showing a window around the middle alone: 1 / share of each side.
ShadowFit withSides(ShadowFit fit, double share) {
    fit.clipFromWorld.topRows<2>() *= share;
    fit.clipFromLight.topRows<2>() *= share;
    return fit;
}

class KeptFits : public testing::TestWithParam<Trial> {
protected:
    /** Checks `property(fit)` for maps of any scene; it returns whether it had something to check.

        Not every focus polygon reaches its map's border, and few reach a little beyond: it has as
        many vertices as there is room for. */
    template <typename Property>
    void forAnyMap(const Property& property) {
        std::size_t maps = 0;
        std::size_t checked = 0;
        const bool holds = rc::check([&] {
            const Scene scene = *anyScene();
            FitState state;
            const ShadowFit fit = GetParam().fit(scene.problem(), state);
            if (!fit.hasMap()) return;
            ++maps;
            if (property(fit)) ++checked;
        });
        EXPECT_TRUE(holds);
        EXPECT_GT(checked, maps * 9 / 10);
    }
};

INSTANTIATE_TEST_SUITE_P(Techniques, KeptFits, testing::ValuesIn(trialsThatServeAll()),
                         [](const auto& test) { return test.param.name; });

TEST_P(KeptFits, AMapServesItselfAsFineAsItIs) {
    forAnyMap([](const ShadowFit& fit) {
        const KeptFit compared = compareFits(fit, fit, Vec3::Zero());
        RC_ASSERT(!compared.covers || std::abs(compared.coarseness - 1.0) < 1e-6);
        return compared.covers;
    });
}

TEST_P(KeptFits, ALargerMapIsCoarserByItsSides) {
    forAnyMap([](const ShadowFit& fit) {
        const KeptFit compared = compareFits(withSides(fit, 1.0 / 1.25), fit, Vec3::Zero());
        RC_ASSERT(!compared.covers || std::abs(compared.coarseness - 1.25) < 1e-6);
        return compared.covers;
    });
}

TEST_P(KeptFits, ASmallerMapDoesNotCover) {
    // A stable map is as large as the view needs in any direction.
    const double share = GetParam().name == "Uniform_stable" ? 16.0 : 1.01;
    forAnyMap([&](const ShadowFit& fit) {
        return !compareFits(withSides(fit, share), fit, Vec3::Zero()).covers;
    });
}

TEST_P(KeptFits, CastersHaveToBeDrawnOnAllItsRays) {
    forAnyMap([](const ShadowFit& fit) {
        // Drawn for a smaller region, into a map that has room for more.
        ShadowFit kept = fit;
        Vec2 middle = Vec2::Zero();
        for (const Vec2& q : fit.liFocus.span())
            middle += q / static_cast<double>(fit.liFocus.count);
        for (std::size_t i = 0; i < fit.liFocus.count; ++i)
            kept.liFocus.vertices[i] += 0.01 * (middle - kept.liFocus.vertices[i]);
        return !compareFits(kept, fit, Vec3::Zero()).covers;
    });
}

TEST_P(KeptFits, AMapWithAnotherOriginIsTheSame) {
    forAnyMap([](const ShadowFit& fit) {
        // The kept map's origin is there; x relative to it is x + shift.
        const Vec3 wsShift(0.25, -0.5, 4.0);
        ShadowFit kept = fit;
        kept.clipFromWorld.col(3) -= fit.clipFromWorld.leftCols<3>() * wsShift;
        kept.wsEye += wsShift;
        const KeptFit compared = compareFits(kept, fit, wsShift);
        RC_ASSERT(!compared.covers || std::abs(compared.coarseness - 1.0) < 1e-4);
        return compared.covers;
    });
}

TEST_P(KeptFits, DepthsHaveToBeCovered) {
    forAnyMap([](const ShadowFit& fit) {
        for (const double share : {0.9, 1.1}) {
            // The far or the near end of the range moves.
            ShadowFit kept = fit;
            kept.depthOffset += share < 1.0 ? 0.1 : -0.1;
            RC_ASSERT(!compareFits(kept, fit, Vec3::Zero()).covers);
        }
        return true;
    });
}

TEST(KeptFit, IsNothingWithoutMaps) {
    EXPECT_FALSE(compareFits(ShadowFit{}, ShadowFit{}, Vec3::Zero()).covers);
}

} // namespace

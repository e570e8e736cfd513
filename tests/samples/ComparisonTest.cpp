// Means and ratios of errors, where there is no error, or no case at all.

#include "common/Comparison.h"
#include "report/Table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace Lixel::Samples {
namespace {

TEST(ComparedCase, WithoutErrorHasARatioThatAMeanCanHold) {
    ComparedCase perfect;
    perfect.baseline = 2.0;
    perfect.halfPixel = 0.01;
    EXPECT_DOUBLE_EQ(perfect.ratio(), 0.005);
    const GeometricMean mean = geometricMean({perfect.ratio(), 1.0});
    EXPECT_GT(mean.lower, 0.0);
    EXPECT_TRUE(std::isfinite(mean.upper));
}

TEST(ComparedCase, WithAnErrorHasItsOwnRatio) {
    ComparedCase usual;
    usual.error = 1.0;
    usual.baseline = 2.0;
    usual.halfPixel = 0.01;
    EXPECT_EQ(usual.ratio(), 0.5);
}

TEST(CompareSetups, KnowsWhatHalfAPixelIs) {
    Stage stage({.headless = true, .width = 64, .height = 48});
    const SampleScene& scene = *findSampleScene("duel");
    stage.show(scene);
    const NamedSetup& uniform = *findShadowSetup("Uniform");
    const auto cases = compareSetups(stage, scene, uniform, uniform, 1,
                                     std::span(scene.views).first(1), [](const std::string&) {});
    ASSERT_EQ(cases.size(), 1U);
    // Two turns of one view, of at most so many pixels.
    EXPECT_GE(cases.front().halfPixel, 50.0 / (2 * 64 * 48));
    EXPECT_LT(cases.front().halfPixel, 1.0);
    EXPECT_EQ(cases.front().ratio(), 1.0);
}

TEST(Table, AMeanOfNoCasesIsADash) {
    EXPECT_EQ(describePercent(geometricMean({})), "-");
    EXPECT_EQ(describePercent(geometricMean({0.25, 1.0})), "0.5000");
    EXPECT_EQ(describe(geometricMean({})), "-");
}

TableCase caseWith(const std::string& scene, bool sun, double error) {
    TableCase one{scene, "view", "light", sun, {ClassificationError{}}};
    one.errors.front().error = error;
    one.errors.front().lit = 100;
    return one;
}

TEST(Table, GroupsHoldTheTellingCases) {
    const std::vector<TableCase> cases{caseWith("field", true, 1.0), caseWith("duel", true, 1.0),
                                       caseWith("hall", false, 1.0),
                                       caseWith("duel", true, 0.5 * LeastBaseline)};
    const SomeCases telling = tellingCases(cases, 0);
    ASSERT_EQ(telling.size(), 3U);
    const auto groups = groupsOf(telling);
    EXPECT_EQ(groups[0].name, "all");
    EXPECT_EQ(groups[0].cases, telling);
    EXPECT_EQ(groups[1].name, "suns");
    EXPECT_EQ(groups[1].cases, (SomeCases{&cases[0], &cases[1]}));
    EXPECT_EQ(groups[2].name, "duels");
    EXPECT_EQ(groups[2].cases, SomeCases{&cases[1]});
    EXPECT_EQ(groups[3].name, "lamps");
    EXPECT_EQ(groups[3].cases, SomeCases{&cases[2]});
}

} // namespace
} // namespace Lixel::Samples

// Means and ratios of errors, where there is no error, or no case at all.

#include "common/Comparison.h"
#include "report/Claims.h"
#include "report/Contenders.h"
#include "report/Drawn.h"
#include "report/Table.h"
#include "report/WorstCases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iterator>
#include <sstream>

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

TEST(Claims, WorseIsWhatChanceDoesNotExplain) {
    const auto worse = [](double error, double than) {
        return isWorse({.error = error}, {.error = than});
    };
    EXPECT_TRUE(worse(1.06, 1.0));
    EXPECT_FALSE(worse(1.04, 1.0)) << "by less than 5 %";
    EXPECT_FALSE(worse(0.019, 0.01)) << "by less than 0.01 points";
    EXPECT_TRUE(worse(0.021, 0.01));
    EXPECT_TRUE(worse(0.02, 0.0));
    EXPECT_FALSE(worse(1.0, 1.06));
}

TEST(Claims, TheBestIsTheFirstThatErrsLeast) {
    TableCase one;
    for (const double error : {3.0, 1.0, 2.0, 1.0})
        one.errors.push_back({.error = error});
    EXPECT_EQ(bestOf(one, {0, 1, 2, 3}), 1U);
    EXPECT_EQ(bestOf(one, {0, 3, 1}), 3U);
    EXPECT_EQ(bestOf(one, {0, 2}), 2U);
}

/// The lines that a function prints that begin with a text and a space.
std::vector<std::string> linesOf(const std::string& begin, const std::function<void()>& print) {
    testing::internal::CaptureStdout();
    print();
    std::fflush(stdout);
    std::istringstream said(testing::internal::GetCapturedStdout());
    std::vector<std::string> lines;
    for (std::string line; std::getline(said, line);)
        if (line.starts_with(begin + " ")) lines.push_back(line);
    return lines;
}

/// One case under all setups. Others than these two err by 4 %.
TableCase caseWithTwo(const std::string& scene, double optimal, double uniform) {
    TableCase one{scene, "view", "light", true, {}};
    for (const NamedSetup& setup : emulatedSetups()) {
        one.errors.push_back({.error = 4.0, .lit = 1000000});
        if (setup.name == "Optimal") one.errors.back().error = optimal;
        if (setup.name == "Uniform") one.errors.back().error = uniform;
        one.reasons.emplace_back("none");
    }
    return one;
}

TEST(Claims, AreCountedByKind) {
    const std::vector<TableCase> cases{
        caseWithTwo("meadow", 1.0, 4.0), caseWithTwo("meadow", 1.0, 4.0),
        caseWithTwo("vast", 2.0, 1.0), caseWithTwo("vast", 0.001, 0.002)};
    // Of ratios, then of counts.
    const auto claimedOf = [&](const std::string& kind) {
        return linesOf(kind, [&] { printClaims(TableOptions{}, cases); });
    };
    const std::vector<std::string> meadow = claimedOf("meadow");
    ASSERT_EQ(meadow.size(), 2U);
    EXPECT_NE(meadow[0].find("2   0.250 [0.250, 0.250]"), std::string::npos) << meadow[0];
    std::istringstream counts(meadow[1].substr(6));
    std::vector<int> numbers{std::istream_iterator<int>(counts), {}};
    EXPECT_EQ(numbers, (std::vector{2, 0, 0, 0, 0, 2, 2})) << meadow[1];

    const std::vector<std::string> vast = claimedOf("vast");
    ASSERT_EQ(vast.size(), 2U);
    counts = std::istringstream(vast[1].substr(4));
    numbers.assign(std::istream_iterator<int>(counts), {});
    // Optimal is worse than Uniform in one, and in the other neither errs noticeably.
    EXPECT_EQ(numbers, (std::vector{2, 1, 2, 1, 2, 2, 2})) << vast[1];
    // The ratio to the best of Lixel's leaves the second case out.
    EXPECT_NE(vast[0].find("2.000 [2.000, 2.000]"), std::string::npos) << vast[0];
    EXPECT_EQ(linesOf("2.00", [&] { printWorstCases(TableOptions{}, cases, nullptr); }).size(), 1U)
        << "the worst case";
}

TEST(Drawn, IsComparedInTheCasesThatWereDrawn) {
    TableCase drawn = caseWithTwo("meadow", 1.0, 4.0);
    drawn.drawnErrors = caseWithTwo("meadow", 3.0, 2.0).errors;
    const std::vector<TableCase> cases{drawn, caseWithTwo("vast", 2.0, 1.0)};
    const auto said = [&](const std::string& begin) {
        return linesOf(begin, [&] {
            printDrawn(TableOptions{}, cases);
            printDrawnClaims(TableOptions{}, cases);
        });
    };
    std::istringstream errors(said("Optimal").at(0).substr(7));
    std::vector<double> numbers{std::istream_iterator<double>(errors), {}};
    EXPECT_EQ(numbers, (std::vector{1.0, 3.0, 3.0}));
    const std::string ratios = said("Optimal / Ogre-LiSPSM").at(0);
    EXPECT_NE(ratios.find(" 1     0.250 [0.250, 0.250]     0.750 [0.750, 0.750]"),
              std::string::npos)
        << ratios;
    std::istringstream worse(said("Optimal > Uniform").at(0).substr(17));
    EXPECT_EQ((std::vector<int>{std::istream_iterator<int>(worse), {}}), (std::vector{0, 1}));
    EXPECT_TRUE(linesOf("Optimal", [&] { printDrawn(TableOptions{}, {cases[1]}); }).empty());
}

} // namespace
} // namespace Lixel::Samples

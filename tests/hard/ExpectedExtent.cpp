#include "ExpectedExtent.h"

#include "CaseRun.h"
#include "ChildProcess.h"
#include "MapProbe.h"

#include "common/Comparison.h"

#include <Lixel/fit/core/Fit.h>
#include <Lixel/fit/rule/WarpSearch.h>
#include <Lixel/fit/technique/Xpsm.h>

#include <fmt/core.h>

#include <algorithm>
#include <memory>

namespace Lixel::Tests {
namespace {

using namespace Samples;

/// Seconds; a case takes a tenth of one.
constexpr unsigned ExtentTimeLimit = 20;

/// What the guard has.
constexpr std::size_t ViewSamples = 64;

/// Rounding of a measure that was evaluated again.
constexpr double Rounding = 1e-9;

/// Many cases in one line.
class Summary {
public:
    void add(const ExpectedExtent& extent) {
        if (!extent.judged) return;
        mGuarded = std::max(mGuarded, extent.greatestGuarded);
        mLiteral.push_back(extent.literal);
        if (isWorse(extent)) ++mWorse;
    }
    void print(const std::string& name) const {
        const auto above = std::count_if(mLiteral.begin(), mLiteral.end(),
                                         [](double literal) { return literal > 1.0 + Rounding; });
        const double greatest =
            mLiteral.empty() ? 0.0 : *std::max_element(mLiteral.begin(), mLiteral.end());
        fmt::print("{:<20} {:>3} judged; guarded at most {:.4f}, above 1 in {}; literal {:.4f} in "
                   "the geometric mean, at most {:.4f}, above 1 in {}\n",
                   name, mLiteral.size(), mGuarded, mWorse, geometricMean(mLiteral).mean, greatest,
                   above);
    }
    int worse() const { return mWorse; }

private:
    static bool isWorse(const ExpectedExtent& extent) {
        return !(extent.greatestGuarded <= 1.0 + Rounding);
    }
    double mGuarded = 0.0;
    std::vector<double> mLiteral;
    int mWorse = 0;
};

/// All views of a sample under all its lights, each from a cold state.
Summary summaryOf(const SampleScene& sample) {
    Summary summary;
    Stage stage({.headless = true, .width = 64, .height = 48});
    stage.show(sample);
    // Among no render queues at all: objects are found, and none is drawn.
    stage.sceneManager().setSpecialCaseRenderQueueMode(Ogre::SceneManager::SCRQM_INCLUDE);
    for (const SampleView& view : sample.views) {
        stage.setView(view);
        for (std::size_t i = 0; i < sample.lights.size(); ++i) {
            stage.setLight(lightOf(sample, view, i));
            ExpectedExtent extent;
            stage.setShadowSetup(std::make_shared<ExtentSetup>(extent));
            stage.drawFrame();
            stage.setShadowSetup(nullptr);
            summary.add(extent);
        }
    }
    return summary;
}

} // namespace

ShadowFit ExtentSetup::fit(const ShadowProblem& problem, FitState& state) const noexcept {
    mExtent.judged = false;
    const ShadowFit guarded = fitMap(problem, XpsmOptions{}, state);
    FitState cold;
    XpsmOptions options;
    options.guarded = false;
    const ShadowFit literal = fitMap(problem, options, cold);
    if (!guarded.hasMap() || !literal.hasMap()) return guarded;
    // A rule that only asks what is expected of these warps, about the same centre.
    const auto judge = [&](const WarpContext& context, RuleState memory) {
        WarpSearch search(context, {.most = ViewSamples}, memory);
        mExtent.judged = search.usable();
        if (!mExtent.judged) return WarpChoice{};
        mExtent.guarded = search(search.spread(guarded.liWarp));
        mExtent.literal = search(search.spread(literal.liWarp));
        mExtent.greatestGuarded = std::max(mExtent.greatestGuarded, mExtent.guarded);
        return WarpChoice{};
    };
    FitState another;
    fitWithRule(problem, another, judge);
    return guarded;
}

ExpectedExtent expectedExtent(Stage& stage, const HardCase& hardCase) {
    ExpectedExtent extent;
    stage.setShadowSetup(std::make_shared<ExtentSetup>(extent));
    HardScene scene(stage);
    buildCase(scene, hardCase);
    const MapProbe probe(scene, true);
    drawCase(scene, hardCase, [&] { extent.judged = false; });
    stage.setShadowSetup(nullptr);
    return extent;
}

int printExtents(const std::vector<const HardCase*>& cases) {
    fmt::print("Expected extent of texels where the viewer looks, relative to a uniform map's\n\n"
               "{:<52} {:>8} {:>8}\n",
               "case", "guarded", "literal");
    Summary hard;
    {
        Stage stage({.headless = true, .width = 320, .height = 240});
        for (const HardCase* const hardCase : cases) {
            ExpectedExtent extent;
            const std::string failure = runApart(
                ExtentTimeLimit, [&] { extent = expectedExtent(stage, *hardCase); },
                std::as_writable_bytes(std::span(&extent, 1)));
            if (!failure.empty())
                throw std::runtime_error(fmt::format("{}: {}", hardCase->name, failure));
            hard.add(extent);
            if (extent.judged)
                fmt::print("{:<52} {:>8.4f} {:>8.4f}\n", hardCase->name, extent.guarded,
                           extent.literal);
            else
                fmt::print("{:<52} {:>8} {:>8}\n", hardCase->name, "-", "-");
            std::fflush(stdout);
        }
    }
    fmt::print("\n");
    hard.print("hard cases");
    int worse = hard.worse();
    for (const SampleScene& sample : measuredScenes()) {
        const Summary summary = summaryOf(sample);
        summary.print(sample.name);
        worse += summary.worse();
    }
    return worse;
}

} // namespace Lixel::Tests

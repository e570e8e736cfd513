#include "report/Budgets.h"

#include "common/Median.h"

#include <Lixel/fit/core/FitState.h>
#include <Lixel/fit/technique/Optimal.h>

#include <Eigen/Geometry>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <memory>
#include <numbers>

namespace Lixel::Samples {
namespace {

/// The viewer turns to where it looks in 30 frames of 0.2°; 12° per second at 60 Hz.
constexpr int Frames = 30;
constexpr double TurnPerFrame = 0.2 * std::numbers::pi / 180.0;

/// Repeated fits. The fastest counts: others may have been interrupted.
constexpr int Repetitions = 5;

struct Budget {
    OptimalOptions options;
    bool follows;
};

/// The default comes first, as what the others are compared with.
std::vector<Budget> budgets() {
    std::vector<Budget> all{{OptimalOptions{}, false}};
    for (const auto& [samples, evaluations] :
         {std::pair(16, 8), std::pair(16, 32), std::pair(32, 16), std::pair(64, 8),
          std::pair(64, 16), std::pair(64, 64), std::pair(256, 32), std::pair(256, 256)})
        all.push_back({{samples, evaluations}, false});
    const std::size_t cold = all.size();
    for (std::size_t i = 0; i < cold; ++i)
        all.push_back({all[i].options, true});
    return all;
}

/// The optimal setup, which also takes its time.
class TimedSetup : public FittedShadowCameraSetup {
public:
    TimedSetup(const Budget& budget, std::shared_ptr<std::vector<double>> microseconds)
        : mBudget(budget), mMicroseconds(std::move(microseconds)) {}

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState&) const noexcept override {
        FitState before;
        (void)fitMap(problem, mBudget.options, before); // makes its scratch memory
        forget(before);
        if (mBudget.follows) turnTowards(problem, before);
        double fastest = std::numeric_limits<double>::infinity();
        ShadowFit result;
        for (int i = 0; i < Repetitions; ++i) {
            FitState state = before;
            const auto begin = std::chrono::steady_clock::now();
            result = fitMap(problem, mBudget.options, state);
            const std::chrono::duration<double, std::micro> passed =
                std::chrono::steady_clock::now() - begin;
            fastest = std::min(fastest, passed.count());
        }
        mMicroseconds->push_back(fastest);
        return result;
    }

private:
    static void forget(FitState& state) {
        state.memory.search.reset();
        state.memory.wsMapAxes.reset();
    }
    void turnTowards(const ShadowProblem& problem, FitState& state) const {
        ShadowProblem frame = problem;
        for (int i = Frames; i > 0; --i) {
            Mat4 turn = Mat4::Identity();
            turn.topLeftCorner<3, 3>() =
                Eigen::AngleAxisd(i * TurnPerFrame, Vec3::UnitY()).toRotationMatrix();
            // The viewer is at the problem's origin or next to it.
            frame.viewer.viewFromWorld = problem.viewer.viewFromWorld * turn;
            (void)fitMap(frame, mBudget.options, state);
        }
    }

    Budget mBudget;
    std::shared_ptr<std::vector<double>> mMicroseconds;
};

} // namespace

void printBudgets(TableOptions options) {
    const std::vector<Budget> all = budgets();
    std::vector<std::shared_ptr<std::vector<double>>> times;
    options.setups.clear();
    for (const Budget& budget : all) {
        times.push_back(std::make_shared<std::vector<double>>());
        NamedSetup setup;
        setup.name = "Optimal";
        setup.create = [budget, time = times.back()] {
            return std::make_shared<TimedSetup>(budget, time);
        };
        options.setups.push_back(setup);
    }
    const std::vector<TableCase> cases = measureTable(options);
    fmt::print("Optimal by what it may spend, over {} cases: errors relative to the first line's, "
               "paired geometric mean with its 95 % interval\n\n"
               "{:>7} {:>11}  {:<8} {:>24} {:>14}\n",
               cases.size(), "samples", "evaluations", "", "error", "median time");
    for (std::size_t i = 0; i < all.size(); ++i)
        fmt::print("{:>7} {:>11}  {:<8} {:>24} {:>11.1f} µs\n", all[i].options.samples,
                   all[i].options.evaluations, all[i].follows ? "follows" : "cold",
                   describeRatio(cases, i, 0), median(*times[i]));
}

} // namespace Lixel::Samples

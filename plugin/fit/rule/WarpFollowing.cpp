// The search from frame to frame, which goes on from where the last one ended.
#include "fit/rule/WarpSearch.h"

#include <algorithm>
#include <cmath>

namespace Lixel {
namespace {

/// Least step of a search that follows the last frame's, as a multiple of LeastStep.
constexpr double LeastFollowingSteps = 2.0;

/// Turn that divides a circle most evenly, however often it is made: 2π (1 - 0.618...).
constexpr double GoldenAngle = 2.39996322972865332;

/// The count of turns starts again after this many. It is even, so that the simplex's side still
/// alternates.
constexpr int Turns = 1 << 12;

/// What a search that follows must gain, relative, to look farther the next time: well above what
/// the light's image changes from frame to frame by itself.
constexpr double FollowingGain = 1e-3;

/// Frames without change after which the search rests: as many directions, evenly spread, have been
/// tried by then as a search that starts anew tries.
constexpr int CalmFrames = 24;

} // namespace

std::optional<WarpSearch::Judged> WarpSearch::atRest(const Vec2& target) {
    if (!mMemory || mMemory->calm < CalmFrames || mChange > 0.0) return std::nullopt;
    const Judged same = judge(target);
    // The samples may be others although the region is the same.
    if (!(std::abs(same.cost - mMemory->cost) <= FollowingGain * mMemory->cost))
        return std::nullopt;
    mNow.calm = mMemory->calm;
    mRests = true;
    return same;
}

WarpSearch::Judged WarpSearch::follow(const Vec2& target, int evaluations) {
    if (const auto rest = atRest(target)) return *rest;
    Judged best = judge(target);
    if (!(best.cost < 1.0)) best = {};
    // Turned by the golden angle each time, directions are spread evenly however many there were.
    mNow.turn = (mNow.turn + 1) % Turns;
    const double angle = mNow.turn * GoldenAngle;
    const Judged probe =
        judge(std::max(best.spread.norm(), ProbedSpread) * Vec2(std::cos(angle), std::sin(angle)));
    if (probe.cost < best.cost) {
        best = probe;
        mNow.step = FirstStep;
    }
    evaluations -= 2;
    if (evaluations < LeastSimplex) {
        adaptStep(false);
        return best;
    }
    const Judged found =
        simplexFrom(best, mNow.turn % 2 == 0 ? mNow.step : -mNow.step, evaluations);
    adaptStep(found.cost < best.cost * (1.0 - FollowingGain));
    return found;
}

WarpSearch::Judged WarpSearch::followAlong(const Vec2& direction, double greatest,
                                           const Vec2& target) {
    if (const auto rest = atRest(target)) return *rest;
    const double end = std::min(greatest, GreatestSpread);
    const double middle = std::clamp(direction.dot(target), 0.0, end);
    const double lower = std::max(middle - mNow.step, 0.0);
    const double upper = std::min(middle + mNow.step, end);
    const Judged start = judge(middle * direction);
    Judged best = start;
    const auto consider = [&](double s) {
        const Judged judged = judge(s * direction);
        if (judged.cost < best.cost) best = judged;
        return judged.cost;
    };
    consider(end);
    const double costLower = consider(lower);
    const double costUpper = consider(upper);
    // The parabola through the three has its least value where its slope is 0.
    const double fall = (start.cost - costLower) * (upper - middle);
    const double rise = (costUpper - start.cost) * (middle - lower);
    const double bend = rise - fall;
    if (bend > 0.0) {
        const double vertex =
            middle - 0.5 * (fall * (upper - middle) + rise * (middle - lower)) / bend;
        consider(std::clamp(vertex, lower, upper));
    }
    if (!(best.cost < 1.0)) best = {};
    adaptStep(best.cost < start.cost * (1.0 - FollowingGain));
    return best;
}

void WarpSearch::adaptStep(bool improved) {
    mNow.calm = improved || mChange > 0.0 ? 0 : std::min(mMemory->calm + 1, CalmFrames);
    mNow.step = improved ? std::min(2.0 * mNow.step, FirstStep)
                         : std::max(0.5 * mNow.step, LeastFollowingSteps * LeastStep);
}

} // namespace Lixel

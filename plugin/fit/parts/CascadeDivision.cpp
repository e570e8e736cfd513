#include "fit/parts/CascadeDivision.h"

#include "fit/sampling/FitExtent.h"
#include "fit/sampling/TexelExtent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace Lixel {
namespace {

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// How much has to change until one more division is judged: the viewer turns by six degrees.
/// Judging takes a cold fit of each part of two divisions, and a frame that follows another takes
/// one warm fit of each part of one.
constexpr double JudgedChange = 0.1;

/// Least gain, relative, for which a division replaces another. A viewer who turns all around on a
/// plain under a low sun sees 7 replaced; with half of it 15, for a gain that nobody sees.
constexpr double LeastGain = 0.2;

/// Fewer samples judge nothing.
constexpr std::size_t FewestSamples = 16;

/// A strip narrower than this share of the light image's extent is not for any map.
constexpr double LeastShare = 1e-3;

/// A number for each border between parts; those behind the last one are 0.
using BorderNumbers = std::array<double, ShadowPart::MostBounds>;

/// One way to divide: by depth, or across a direction of the light image.
struct Division {
    /// Zero: by depth.
    Vec2 liDirection = Vec2::Zero();
    /// Where strips meet, as shares of the focus region's extent along the direction.
    BorderNumbers shares{};
    /// Where parts meet, as depths or along the direction.
    BorderNumbers splits{};
    LightPartition parts;

    bool isByDepth() const { return liDirection.isZero(0.0); }
    std::size_t partOf(const ViewSample& sample) const {
        const double at = isByDepth() ? sample.vsDepth : liDirection.dot(sample.liPoint);
        const auto used = std::span(splits).first(parts.count - 1);
        return static_cast<std::size_t>(std::ranges::upper_bound(used, at) - used.begin());
    }
};

/// The ends of a polygon along a direction.
struct Extent {
    Extent(const Polygon2& liHull, const Vec2& liDirection)
        : liBegin(-support(liHull, -liDirection)), liEnd(support(liHull, liDirection)) {}
    double size() const { return liEnd - liBegin; }

    double liBegin;
    double liEnd;
};

/// A range of a direction of the light image, and the samples in it.
struct Strip {
    double liBegin = 0.0;
    double liEnd = 0.0;
    std::span<const std::pair<double, double>> demands;
};

/// Where a strip is best cut in two.
struct Cut {
    double gain = 0.0;
    double li = 0.0;
    std::size_t before = 0;
};

double demandOf(const Strip& strip) {
    double sum = 0.0;
    for (const auto& [at, demand] : strip.demands)
        sum += demand;
    return sum;
}

Cut bestCut(const Strip& strip) {
    const double total = demandOf(strip);
    const double whole = total * std::sqrt(strip.liEnd - strip.liBegin);
    Cut best;
    double before = 0.0;
    for (std::size_t i = 1; i < strip.demands.size(); ++i) {
        before += strip.demands[i - 1].second;
        const double li = (strip.demands[i - 1].first + strip.demands[i].first) / 2.0;
        const double cost = before * std::sqrt(std::max(li - strip.liBegin, 0.0)) +
                            (total - before) * std::sqrt(std::max(strip.liEnd - li, 0.0));
        if (whole - cost > best.gain) best = {whole - cost, li, i};
    }
    return best;
}

/// Divides one problem, and judges divisions of it.
class Divider {
public:
    /// @param slices by depth
    Divider(const ShadowProblem& problem, const Division& slices, StripMemory& memory,
            CascadeScratch& scratch, const PartFit& technique)
        : mProblem(problem),
          mImage(problem.light),
          mSlices(slices),
          mCount(slices.parts.count),
          mMemory(memory),
          mScratch(scratch),
          mTechnique(technique) {}

    /// @param change since the frame before, infinite after a camera cut
    LightPartition divide(double change) {
        if (mMemory.count != mCount || !std::isfinite(change)) return begin();
        mNow = current();
        mMemory.change += change;
        if (mMemory.change >= JudgedChange) {
            mMemory.change = 0.0;
            judgeNext();
        }
        return mNow.parts;
    }

    /// What there was in the frame before, without a judgement.
    LightPartition keep() { return current().parts; }

private:
    static constexpr std::size_t Ways = 3;

    /// The best of all.
    LightPartition begin() {
        mMemory = {.count = mCount, .jumps = mMemory.jumps};
        double least = Infinity;
        for (std::size_t way = 0; way < Ways; ++way) {
            const Division division = ofWay(way);
            const double cost = costOf(division);
            if (way > 0 && !(cost < least)) continue;
            least = cost;
            take(division);
        }
        return mNow.parts;
    }

    /// Compares another division with what there is.
    void judgeNext() {
        mMemory.next = (mMemory.next + 1) % Ways;
        if (mMemory.next == 0 && mNow.isByDepth()) ++mMemory.next;
        const Division other = ofWay(mMemory.next);
        if (!(costOf(other) < (1.0 - LeastGain) * costOf(mNow))) return;
        take(other);
        ++mMemory.jumps;
    }

    void take(const Division& division) {
        mNow = division;
        mMemory.wsDirection = Vec3::Zero();
        if (division.isByDepth()) return;
        const Vec3 lsDirection(division.liDirection.x(), division.liDirection.y(), 0.0);
        mMemory.wsDirection = mImage.lsFromWs().transpose() * lsDirection;
        mMemory.shares = division.shares;
    }

    /// By depth, and along both sides of the rectangle around the focus region.
    Division ofWay(std::size_t way) {
        if (way == 0) return mSlices;
        const OrientedRectangle rectangle = smallestRectangle(hull());
        Vec2 direction(std::cos(rectangle.angle), std::sin(rectangle.angle));
        if (way == 2) direction = Vec2(-direction.y(), direction.x());
        return strips(direction,
                      stripShares(mScratch.samples, hull(), direction, mCount, mScratch.demands));
    }

    /// What the frame before had, as it is now.
    Division current() {
        if (mMemory.wsDirection.isZero(0.0)) return mSlices;
        Vec2 direction = (mImage.lsFromWs() * mMemory.wsDirection).head<2>();
        // A light that has turned into the strips' direction.
        constexpr double LeastSine = 0.1;
        if (!(direction.norm() > LeastSine)) {
            take(mSlices);
            ++mMemory.jumps;
            return mSlices;
        }
        direction.normalize();
        return strips(direction, mMemory.shares);
    }

    Division strips(const Vec2& liDirection, const BorderNumbers& shares) const {
        Division division;
        division.liDirection = liDirection;
        division.shares = shares;
        const Extent extent(hull(), liDirection);
        for (std::size_t i = 0; i + 1 < mCount; ++i)
            division.splits[i] = extent.liBegin + shares[i] * extent.size();
        division.parts = stripLight(mProblem.light, mImage, liDirection,
                                    std::span(division.splits).first(mCount - 1));
        return division;
    }

    /// The extents of the texels that serve the samples, all together.
    double costOf(const Division& division) {
        double cost = 0.0;
        for (std::size_t i = 0; i < division.parts.count; ++i) {
            mScratch.judged.memory = {};
            const ShadowFit fit =
                mTechnique(problemOf(mProblem, division.parts.parts[i]), mScratch.judged);
            if (fit.reason == FitReason::NoReceivers || fit.reason == FitReason::NothingShadowed)
                continue;
            if (!fit.hasMap()) return Infinity;
            const FitExtent extent(fit, mImage, mProblem.mapWidth, mProblem.mapHeight);
            for (const ViewSample& sample : mScratch.samples)
                if (division.partOf(sample) == i) cost += extent(sample);
        }
        return std::isnan(cost) ? Infinity : std::pow(cost, MeanPower);
    }

    const Polygon2& hull() const { return mScratch.region.liHull; }

    const ShadowProblem& mProblem;
    const LightImage mImage;
    const Division& mSlices;
    std::size_t mCount;
    StripMemory& mMemory;
    CascadeScratch& mScratch;
    const PartFit& mTechnique;
    Division mNow;
};

} // namespace

std::array<double, ShadowPart::MostBounds>
stripShares(const std::vector<ViewSample>& samples, const Polygon2& liHull, const Vec2& liDirection,
            std::size_t count, std::vector<std::pair<double, double>>& demands) {
    demands.clear();
    for (const ViewSample& sample : samples)
        demands.emplace_back(liDirection.dot(sample.liPoint), std::sqrt(sample.ndcFromLi.norm()));
    std::ranges::sort(demands);
    const Extent extent(liHull, liDirection);

    BorderNumbers shares{};
    std::array<Strip, ShadowPart::Most> strips;
    strips[0] = {extent.liBegin, extent.liEnd, demands};
    // The strip that gains most is cut in two, until there are enough.
    for (std::size_t made = 1; made < std::min(count, ShadowPart::Most); ++made) {
        Cut best;
        std::size_t where = 0;
        for (std::size_t i = 0; i < made; ++i) {
            const Cut cut = bestCut(strips[i]);
            if (!(cut.gain > best.gain)) continue;
            best = cut;
            where = i;
        }
        const Strip whole = strips[where];
        if (!(best.gain > 0.0)) {
            // All demand is at one place: any cut will do.
            best.li = (whole.liBegin + whole.liEnd) / 2.0;
            best.before = whole.demands.size();
        }
        std::copy_backward(strips.begin() + static_cast<std::ptrdiff_t>(where) + 1,
                           strips.begin() + static_cast<std::ptrdiff_t>(made),
                           strips.begin() + static_cast<std::ptrdiff_t>(made) + 1);
        strips[where] = {whole.liBegin, best.li, whole.demands.first(best.before)};
        strips[where + 1] = {best.li, whole.liEnd, whole.demands.subspan(best.before)};
    }
    for (std::size_t i = 0; i + 1 < count; ++i)
        shares[i] = (strips[i].liEnd - extent.liBegin) / extent.size();
    // Strips of no width would be no parts.
    for (std::size_t i = 0; i + 1 < count; ++i)
        shares[i] = std::clamp(shares[i], LeastShare * static_cast<double>(i + 1),
                               1.0 - LeastShare * static_cast<double>(count - 1 - i));
    for (std::size_t i = 1; i + 1 < count; ++i)
        shares[i] = std::max(shares[i], shares[i - 1] + LeastShare);
    return shares;
}

LightPartition divideView(const ShadowProblem& problem, std::size_t count,
                          const CascadeOptions& options, double vsPadding, CascadeMemory& memory,
                          CascadeScratch& scratch, std::vector<double>& vsSplits,
                          const PartFit& technique) {
    cascadeSplits(problem, count, options, memory, scratch, vsSplits);
    Division slices;
    slices.parts = sliceView(problem.viewer, problem.light, vsSplits, vsPadding);
    const bool mayStrip = options.stripLight && options.followReceivers &&
                          options.vsSplitDepths.empty() && !(vsPadding > 0.0);
    // Without splits there is nothing to divide, and the scratch memory is another problem's.
    const bool isCut = !std::isfinite(memory.change);
    const std::size_t parts = slices.parts.count;
    const bool isTooFew = scratch.samples.size() < FewestSamples;
    if (!mayStrip || vsSplits.empty() || parts != vsSplits.size() + 1 ||
        scratch.region.liHull.size() < 3 || (isTooFew && (isCut || memory.strips.count != parts))) {
        memory.strips.count = 0;
        return slices.parts;
    }
    std::ranges::copy(vsSplits, slices.splits.begin());
    Divider divider(problem, slices, memory.strips, scratch, technique);
    return isTooFew ? divider.keep() : divider.divide(memory.change);
}

} // namespace Lixel

#include "fit/focus/VisibleReceivers.h"

#include "fit/focus/BodyClipping.h"
#include "fit/focus/LitSurface.h"
#include "fit/focus/ViewVolume.h"
#include "fit/problem/ShadowPart.h"

#include <algorithm>

namespace Lixel {
namespace {

/// Widens `range` to the values between `least` and `greatest`.
void include(Vec2& range, double least, double greatest) {
    range = {std::min(range.x(), least), std::max(range.y(), greatest)};
}

} // namespace

VisibleReceivers::VisibleReceivers(const ShadowProblem& problem, const LightImage& image,
                                   const ConvexVolume& lit, FocusScratch& scratch, BoxSet& inView)
    : mProblem(problem),
      mImage(image),
      mScratch(scratch),
      mInView(inView),
      mLsDepth(lsDepthOf(image)),
      mVsDepth(-problem.viewer.viewFromWorld.row(2).head<3>().transpose(),
               -problem.viewer.viewFromWorld(2, 3)),
      mSeen(lit) {
    const ConvexVolume view = viewVolume(problem.viewer);
    mSeen.add(view.planes());
    if (problem.part != nullptr) mSeen.add(problem.part->bounds());
    scratch.receivers.reset(image);
    scratch.leaving.clear();
}

void VisibleReceivers::addAll(const BoxSet& receivers) {
    keepReaching(receivers, mSeen.planes(), mScratch.afterFirstPlanes, mInView);
    if (mProblem.receiverShapes != nullptr) mLarge = LargeBodies(mInView);
    addAllBut(
        mInView, [this](const BoxSet::Block& block) { return lanesWithin(block); },
        [this](const Aabb& box, std::size_t index) {
            const std::size_t revision = mScratch.receivers.revision();
            const Vec2 lsRange = mLsRange;
            const Vec2 vsRange = mVsRange;
            add(box, index);
            return revision != mScratch.receivers.revision() || lsRange != mLsRange ||
                   vsRange != mVsRange;
        });
}

void VisibleReceivers::add(const Aabb& box, std::size_t index) {
    const ConvexVolume::Side side = mSeen.classify(box);
    if (side == ConvexVolume::Side::Outside) return;
    if (addLitSurface(box, index)) return;
    const PlacedHull body(mProblem.receiverShapes, index);
    if (body.hull == nullptr && side == ConvexVolume::Side::Inside) return addCorners(box);
    body.clip(box, mSeen, mScratch);
    addPoints();
}

bool VisibleReceivers::addLitSurface(const Aabb& box, std::size_t index) {
    if (!mLarge.holds(box)) return false;
    SelfShadowFree known;
    if (!mProblem.receiverShapes->isSelfShadowFree(index, known) ||
        !mScratch.litSurface.find(known, mImage))
        return false;
    BoxSet& inView = mScratch.litSurfaceInView;
    keepReaching(mScratch.litSurface.boxes, mSeen.planes(), mScratch.afterFirstPlanes, inView);
    mScratch.wsPoints.clear();
    for (const Aabb& part : inView.boxes())
        clipBox(part, mSeen, mScratch.clip, mScratch.wsPoints);
    // All at once: a hull of many points is found sooner than it grows by them.
    addPoints();
    const LitSurface& surface = mScratch.litSurface;
    for (const auto& [side, left] : std::span(surface.leaving).first(surface.leavingCount)) {
        mScratch.wsPoints.clear();
        clipBox(side, mSeen, mScratch.clip, mScratch.wsPoints);
        forClipped(mProblem, mImage, mScratch, [&, left = left](const Vec3& ws, const Vec3& ls) {
            mScratch.leaving.push_back({mImage.project(ls), -ls.z(), mVsDepth.at(ws), left});
        });
    }
    return true;
}

void VisibleReceivers::addLeaving() {
    if (mScratch.leaving.empty() || hull().hull().empty()) return;
    const Vec2 liCentre = steinerPoint(hull().hull());
    const auto drawnIn = [](const Vec2& range, double value, double left) {
        const double nearest = std::clamp(value, range.x(), range.y());
        return nearest + left * (value - nearest);
    };
    const Vec2 lsRange = mLsRange;
    const Vec2 vsRange = mVsRange;
    mScratch.points.clear();
    for (const LeavingPoint& point : mScratch.leaving) {
        mScratch.points.push_back(liCentre + point.left * (point.liPoint - liCentre));
        const double ls = drawnIn(lsRange, point.lsDepth, point.left);
        include(mLsRange, ls, ls);
        const double vs = drawnIn(vsRange, point.vsDepth, point.left);
        include(mVsRange, vs, vs);
    }
    mScratch.receivers.add(mScratch.points);
}

void VisibleReceivers::addClipped(const Aabb& box) {
    PlacedHull(nullptr, 0).clip(box, mSeen, mScratch);
    addPoints();
}

unsigned VisibleReceivers::lanesWithin(const BoxSet::Block& block) const {
    const ImageHull& hull = mScratch.receivers;
    if (hull.edges().empty()) return 0;
    const unsigned lanes = lanesInside(block, hull.edges());
    if (lanes == 0) return 0;
    const std::array<HalfSpace, 4> ranges = {mLsDepth.from(mLsRange.x()), mLsDepth.to(mLsRange.y()),
                                             mVsDepth.from(mVsRange.x()),
                                             mVsDepth.to(mVsRange.y())};
    return lanes & lanesInside(block, ranges);
}

void VisibleReceivers::addCorners(const Aabb& box) {
    const Vec2 ls = mLsDepth.over(box);
    const Vec2 vs = mVsDepth.over(box);
    include(mLsRange, ls.x(), ls.y());
    include(mVsRange, vs.x(), vs.y());
    mScratch.receivers.add(boxImage(mImage, box));
}

void VisibleReceivers::addPoints() {
    mScratch.points.clear();
    forClipped(mProblem, mImage, mScratch, [this](const Vec3& ws, const Vec3& ls) {
        include(mLsRange, -ls.z(), -ls.z());
        const double depth = mVsDepth.at(ws);
        include(mVsRange, depth, depth);
        mScratch.points.push_back(mImage.project(ls));
    });
    mScratch.receivers.add(mScratch.points);
}

} // namespace Lixel

#include "fit/focus/RelevantCasters.h"

#include "fit/focus/BodyClipping.h"

#include <algorithm>

namespace Lixel {

RelevantCasters::RelevantCasters(const ShadowProblem& problem, const LightImage& image,
                                 const ConvexVolume& lit, const ImageHull& receivers,
                                 double lsReceiverFar, FocusScratch& scratch)
    : mProblem(problem),
      mImage(image),
      mLit(lit),
      mReceivers(receivers),
      mScratch(scratch),
      mLsDepth(lsDepthOf(image)),
      mLsReceiverFar(lsReceiverFar),
      mCoordinate(largestCoordinate(receivers.hull())) {
    scratch.casters.reset(image);
    mRevision = scratch.casters.revision();
    prepareEdges(receivers.hull(), 2.0 * clipSlack(mCoordinate), scratch.receiverEdges);
}

void RelevantCasters::addAll(const BoxSet& casters) {
    // Drops casters beside or behind all receivers. Edges far apart are tested first.
    const std::span<const HalfSpace> edges = mReceivers.edges();
    std::vector<HalfSpace>& planes = mScratch.planes;
    planes.clear();
    const std::size_t step = (edges.size() + 2) / 3;
    for (std::size_t begin = 0; begin < step; ++begin)
        for (std::size_t i = begin; i < edges.size(); i += step)
            planes.push_back(edges[i]);
    planes.push_back(mLsDepth.to(mLsReceiverFar));
    keepReaching(casters, planes, mScratch.afterFirstPlanes, mScratch.kept);

    planes.clear();
    addAllBut(
        mScratch.kept, [this](const BoxSet::Block& block) { return lanesWithin(block); },
        [this](const Aabb& box, std::size_t index) {
            const std::size_t revision = mScratch.casters.revision();
            const double lsNear = mLsNear;
            add(box, index);
            return revision != mScratch.casters.revision() || lsNear != mLsNear;
        });
}

unsigned RelevantCasters::lanesWithin(const BoxSet::Block& block) {
    const ImageHull& hull = mScratch.casters;
    if (hull.edges().empty()) return 0;
    if (mRevision != hull.revision()) {
        mRevision = hull.revision();
        findInnerEdges();
    }
    const unsigned lanes = lanesInside(block, mScratch.planes);
    // Casters are cut off at a local light's near distance: no box changes that.
    if (lanes == 0 ||
        (!mImage.directional() && mLsNear <= mProblem.light.nearDistance * (1.0 + TouchingSlack)))
        return lanes;
    const HalfSpace beyondNearest = mLsDepth.from(mLsNear);
    return lanes & lanesInside(block, {&beyondNearest, 1});
}

void RelevantCasters::findInnerEdges() {
    const Polygon2& inner = mScratch.casters.hull();
    const std::span<const HalfSpace> edges = mScratch.casters.edges();
    mScratch.planes.clear();
    for (std::size_t i = 0; i < inner.size(); ++i) {
        const Vec2& next = inner[i + 1 < inner.size() ? i + 1 : 0];
        if (!runsAlong(mScratch.receiverEdges, inner[i], next)) mScratch.planes.push_back(edges[i]);
    }
}

void RelevantCasters::add(const Aabb& box, std::size_t index) {
    const ConvexVolume::Side side = mLit.classify(box);
    if (side == ConvexVolume::Side::Outside) return;
    double nearest = mLsDepth.over(box).x();
    mScratch.points.clear();
    const PlacedHull body(mProblem.casterShapes, index);
    if (body.hull == nullptr && side == ConvexVolume::Side::Inside) {
        for (const Vec2& point : boxImage(mImage, box))
            mScratch.points.push_back(point);
    } else {
        nearest = std::numeric_limits<double>::infinity();
        body.clip(box, mLit, mScratch);
        forClipped(mProblem, mImage, mScratch, [&](const Vec3&, const Vec3& ls) {
            nearest = std::min(nearest, -ls.z());
            mScratch.points.push_back(mImage.project(ls));
        });
    }
    if (mScratch.points.empty()) return;
    if (!clipToReceivers(box)) return;
    mLsNear = std::min(mLsNear, nearest);
    mScratch.casters.add(mScratch.points);
}

bool RelevantCasters::clipToReceivers(const Aabb& box) {
    const Polygon2& outer = mReceivers.hull();
    const std::span<const HalfSpace> edges = mReceivers.edges();
    std::vector<Vec2>& points = mScratch.points;
    Polygon2& caster = mScratch.caster;
    if (edges.empty()) {
        convexHull(points, caster);
        intersect(outer, caster, points, mScratch.polygon);
        return !points.empty();
    }
    bool whole = true;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Vec2 over = Gauge(edges[i].normal, edges[i].offset).over(box);
        if (over.x() >= 0.0) continue;
        if (whole) {
            convexHull(points, caster);
            points.swap(caster);
            whole = false;
        }
        const double slack = clipSlack(std::max(mCoordinate, largestCoordinate(points)));
        clipLeftOf(points, outer[i], outer[i + 1 < outer.size() ? i + 1 : 0], slack, caster);
        points.swap(caster);
        if (points.empty()) return false;
    }
    return true;
}

} // namespace Lixel

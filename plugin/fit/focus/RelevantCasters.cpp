#include "fit/focus/RelevantCasters.h"

#include "fit/focus/BodyClipping.h"

#include <algorithm>

namespace Lixel {
namespace {

/// With fewer casters than this, each is looked at sooner than those at the rim are found.
constexpr std::size_t LeastForRim = 32;

/// Vertices of the receivers' hull at which one is looked for, at most.
constexpr std::size_t MostOfRim = 12;

} // namespace

RelevantCasters::RelevantCasters(const ShadowProblem& problem, const LightImage& image,
                                 const ConvexVolume& lit, const VisibleReceivers& visible,
                                 const BoxSet& inView, BoxSet& kept, FocusScratch& scratch)
    : mProblem(problem),
      mImage(image),
      mLit(lit),
      mSeen(visible.seen()),
      mReceivers(visible.hull()),
      mLarge(visible.large()),
      mInView(inView),
      mKept(kept),
      mScratch(scratch),
      mLsDepth(lsDepthOf(image)),
      mLsReceiverFar(visible.lsRange().y()),
      mCoordinate(largestCoordinate(mReceivers.hull())) {
    scratch.casters.reset(image);
    mRevision = scratch.casters.revision();
    prepareEdges(mReceivers.hull(), 2.0 * clipSlack(mCoordinate), scratch.receiverEdges);
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
    keepReaching(casters, planes, mScratch.afterFirstPlanes, mKept);

    // A receiver without bounds may be behind any body.
    if (mProblem.receivers->unbounded() == 0)
        mScratch.selfShadowFree.find(mProblem, mImage, mKept, mInView, mLarge);
    else
        mScratch.selfShadowFree.clear();

    planes.clear();
    if (!mScratch.selfShadowFree.all().empty()) addRim();
    addAllBut(
        mKept, [this](const BoxSet::Block& block) { return lanesWithin(block); },
        [this](const Aabb& box, std::size_t index) {
            const std::size_t revision = mScratch.casters.revision();
            const double lsNear = mLsNear;
            add(box, index);
            return revision != mScratch.casters.revision() || lsNear != mLsNear;
        });
    for (const Aabb& slope : mScratch.selfShadowFree.slopes())
        add(slope, PlacedHull(nullptr, 0));
    for (const SelfShadowFreeBody& body : mScratch.selfShadowFree.all())
        addSelfShadowFree(body);
}

void RelevantCasters::addRim() {
    const Polygon2& outer = mReceivers.hull();
    if (mKept.size() < LeastForRim || outer.size() < 3) return;
    std::array<Vec3, MostOfRim> directions;
    const std::size_t count = std::min(outer.size(), MostOfRim);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = i * outer.size() / count;
        const Vec2& vertex = outer[at];
        const Vec2 before = (vertex - outer[at > 0 ? at - 1 : outer.size() - 1]).stableNormalized();
        const Vec2 after = (outer[at + 1 < outer.size() ? at + 1 : 0] - vertex).stableNormalized();
        // Between the outward normals of the vertex's edges; a local light's points by their depth.
        const Vec2 outward(before.y() + after.y(), -before.x() - after.x());
        const double z = mImage.directional() ? 0.0 : outward.dot(vertex);
        directions[i] = mImage.lsFromWs().transpose() * Vec3(outward.x(), outward.y(), z);
    }
    std::array<std::size_t, MostOfRim> rim;
    farBoxes(mKept, std::span(directions).first(count), rim);
    for (std::size_t i = 0; i < count; ++i)
        add(mKept.box(rim[i]), mKept.origin(rim[i]));
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
    if (!mScratch.selfShadowFree.hasCaster(index))
        add(box, PlacedHull(mProblem.casterShapes, index));
}

void RelevantCasters::add(const Aabb& box, const PlacedHull& body) {
    const double nearest = project(box, body);
    if (mScratch.points.empty() || !clipToReceivers(box)) return;
    mLsNear = std::min(mLsNear, nearest);
    mScratch.casters.add(mScratch.points);
}

double RelevantCasters::project(const Aabb& box, const PlacedHull& body) {
    double nearest = std::numeric_limits<double>::infinity();
    mScratch.points.clear();
    const ConvexVolume::Side side = mLit.classify(box);
    if (side == ConvexVolume::Side::Outside) return nearest;
    if (body.hull == nullptr && side == ConvexVolume::Side::Inside) {
        for (const Vec2& point : boxImage(mImage, box))
            mScratch.points.push_back(point);
        return mLsDepth.over(box).x();
    }
    body.clip(box, mLit, mScratch);
    forClipped(mProblem, mImage, mScratch, [&](const Vec3&, const Vec3& ls) {
        nearest = std::min(nearest, -ls.z());
        mScratch.points.push_back(mImage.project(ls));
    });
    return nearest;
}

void RelevantCasters::addSelfShadowFree(const SelfShadowFreeBody& body) {
    const Aabb box = mProblem.casters->box(body.caster);
    const double nearest = project(box, PlacedHull(mProblem.casterShapes, body.caster));
    if (mScratch.points.empty() || !clipToReceivers(box)) return;
    // Most are among others, and whether they shadow themselves makes no difference.
    if (mScratch.casters.holds(mScratch.points)) {
        mLsNear = std::min(mLsNear, nearest);
        return;
    }
    convexHull(mScratch.points, mScratch.ownImage);
    std::array<HalfSpace, 3> behind;
    const std::size_t count =
        behindLitFaces(body.around, mImage, mProblem.receivers->extent(), behind);
    const std::span<const HalfSpace> planes(behind.data(), count);
    keepReaching(mInView, planes, mScratch.afterFirstPlanes, mScratch.behind);
    ConvexVolume shadowed = mSeen;
    shadowed.add(planes);
    const auto isDone = [&](const BoxSet::Block& block) {
        return nearest < mLsNear ? 0U : lanesWithin(block);
    };
    addAllBut(mScratch.behind, isDone, [&](const Aabb& receiver, std::size_t index) {
        if (mProblem.receiverShapes->identityOf(index) == body.identity) return false;
        PlacedHull(mProblem.receiverShapes, index).clip(receiver, shadowed, mScratch);
        mScratch.points.clear();
        forClipped(mProblem, mImage, mScratch, [this](const Vec3&, const Vec3& ls) {
            mScratch.points.push_back(mImage.project(ls));
        });
        convexHull(mScratch.points, mScratch.caster);
        intersect(mScratch.ownImage, mScratch.caster, mScratch.points, mScratch.polygon);
        if (mScratch.points.empty()) return false;
        mLsNear = std::min(mLsNear, nearest);
        mScratch.casters.add(mScratch.points);
        return true;
    });
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

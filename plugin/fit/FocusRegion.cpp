#include "fit/FocusRegion.h"

#include "fit/BodyHull.h"
#include "fit/BoxQuery.h"
#include "fit/Lanes.h"
#include "fit/LightVolume.h"
#include "fit/ShadowParts.h"
#include "fit/VectorClones.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace Lixel {
namespace {

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Widens `range` to the values between `least` and `greatest`.
void include(Vec2& range, double least, double greatest) {
    range = {std::min(range.x(), least), std::max(range.y(), greatest)};
}

/** Calls `add` for the boxes of a set and their origins, but for those in `within(block)`, a set of
    lanes as bits which may grow where `add` returns true. The largest comes first: it is the
    likeliest to spare the others. */
template <typename Within, typename Add>
void addAllBut(const BoxSet& boxes, const Within& within, const Add& add) {
    if (boxes.size() == 0) return;
    const std::size_t largest = largestBox(boxes);
    add(boxes.box(largest), boxes.origin(largest));
    std::size_t first = 0;
    for (const BoxSet::Block& block : boxes.blocks()) {
        const std::size_t count = std::min(boxes.size() - first, BoxSet::BlockSize);
        unsigned rest = (1U << count) - 1;
        if (largest - first < count) rest &= ~(1U << (largest - first));
        rest &= ~within(block);
        while (rest != 0) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
            rest &= rest - 1;
            if (add(boxes.box(first + lane), boxes.origin(first + lane)) && rest != 0) rest &= ~within(block);
        }
        first += BoxSet::BlockSize;
    }
}

/// A body's hull, if it is known, and where it is.
struct PlacedHull {
    const BodyHull* hull = nullptr;
    Eigen::Affine3d wsFromBody;

    PlacedHull(const BodyShapes* shapes, std::size_t index) {
        if (shapes != nullptr) hull = shapes->hullOf(index, wsFromBody);
    }
};

/// Collects what is visible of receivers.
class Receivers {
public:
    Receivers(const ShadowProblem& problem, const LightImage& image, const ConvexVolume& lit,
              FocusScratch& scratch)
        : mProblem(problem),
          mImage(image),
          mScratch(scratch),
          mLsDepth(lsDepthOf(image)),
          mVsDepth(-problem.viewer.viewFromWorld.row(2).head<3>().transpose(),
                   -problem.viewer.viewFromWorld(2, 3)),
          mSeen(lit) {
        const ConvexVolume view = viewVolume(problem.viewer);
        mSeen.add(view.planes());
        if (problem.part != nullptr) mSeen.add(problem.part->bounds());
        scratch.receivers.reset(image);
    }

    void addAll(const BoxSet& receivers) {
        keepReaching(receivers, mSeen.planes(), mScratch.nearly, mScratch.receiversInView);
        addAllBut(
            mScratch.receiversInView,
            [this](const BoxSet::Block& block) { return lanesWithin(block); },
            [this](const Box& box, std::size_t index) {
                const std::size_t revision = mScratch.receivers.revision();
                const Vec2 lsRange = mLsRange;
                const Vec2 vsRange = mVsRange;
                add(box, index);
                return revision != mScratch.receivers.revision() || lsRange != mLsRange ||
                       vsRange != mVsRange;
            });
    }
    /// Adds what is visible of a body.
    void add(const Box& box, std::size_t index) {
        const ConvexVolume::Side side = mSeen.classify(box);
        if (side == ConvexVolume::Side::Outside) return;
        const PlacedHull body(mProblem.receiverShapes, index);
        if (body.hull != nullptr) {
            mScratch.wsPoints.clear();
            clipHull(*body.hull, body.wsFromBody, mSeen, mScratch.clip, mScratch.wsPoints);
            addPoints();
        } else if (side == ConvexVolume::Side::Inside) {
            addCorners(box);
        } else {
            addClipped(box);
        }
    }

    void addClipped(const Box& box) {
        mScratch.wsPoints.clear();
        clipBox(box, mSeen, mScratch.clip, mScratch.wsPoints);
        addPoints();
    }

    const Vec2& lsRange() const { return mLsRange; }
    const Vec2& vsRange() const { return mVsRange; }

private:
    /// The lanes of boxes of which all, in view or not, lies within what was added already.
    unsigned lanesWithin(const BoxSet::Block& block) const {
        const ImageHull& hull = mScratch.receivers;
        if (hull.edges().empty()) return 0;
        const unsigned lanes = lanesInside(block, hull.edges());
        if (lanes == 0) return 0;
        const std::array<Plane, 4> ranges = {mLsDepth.from(mLsRange.x()), mLsDepth.to(mLsRange.y()),
                                             mVsDepth.from(mVsRange.x()),
                                             mVsDepth.to(mVsRange.y())};
        return lanes & lanesInside(block, ranges);
    }

    void addCorners(const Box& box) {
        const Vec2 ls = mLsDepth.over(box);
        const Vec2 vs = mVsDepth.over(box);
        include(mLsRange, ls.x(), ls.y());
        include(mVsRange, vs.x(), vs.y());
        for (const Vec2& point : boxImage(mImage, box))
            mScratch.receivers.add(point);
    }

    void addPoints() {
        for (const Vec3& ws : mScratch.wsPoints) {
            const Vec3 ls = mImage.lsFromPoint(ws);
            // A clipped vertex lies on the near plane but for rounding; nothing is divided by less.
            if (!mImage.directional() && -ls.z() < 0.5 * mProblem.light.nearDistance) continue;
            include(mLsRange, -ls.z(), -ls.z());
            const double depth = mVsDepth.at(ws);
            include(mVsRange, depth, depth);
            mScratch.receivers.add(mImage.project(ls));
        }
    }

    const ShadowProblem& mProblem;
    const LightImage& mImage;
    FocusScratch& mScratch;
    Gauge mLsDepth;
    Gauge mVsDepth;
    ConvexVolume mSeen;
    Vec2 mLsRange = Vec2(Infinity, -Infinity);
    Vec2 mVsRange = Vec2(Infinity, -Infinity);
};

/// Prepares the edges of a convex polygon, each with a slack for its vertices' coordinates.
void prepareEdges(const Polygon2& polygon, double slack, std::vector<FourEdges>& edges) {
    // Along much of the edge, and the same way: the other side of a flat hull limits it, and
    // the direction of an edge as short as rounding says nothing.
    constexpr double SharedPart = 1.0 / 1024.0;
    edges.clear();
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n && n > 2; ++i) {
        const std::size_t lane = i % 4;
        // Nothing runs along the lanes beyond the last edge.
        if (lane == 0) edges.emplace_back().shared.fill(Infinity);
        FourEdges& four = edges.back();
        const Vec2& from = polygon[i];
        const Vec2 edge = polygon[i + 1 < n ? i + 1 : 0] - from;
        four.fromX[lane] = from.x();
        four.fromY[lane] = from.y();
        four.edgeX[lane] = edge.x();
        four.edgeY[lane] = edge.y();
        four.shared[lane] = SharedPart * edge.squaredNorm();
        four.slack[lane] = slack * edge.cwiseAbs().sum();
    }
}

/// Whether the edge from a to b runs along one of those.
LIXEL_VECTOR_CLONES
bool runsAlong(std::span<const FourEdges> edges, const Vec2& a, const Vec2& b) {
    const Vec2 own = b - a;
    for (const FourEdges& four : edges) {
        Four fromX;
        Four fromY;
        Four edgeX;
        Four edgeY;
        Four shared;
        Four slack;
        load(four.fromX.data(), fromX);
        load(four.fromY.data(), fromY);
        load(four.edgeX.data(), edgeX);
        load(four.edgeY.data(), edgeY);
        load(four.shared.data(), shared);
        load(four.slack.data(), slack);
        const Four offA = edgeX * (a.y() - fromY) - edgeY * (a.x() - fromX);
        const Four offB = edgeX * (b.y() - fromY) - edgeY * (b.x() - fromX);
        const FourMask along = (edgeX * own.x() + edgeY * own.y() > shared) & (offA <= slack) &
                               (offA >= -slack) & (offB <= slack) & (offB >= -slack);
        if (bitsOf(along) != 0) return true;
    }
    return false;
}

/// Collects what casters cover of the visible receivers, whose hull is in the scratch memory.
class Casters {
public:
    Casters(const ShadowProblem& problem, const LightImage& image, const ConvexVolume& lit,
            double lsReceiverFar, FocusScratch& scratch)
        : mProblem(problem),
          mImage(image),
          mLit(lit),
          mScratch(scratch),
          mLsDepth(lsDepthOf(image)),
          mLsReceiverFar(lsReceiverFar),
          mCoordinate(largestCoordinate(scratch.receivers.hull())) {
        scratch.casters.reset(image);
        mRevision = scratch.casters.revision();
        prepareEdges(scratch.receivers.hull(), 2.0 * clipSlack(mCoordinate), scratch.receiverEdges);
    }

    void addAll(const BoxSet& casters) {
        // What is beside all receivers or behind them. The first edges to ask are apart.
        const std::span<const Plane> edges = mScratch.receivers.edges();
        std::vector<Plane>& planes = mScratch.planes;
        planes.clear();
        const std::size_t step = (edges.size() + 2) / 3;
        for (std::size_t begin = 0; begin < step; ++begin)
            for (std::size_t i = begin; i < edges.size(); i += step)
                planes.push_back(edges[i]);
        planes.push_back(mLsDepth.to(mLsReceiverFar));
        keepReaching(casters, planes, mScratch.nearly, mScratch.kept);

        planes.clear();
        addAllBut(
            mScratch.kept, [this](const BoxSet::Block& block) { return lanesWithin(block); },
            [this](const Box& box, std::size_t index) {
                const std::size_t revision = mScratch.casters.revision();
                const double lsNear = mLsNear;
                add(box, index);
                return revision != mScratch.casters.revision() || lsNear != mLsNear;
            });
    }

    /// Distance along the light of the nearest that was added; infinite before.
    double lsNear() const { return mLsNear; }

private:
    /// The lanes of boxes that would neither widen the hull, once they are cut off where no
    /// receiver is, nor are nearer to the light.
    unsigned lanesWithin(const BoxSet::Block& block) {
        const ImageHull& hull = mScratch.casters;
        if (hull.edges().empty()) return 0;
        if (mRevision != hull.revision()) {
            mRevision = hull.revision();
            findInnerEdges();
        }
        const unsigned lanes = lanesInside(block, mScratch.planes);
        // Casters are cut off at a local light's near distance: no box changes that.
        if (lanes == 0 || (!mImage.directional() &&
                           mLsNear <= mProblem.light.nearDistance * (1.0 + TouchingSlack)))
            return lanes;
        const Plane beyondNearest = mLsDepth.from(mLsNear);
        return lanes & lanesInside(block, {&beyondNearest, 1});
    }

    /// Leaves the edges along the receivers' hull out: nothing that is kept reaches beyond them.
    void findInnerEdges() {
        const Polygon2& inner = mScratch.casters.hull();
        const std::span<const Plane> edges = mScratch.casters.edges();
        mScratch.planes.clear();
        for (std::size_t i = 0; i < inner.size(); ++i) {
            const Vec2& next = inner[i + 1 < inner.size() ? i + 1 : 0];
            if (!runsAlong(mScratch.receiverEdges, inner[i], next))
                mScratch.planes.push_back(edges[i]);
        }
    }

    void add(const Box& box, std::size_t index) {
        const ConvexVolume::Side side = mLit.classify(box);
        if (side == ConvexVolume::Side::Outside) return;
        double nearest = mLsDepth.over(box).x();
        mScratch.points.clear();
        const PlacedHull body(mProblem.casterShapes, index);
        if (body.hull == nullptr && side == ConvexVolume::Side::Inside) {
            for (const Vec2& point : boxImage(mImage, box))
                mScratch.points.push_back(point);
        } else {
            nearest = Infinity;
            mScratch.wsPoints.clear();
            if (body.hull != nullptr)
                clipHull(*body.hull, body.wsFromBody, mLit, mScratch.clip, mScratch.wsPoints);
            else
                clipBox(box, mLit, mScratch.clip, mScratch.wsPoints);
            for (const Vec3& ws : mScratch.wsPoints) {
                const Vec3 ls = mImage.lsFromPoint(ws);
                if (!mImage.directional() && -ls.z() < 0.5 * mProblem.light.nearDistance) continue;
                nearest = std::min(nearest, -ls.z());
                mScratch.points.push_back(mImage.project(ls));
            }
        }
        if (mScratch.points.empty()) return;
        if (!clipToReceivers(box)) return;
        mLsNear = std::min(mLsNear, nearest);
        for (const Vec2& point : mScratch.points)
            mScratch.casters.add(point);
    }

    /// Of each caster only what covers visible receivers: one that touches them with a corner then
    /// joins the region with that corner, and not with all of itself.
    /// @return whether anything is left of the points
    bool clipToReceivers(const Box& box) {
        const Polygon2& outer = mScratch.receivers.hull();
        const std::span<const Plane> edges = mScratch.receivers.edges();
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

    const ShadowProblem& mProblem;
    const LightImage& mImage;
    const ConvexVolume& mLit;
    FocusScratch& mScratch;
    Gauge mLsDepth;
    double mLsReceiverFar;
    double mLsNear = Infinity;
    /// The largest coordinate of the receivers' hull.
    double mCoordinate;
    std::size_t mRevision = 0;
};

} // namespace

void findFocusRegion(const ShadowProblem& problem, const LightImage& image, FocusScratch& scratch,
                     FocusRegion& region) {
    region = FocusRegion{.reason = FitReason::None, .liHull = std::move(region.liHull)};
    region.liHull.clear();
    const auto stop = [&](FitReason reason) { region.reason = reason; };

    const BoxSet& casters = *problem.casters;
    const BoxSet& receivers = *problem.receivers;
    if (casters.empty()) return stop(FitReason::NoCasters);

    // Visible receivers, clipped to what the viewer sees and the light reaches.
    const ConvexVolume lit = lightVolume(problem.light, image);
    Receivers visible(problem, image, lit, scratch);
    visible.addAll(receivers);
    if (receivers.unbounded() > 0) {
        Box everything;
        if (!viewBounds(problem.viewer, everything)) return stop(FitReason::Unbounded);
        visible.addClipped(everything);
        region.reason = FitReason::UnboundedBody;
    }
    if (scratch.receivers.hull().empty()) return stop(FitReason::NoReceivers);
    region.lsReceiverNear = visible.lsRange().x();
    region.lsReceiverFar = visible.lsRange().y();
    region.vsReceiverNear = visible.vsRange().x();
    region.vsReceiverFar = visible.vsRange().y();

    // Casters between the light and a visible receiver.
    Casters covering(problem, image, lit, region.lsReceiverFar, scratch);
    covering.addAll(casters);
    region.lsCasterNear = covering.lsNear();
    if (casters.unbounded() > 0) {
        region.reason = FitReason::UnboundedBody;
        region.lsCasterNear = std::min(region.lsCasterNear, region.lsReceiverNear);
        region.liHull = scratch.receivers.hull();
    } else {
        region.liHull = scratch.casters.hull();
    }
    if (region.liHull.empty()) return stop(FitReason::NothingShadowed);
    region.liCentre = steinerPoint(region.liHull);
}

} // namespace Lixel

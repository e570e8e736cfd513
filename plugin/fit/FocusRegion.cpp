#include "fit/FocusRegion.h"

#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <numbers>

namespace Lixel {
namespace {

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Number of planes around a spot's cone. Eight overestimate its radius by 1/cos(π/8) = 8 %.
constexpr int ConeSides = 8;

/// The space a local light shines into, in world axes: in front of its near distance, within its
/// range, inside a pyramid around its cone. Everything for a directional light.
void addLightVolume(const ShadowLight& light, const LightImage& image, ConvexVolume& volume) {
    if (image.directional()) return;
    const Vec3 axis = -image.lsFromWs().row(2).transpose();
    const Vec3& eye = image.wsEye();
    const auto add = [&](const Vec3& normal, double distance) {
        volume.add(normal, -normal.dot(eye) - distance);
    };
    add(axis, light.nearDistance);
    if (std::isfinite(light.range)) add(-axis, -light.range);
    for (int i = 0; i < ConeSides; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / ConeSides;
        const Vec3 side = image.lsFromWs().transpose() * Vec3(std::cos(turn), std::sin(turn), 0.0);
        // The plane through the apex that touches the cone along `side`.
        add(std::sin(light.outerHalfAngle) * axis - std::cos(light.outerHalfAngle) * side, 0.0);
    }
}

/// An affine function of world points, and its range over a box.
struct Gauge {
    Vec3 normal;
    Vec3 absolute;
    double offset;

    Gauge(const Vec3& n, double d) : normal(n), absolute(n.cwiseAbs()), offset(d) {}
    double at(const Vec3& ws) const { return normal.dot(ws) + offset; }
    Vec2 over(const Box& box) const {
        const double middle = at(box.centre);
        const double reach = absolute.dot(box.halfExtents);
        return {middle - reach, middle + reach};
    }
};

/// A box that holds the volume, for bodies without bounds; false where the volume has none either.
bool boundsOf(const ShadowViewer& viewer, Box& box) {
    const Mat4 clipFromWorld = viewer.clipFromView * viewer.viewFromWorld;
    const Mat4 worldFromClip = clipFromWorld.inverse();
    Vec3 lower = Vec3::Constant(Infinity);
    Vec3 upper = -lower;
    const auto include = [&](const Vec3& p) {
        lower = lower.cwiseMin(p);
        upper = upper.cwiseMax(p);
    };
    for (int i = 0; i < 4; ++i) {
        const double x = (i & 1) != 0 ? 1.0 : -1.0;
        const double y = (i & 2) != 0 ? 1.0 : -1.0;
        const Vec4 nearCorner = worldFromClip * Vec4(x, y, -1.0, 1.0);
        const Vec4 farCorner = worldFromClip * Vec4(x, y, 1.0, 1.0);
        if (!(nearCorner.w() > 0.0)) return false;
        const Vec3 a = nearCorner.head<3>() / nearCorner.w();
        // The corner of the shadow distance lies on the same edge of the view, which runs towards
        // farCorner - w * a, a direction also where the far corner itself is at infinity.
        const Vec3 edge = farCorner.head<3>() - farCorner.w() * a;
        const auto depth = [&](const Vec4& p) { return -viewer.viewFromWorld.row(2).dot(p); };
        const double perUnit = depth(Vec4(edge.x(), edge.y(), edge.z(), 0.0));
        double t = farCorner.w() > 0.0 ? 1.0 / farCorner.w() : Infinity;
        if (viewer.shadowDistance > 0.0 && perUnit > 0.0)
            t = std::min(t,
                         (viewer.shadowDistance - depth(Vec4(a.x(), a.y(), a.z(), 1.0))) / perUnit);
        if (!std::isfinite(t)) return false;
        include(a);
        include(a + std::max(t, 0.0) * edge);
    }
    box = {(lower + upper) / 2.0, (upper - lower) / 2.0};
    return box.centre.allFinite() && box.halfExtents.allFinite();
}

/// Relative rounding within which two bodies count as touching.
constexpr double TouchingSlack = 1e-12;

/// Widens `range` to the values between `least` and `greatest`.
void include(Vec2& range, double least, double greatest) {
    range = {std::min(range.x(), least), std::max(range.y(), greatest)};
}

bool holds(const Vec2& range, const Vec2& other) {
    return range.x() <= other.x() && other.y() <= range.y();
}

/// Collects what is visible of receivers.
class Receivers {
public:
    Receivers(const ShadowProblem& problem, const LightImage& image, FocusScratch& scratch)
        : mProblem(problem),
          mImage(image),
          mScratch(scratch),
          mLsDepth(-image.lsFromWs().row(2).transpose(),
                   image.lsFromWs().row(2).dot(image.wsEye())),
          mVsDepth(-problem.viewer.viewFromWorld.row(2).head<3>().transpose(),
                   -problem.viewer.viewFromWorld(2, 3)),
          mSeen(viewVolume(problem.viewer)) {
        addLightVolume(problem.light, image, mSeen);
        scratch.receivers.reset(image);
        scratch.straddling.clear();
    }

    /// Adds a receiver, or puts it off until a clearly larger one has widened the hull: clipping is
    /// dear, and most boxes at the rim of the view are inside what a ground shows there.
    void add(const Box& box) {
        if (addsNothing(box)) return;
        switch (mSeen.classify(box)) {
        case ConvexVolume::Side::Outside:
            return;
        case ConvexVolume::Side::Inside:
            addCorners(box);
            return;
        case ConvexVolume::Side::Straddles:
            const double size = box.halfExtents.sum();
            if (size > 2.0 * mLargestClipped) {
                mLargestClipped = size;
                addClipped(box);
            } else {
                mScratch.straddling.push_back(box);
            }
            return;
        }
    }
    void addPutOff() {
        for (const Box& box : mScratch.straddling)
            if (!addsNothing(box)) addClipped(box);
    }

    const Vec2& lsRange() const { return mLsRange; }
    const Vec2& vsRange() const { return mVsRange; }

private:
    /// Whether all of the box, in view or not, lies within what was added already; or beyond the
    /// shadow distance.
    bool addsNothing(const Box& box) const {
        const Vec2 vs = mVsDepth.over(box);
        const double shadowDistance = mProblem.viewer.shadowDistance;
        if (shadowDistance > 0.0 && vs.x() > shadowDistance) return true;
        return holds(mVsRange, vs) && holds(mLsRange, mLsDepth.over(box)) &&
               mScratch.receivers.classify(box) == ConvexVolume::Side::Inside;
    }

    void addCorners(const Box& box) {
        const Vec2 ls = mLsDepth.over(box);
        const Vec2 vs = mVsDepth.over(box);
        include(mLsRange, ls.x(), ls.y());
        include(mVsRange, vs.x(), vs.y());
        for (const Vec3& ws : corners(box))
            mScratch.receivers.add(mImage.project(mImage.lsFromPoint(ws)));
    }

    void addClipped(const Box& box) {
        mScratch.wsPoints.clear();
        clipBox(box, mSeen, mScratch.clip, mScratch.wsPoints);
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
    double mLargestClipped = 0.0;
};

} // namespace

void ImageHull::reset(const LightImage& image) {
    mImage = image;
    mHull.clear();
    mPoints.clear();
    mEdges.clear();
}

void ImageHull::add(const Vec2& point) {
    // Updates are worth their sorting while points are few, and cost less than all points at once.
    constexpr std::size_t LeastNews = 32;
    mPoints.push_back(point);
    if (mPoints.size() >= 2 * mHull.size() + LeastNews) update();
}

const Polygon2& ImageHull::hull() {
    if (mPoints.size() != mHull.size()) update();
    return mHull;
}

void ImageHull::update() {
    convexHull(mPoints, mHull);
    mPoints.assign(mHull.begin(), mHull.end());
    mEdges.clear();
    for (std::size_t i = 0; i < mHull.size() && mHull.size() > 2; ++i) {
        const Vec2& a = mHull[i];
        const Vec2 edge = mHull[(i + 1) % mHull.size()] - a;
        // cross(edge, q - a) >= 0 for q = (x, y), or for q = (x, y) / -z with -z multiplied out.
        const double at = cross(edge, a);
        const Vec3 ls(-edge.y(), edge.x(), mImage.directional() ? 0.0 : at);
        const Vec3 ws = mImage.lsFromWs().transpose() * ls;
        mEdges.push_back(
            {ws, ws.cwiseAbs(), -ws.dot(mImage.wsEye()) - (mImage.directional() ? at : 0.0)});
    }
}

ConvexVolume::Side ImageHull::classify(const Box& box) const {
    ConvexVolume::Side side =
        mEdges.empty() ? ConvexVolume::Side::Straddles : ConvexVolume::Side::Inside;
    for (const EdgePlane& edge : mEdges) {
        const double distance = edge.normal.dot(box.centre) + edge.offset;
        const double reach = edge.absolute.dot(box.halfExtents);
        // A box that touches an edge from outside shares its rays.
        const double slack = TouchingSlack * (std::abs(edge.offset) +
                                              edge.absolute.dot(box.centre.cwiseAbs()) + reach);
        if (distance < -reach - slack) return ConvexVolume::Side::Outside;
        if (distance < reach) side = ConvexVolume::Side::Straddles;
    }
    return side;
}

void findFocusRegion(const ShadowProblem& problem, const LightImage& image, FocusScratch& scratch,
                     FocusRegion& region) {
    region = FocusRegion{.reason = FitReason::None, .liHull = std::move(region.liHull)};
    region.liHull.clear();
    const auto stop = [&](FitReason reason) { region.reason = reason; };

    const BoxSet& casters = *problem.casters;
    const BoxSet& receivers = *problem.receivers;
    if (casters.empty()) return stop(FitReason::NoCasters);

    // Visible receivers, clipped to what the viewer sees and the light reaches.
    Receivers visible(problem, image, scratch);
    for (const Box& box : receivers.boxes())
        visible.add(box);
    Box everything;
    if (receivers.unbounded() > 0) {
        if (!boundsOf(problem.viewer, everything)) return stop(FitReason::Unbounded);
        visible.add(everything);
        region.reason = FitReason::UnboundedBody;
    }
    visible.addPutOff();
    const Polygon2& receiverHull = scratch.receivers.hull();
    if (receiverHull.empty()) return stop(FitReason::NoReceivers);
    region.lsReceiverNear = visible.lsRange().x();
    region.lsReceiverFar = visible.lsRange().y();
    region.vsReceiverNear = visible.vsRange().x();
    region.vsReceiverFar = visible.vsRange().y();

    // Casters between the light and a visible receiver.
    region.lsCasterNear = Infinity;
    const Gauge lsDepth(-image.lsFromWs().row(2).transpose(),
                        image.lsFromWs().row(2).dot(image.wsEye()));
    ConvexVolume lit;
    addLightVolume(problem.light, image, lit);
    scratch.casters.reset(image);
    for (const Box& box : casters.boxes()) {
        double nearest = lsDepth.over(box).x();
        // A body without depth along the light may shadow itself.
        if (nearest > region.lsReceiverFar + TouchingSlack * std::abs(nearest)) continue;
        const bool nearer = nearest < region.lsCasterNear;
        if (!nearer && scratch.casters.classify(box) == ConvexVolume::Side::Inside) continue;
        if (scratch.receivers.classify(box) == ConvexVolume::Side::Outside) continue;

        scratch.points.clear();
        switch (lit.classify(box)) {
        case ConvexVolume::Side::Outside:
            continue;
        case ConvexVolume::Side::Inside:
            for (const Vec3& ws : corners(box))
                scratch.points.push_back(image.project(image.lsFromPoint(ws)));
            break;
        case ConvexVolume::Side::Straddles:
            nearest = Infinity;
            scratch.wsPoints.clear();
            clipBox(box, lit, scratch.clip, scratch.wsPoints);
            for (const Vec3& ws : scratch.wsPoints) {
                const Vec3 ls = image.lsFromPoint(ws);
                if (-ls.z() < 0.5 * problem.light.nearDistance) continue;
                nearest = std::min(nearest, -ls.z());
                scratch.points.push_back(image.project(ls));
            }
            break;
        }
        if (scratch.points.empty()) continue;
        // Of each caster only what covers visible receivers: one that touches them with a corner
        // then joins the region with that corner, and not with all of itself.
        convexHull(scratch.points, scratch.caster);
        intersect(receiverHull, scratch.caster, region.liHull, scratch.polygon);
        if (region.liHull.empty()) continue;
        region.lsCasterNear = std::min(region.lsCasterNear, nearest);
        for (const Vec2& point : region.liHull)
            scratch.casters.add(point);
    }
    if (casters.unbounded() > 0) {
        region.reason = FitReason::UnboundedBody;
        region.lsCasterNear = std::min(region.lsCasterNear, region.lsReceiverNear);
        region.liHull = receiverHull;
    } else {
        region.liHull = scratch.casters.hull();
    }
    if (region.liHull.empty()) return stop(FitReason::NothingShadowed);
    region.liCentre = steinerPoint(region.liHull);
}

} // namespace Lixel

#pragma once

#include "fit/focus/LightVolume.h"
#include "fit/focus/VisibleReceivers.h"

#include <limits>

namespace Lixel {

struct PlacedHull;

/// Collects what casters cover of the visible receivers.
class RelevantCasters {
public:
    /// @param lit what the light reaches; must outlive this
    /// @param visible the visible receivers; must outlive this
    /// @param inView the receivers that may reach into what is in view; must outlive this
    /// @param[out] kept the casters that may cover visible receivers; must outlive this
    RelevantCasters(const ShadowProblem& problem, const LightImage& image, const ConvexVolume& lit,
                    const VisibleReceivers& visible, const BoxSet& inView, BoxSet& kept,
                    FocusScratch& scratch);

    void addAll(const BoxSet& casters);

    /// Hull of what was added, in the light image.
    const ImageHull& hull() const { return mScratch.casters; }
    /// Distance along the light of the nearest that was added; infinite before.
    double lsNear() const { return mLsNear; }

private:
    /// Adds casters near the vertices of the receivers' hull first: what lies between them need not
    /// be looked at one by one.
    void addRim();
    /// The lanes of boxes that change nothing: clipped to the receivers, they would not widen the
    /// hull, and they are no nearer to the light than what was added.
    unsigned lanesWithin(const BoxSet::Block& block);
    /// Leaves the edges along the receivers' hull out: nothing that is kept reaches beyond them.
    void findInnerEdges();
    /// @param index of the body in the problem's set
    void add(const Aabb& box, std::size_t index);
    void add(const Aabb& box, const PlacedHull& body);
    /// Leaves the image of what is lit of a caster in the scratch memory's points.
    /// @return its least distance along the light; infinite where there are no points
    double project(const Aabb& box, const PlacedHull& body);
    /// Adds what a body without shadows on itself covers of visible receivers behind it.
    void addSelfShadowFree(const SelfShadowFreeBody& body);
    /// Of each caster only what covers visible receivers: one that touches them with a corner then
    /// joins the region with that corner, and not with all of itself.
    /// @return whether anything is left of the points
    bool clipToReceivers(const Aabb& box);

    const ShadowProblem& mProblem;
    const LightImage& mImage;
    const ConvexVolume& mLit;
    const ConvexVolume& mSeen;
    const ImageHull& mReceivers;
    const LargeBodies& mLarge;
    const BoxSet& mInView;
    BoxSet& mKept;
    FocusScratch& mScratch;
    Gauge mLsDepth;
    double mLsReceiverFar;
    double mLsNear = std::numeric_limits<double>::infinity();
    /// The largest coordinate of the receivers' hull.
    double mCoordinate;
    std::size_t mRevision = 0;
};

} // namespace Lixel

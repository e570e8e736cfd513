#pragma once

#include "fit/focus/FocusScratch.h"
#include "fit/focus/LightVolume.h"

#include <limits>

namespace Lixel {

/// Collects what casters cover of the visible receivers.
class RelevantCasters {
public:
    /// @param lit what the light reaches; must outlive this
    /// @param receivers hull of the visible receivers; must outlive this
    /// @param lsReceiverFar distance of the farthest visible receiver along the light's axis
    RelevantCasters(const ShadowProblem& problem, const LightImage& image, const ConvexVolume& lit,
                    const ImageHull& receivers, double lsReceiverFar, FocusScratch& scratch);

    void addAll(const BoxSet& casters);

    /// Hull of what was added, in the light image.
    const ImageHull& hull() const { return mScratch.casters; }
    /// Distance along the light of the nearest that was added; infinite before.
    double lsNear() const { return mLsNear; }

private:
    /// The lanes of boxes that change nothing: clipped to the receivers, they would not widen the
    /// hull, and they are no nearer to the light than what was added.
    unsigned lanesWithin(const BoxSet::Block& block);
    /// Leaves the edges along the receivers' hull out: nothing that is kept reaches beyond them.
    void findInnerEdges();
    /// @param index of the body in the problem's set
    void add(const Aabb& box, std::size_t index);
    /// Of each caster only what covers visible receivers: one that touches them with a corner then
    /// joins the region with that corner, and not with all of itself.
    /// @return whether anything is left of the points
    bool clipToReceivers(const Aabb& box);

    const ShadowProblem& mProblem;
    const LightImage& mImage;
    const ConvexVolume& mLit;
    const ImageHull& mReceivers;
    FocusScratch& mScratch;
    Gauge mLsDepth;
    double mLsReceiverFar;
    double mLsNear = std::numeric_limits<double>::infinity();
    /// The largest coordinate of the receivers' hull.
    double mCoordinate;
    std::size_t mRevision = 0;
};

} // namespace Lixel

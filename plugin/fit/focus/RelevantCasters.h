#pragma once

#include "fit/focus/FocusScratch.h"
#include "fit/focus/LightVolume.h"

#include <limits>

namespace Lixel {

/// Collects what casters cover of the visible receivers, whose hull is in the scratch memory, as
/// this one's is then.
class RelevantCasters {
public:
    /// @param lit what the light reaches; must outlive this
    /// @param lsReceiverFar distance of the farthest visible receiver along the light's axis
    RelevantCasters(const ShadowProblem& problem, const LightImage& image, const ConvexVolume& lit,
                    double lsReceiverFar, FocusScratch& scratch);

    void addAll(const BoxSet& casters);

    /// Distance along the light of the nearest that was added; infinite before.
    double lsNear() const { return mLsNear; }

private:
    /// The lanes of boxes that would neither widen the hull, once they are cut off where no
    /// receiver is, nor are nearer to the light.
    unsigned lanesWithin(const BoxSet::Block& block);
    /// Leaves the edges along the receivers' hull out: nothing that is kept reaches beyond them.
    void findInnerEdges();
    /// @param index of the body in the problem's set
    void add(const Box& box, std::size_t index);
    /// Of each caster only what covers visible receivers: one that touches them with a corner then
    /// joins the region with that corner, and not with all of itself.
    /// @return whether anything is left of the points
    bool clipToReceivers(const Box& box);

    const ShadowProblem& mProblem;
    const LightImage& mImage;
    const ConvexVolume& mLit;
    FocusScratch& mScratch;
    Gauge mLsDepth;
    double mLsReceiverFar;
    double mLsNear = std::numeric_limits<double>::infinity();
    /// The largest coordinate of the receivers' hull.
    double mCoordinate;
    std::size_t mRevision = 0;
};

} // namespace Lixel

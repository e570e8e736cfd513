#pragma once

#include "fit/focus/FocusScratch.h"
#include "fit/focus/LargeBodies.h"
#include "fit/focus/LightVolume.h"

#include <limits>

namespace Lixel {

/// Collects what is visible of receivers.
class VisibleReceivers {
public:
    /// @param lit what the light reaches
    /// @param[out] inView the receivers that may reach into what is in view and lit
    VisibleReceivers(const ShadowProblem& problem, const LightImage& image, const ConvexVolume& lit,
                     FocusScratch& scratch, BoxSet& inView);

    void addAll(const BoxSet& receivers);
    /// Adds what is visible of a box that is no body of the problem's.
    void addClipped(const Aabb& box);
    /// Call once all are added: adds what is left of sides that have just turned away from the
    /// light. They are drawn in towards what else is visible, so that it goes little by little.
    void addLeaving();

    /// Hull of what was added, in the light image.
    const ImageHull& hull() const { return mScratch.receivers; }
    /// The largest of the receivers in view, where their shapes are known.
    const LargeBodies& large() const { return mLarge; }
    /// What is in view and lit, and in the problem's part.
    const ConvexVolume& seen() const { return mSeen; }
    /// Least and greatest distance along the light's axis, and depth in front of the viewer.
    const Vec2& lsRange() const { return mLsRange; }
    const Vec2& vsRange() const { return mVsRange; }

private:
    static constexpr double Infinity = std::numeric_limits<double>::infinity();

    /// The lanes of boxes that lie as a whole, in view or not, within what was added already.
    unsigned lanesWithin(const BoxSet::Block& block) const;
    /// Adds what is visible of a body.
    /// @param index of it in the problem's set
    void add(const Aabb& box, std::size_t index);
    /// Adds what is visible of what may face the light of a large body.
    /// @return false where that is not known
    bool addLitSurface(const Aabb& box, std::size_t index);
    void addCorners(const Aabb& box);
    void addPoints();

    const ShadowProblem& mProblem;
    const LightImage& mImage;
    FocusScratch& mScratch;
    BoxSet& mInView;
    Gauge mLsDepth;
    Gauge mVsDepth;
    ConvexVolume mSeen;
    /// Of the receivers in view, where their shapes are known; of others what faces away from the
    /// light is a small part of what is visible.
    LargeBodies mLarge;
    Vec2 mLsRange = Vec2(Infinity, -Infinity);
    Vec2 mVsRange = Vec2(Infinity, -Infinity);
};

} // namespace Lixel

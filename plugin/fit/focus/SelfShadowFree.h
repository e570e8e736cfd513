#pragma once

#include "fit/focus/LargeBodies.h"
#include "fit/focus/LightImage.h"
#include "fit/geometry/BodyHull.h"

#include <array>
#include <span>

namespace Lixel {

/// A body that casts and receives, and shadows nothing of itself that faces the problem's light,
/// except behind slopes.
struct SelfShadowFreeBody {
    /// Its index among the problem's casters.
    std::size_t caster = 0;
    /// Of its own among receivers.
    const void* identity = nullptr;
    PlacedBox around;
};

/** The largest bodies of a problem that shadow nothing of themselves: convex ones; and reliefs,
    those of whose slopes that may face away from the light cast by themselves.

    A ground is before itself for the light, box by box, and would have all that is visible of it in
    the map. The few largest bodies are those that this matters for; smaller ones count as casting
    on themselves too, which makes the map hardly larger.
*/
class SelfShadowFreeBodies {
public:
    /// Finds those among the largest of both sets, subsets of the problem's. What is smaller than
    /// the largest receivers covers a small part of what is visible of itself.
    /// @param large the largest of the receivers
    void find(const ShadowProblem& problem, const LightImage& image, const BoxSet& casters,
              const BoxSet& receivers, const LargeBodies& large);

    void clear() {
        mCount = 0;
        mSlopes.clear();
    }
    std::span<const SelfShadowFreeBody> all() const { return {mBodies.data(), mCount}; }
    /// Boxes around what the bodies may shadow themselves with, in the problem's space.
    std::span<const Aabb> slopes() const { return mSlopes; }
    bool hasCaster(std::size_t index) const;

private:
    bool addSlopes(const SelfShadowFree& body, const LightImage& image);

    std::array<SelfShadowFreeBody, LargeBodies::Most> mBodies;
    std::size_t mCount = 0;
    std::vector<Aabb> mSlopes;
};

/// Half spaces that hold what the body may shadow: behind those faces of its box that the light
/// shines on.
/// @param extent of the problem's bodies, which rounding is relative to
/// @param[out] planes room for 3
/// @return how many there are
std::size_t behindLitFaces(const PlacedBox& around, const LightImage& image, double extent,
                           std::span<HalfSpace, 3> planes);

} // namespace Lixel

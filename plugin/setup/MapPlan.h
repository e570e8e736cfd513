#pragma once

#include "fit/geometry/Types.h"

#include <functional>
#include <string>
#include <string_view>

namespace Lixel {
/// @addtogroup LixelSetups
/// @{

/// What is done with a shadow map in one frame.
enum class MapPlan {
    Draw, ///< its casters are drawn
    /// Those that move are drawn, over a copy of what stands still; or all, where it turns out that
    /// the copy does not do.
    DrawMoving,
    Reuse, ///< its texture shows just that already, and is kept
    Skip,  ///< nothing in view is shadowed: its texture is empty
};

/// Why.
enum class PlanReason {
    NothingChanged,  ///< reused: casters, matrices and settings are those that it was drawn with
    Postponed,       ///< reused, though it ought to be drawn: for the budget @see MapBudget
    NothingShadowed, ///< skipped: the fit's reason says more
    Unknown,    ///< drawn: nobody knows what the texture shows; it is new, or others drew into it
    MapChanged, ///< drawn: the light, what is seen, or the texture is another
    SettingsChanged,   ///< drawn: caster material, masks or shadow settings are others
    CastersChanged,    ///< drawn: a caster moved, came, went or looks different
    RestlessCaster,    ///< drawn: a caster may look different each time @see MapDecision::name
    OwnCasterMaterial, ///< drawn: so may all, in a caster material that is not Lixel's
    Listener,          ///< drawn: an application's render queue listener may change what is drawn
    NotPlanned,        ///< drawn: the setup is not one of Lixel's
    Forbidden,         ///< drawn: the setup's option `reuse_maps` is off
};

struct MapDecision {
    MapPlan plan = MapPlan::Draw;
    PlanReason reason = PlanReason::Unknown;
    /// Of the restless caster.
    std::string name;
};

LIXEL_API std::string_view toString(MapPlan plan);
LIXEL_API std::string_view toString(PlanReason reason);

/** Has all shadow maps drawn anew in the next frame.

    Maps are kept where nothing that they show has changed, and what Lixel cannot see for itself is
    taken for a change. Call this after changes that it has no way to learn of: static vertex
    buffers written to, or a listener that moved something only while maps are drawn.
*/
LIXEL_API void redrawShadowMaps();

/** Proof mode: maps that would be reused or skipped are drawn nevertheless, and compared with what
    their textures held, bit for bit. Maps whose casters LixelSceneManager draws in batches, or in
    two layers (what stands still, and what moves), are drawn once more, at once and with each
    caster by itself, and compared. Each difference is a line in the log. It is slow; off at first.
    Decisions are published as they are without it.
    @param wait called before a texture is read, where the driver does not wait by itself until what
    was drawn is there: `glFinish`, with Mesa's software renderers
*/
LIXEL_API void setProofMode(bool on, const std::function<void()>& wait = {});
LIXEL_API bool isProofMode();

/// Since proof mode was set.
struct ProofCount {
    /// Reused or skipped, and drawn nevertheless.
    std::size_t maps = 0;
    /// Drawn in batches, and drawn again without.
    std::size_t batched = 0;
    /// Drawn in layers, and drawn again at once.
    std::size_t layered = 0;
    /// With a texel that differs.
    std::size_t different = 0;
};
LIXEL_API ProofCount proofCount();

/// @}
} // namespace Lixel

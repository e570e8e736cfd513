#pragma once

#include "fit/core/FitState.h"

#include <concepts>
#include <memory>
#include <optional>

/** The one fit that every technique shares.

    A technique is a rule that picks the warp; focusing, the warp's safety, the affine fit, the
    depth row and the matrices are here.

    Every fit and every division into parts is noexcept, for bad input gives a reason. Vectors of
    its state and its problem grow to the scene's size nevertheless: where memory for that is
    refused, the program ends (std::terminate).
*/
namespace Lixel {

/// What a rule may look at to pick its warp.
struct WarpContext {
    const ShadowProblem& problem;
    const LightImage& image;
    const FocusRegion& region;
    FitState& state;
    /// ℓ of the viewer's position; its third component is <= 0 where the viewer is behind a local
    /// light.
    Vec3 viewer;
    /// ℓ of the unit view direction.
    Vec3 viewDirection;
    /// Whether the viewer's projection is a perspective one; an orthographic one sees everything
    /// at one size.
    bool perspective;
};

/// A rule's choice: the warp about region.liCentre, and what kept it from its ideal.
struct WarpChoice {
    Vec2 liWarp = Vec2::Zero();
    FitReason reason = FitReason::None;
    /// Rows x, y and w of the whole map, acting on ℓ, of positive determinant: instead of a warp,
    /// by a rule that wants the map to be this and no other. It is neither made safe nor fitted;
    /// the focus region is cut to what it serves, and where nothing is left the map is uniform.
    std::optional<Mat3> homography = std::nullopt;
};

/// A technique's rule, as a reference to a function object that outlives the call it is passed to.
class WarpRule {
public:
    template <std::invocable<const WarpContext&> Function>
    WarpRule(const Function& function) // NOLINT: converts, so that a lambda can be passed
        : mFunction(std::addressof(function)), mCall([](const void* object, const WarpContext& c) {
              return WarpChoice((*static_cast<const Function*>(object))(c));
          }) {}
    WarpChoice operator()(const WarpContext& context) const { return mCall(mFunction, context); }

private:
    const void* mFunction;
    WarpChoice (*mCall)(const void*, const WarpContext&);
};

/// What a fit depends on and cannot use.
enum class InvalidInput {
    None,
    Bodies, ///< there are no sets of casters and receivers
    Map,    ///< it has no room for anything beside its border
    ShadowDistance,
    LightDirection,
    LightPosition,
    NearDistance,
    Range,
    Angle,
    CasterBox,
    ReceiverBox,
    View ///< matrices that are not finite, not rigid, or without an inverse
};

/// The first that is found; None where every number that a fit depends on is usable.
InvalidInput invalidInputOf(const ShadowProblem& problem);

inline bool isValid(const ShadowProblem& problem) {
    return invalidInputOf(problem) == InvalidInput::None;
}

/// Runs the shared fit around a rule. Never throws; bad input gives a fit without a map.
ShadowFit fitWithRule(const ShadowProblem& problem, FitState& state, const WarpRule& rule) noexcept;

} // namespace Lixel

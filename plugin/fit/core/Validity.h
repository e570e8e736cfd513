#pragma once

#include "fit/problem/ShadowProblem.h"

namespace Lixel {

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

} // namespace Lixel

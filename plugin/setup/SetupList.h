#pragma once

#include "fit/problem/Option.h"
#include "setup/FittedShadowCameraSetup.h"

#include <memory>
#include <span>
#include <string_view>

/// All kinds of setups by name, for programs that have a user choose one.
namespace Lixel {
/// @addtogroup LixelSetups
/// @{

struct SetupKind {
    std::string_view name;  ///< such as "XPSM"
    std::string_view title; ///< one line for people
    std::string_view paper; ///< author and year
    /// Its own; CommonOptions::declared() has what all setups share.
    std::span<const Option> options;
    std::shared_ptr<FittedShadowCameraSetup> (*create)();
};

/// Techniques that make one map, then setups that make several.
LIXEL_API std::span<const SetupKind> setupKinds();

/// The kind of that name; null where there is none.
LIXEL_API const SetupKind* findSetupKind(std::string_view name);

/// @}
} // namespace Lixel

#pragma once

#include "cg/translation/Request.h"

#include <optional>
#include <string_view>

namespace Lixel::Cg {

/// What a profile of Cg's, or a target of Direct3D's, asks for. All are translated alike.
struct Profile {
    Stage stage = Stage::Vertex;
    bool clampColours = false; ///< as Request::clampColours
    std::string_view name;
};

/// The profile of that name, such as arbvp1 or ps_2_0. Nothing if it is none that can be
/// translated.
std::optional<Profile> profileOf(std::string_view name);

} // namespace Lixel::Cg

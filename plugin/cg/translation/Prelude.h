#pragma once

#include "cg/translation/Request.h"

#include <string>
#include <string_view>
#include <unordered_set>

namespace Lixel::Cg {

/// What messages call the prelude.
inline constexpr const char* PreludeName = "prelude of Lixel";

/// Functions of Cg's and HLSL's libraries that the front end lacks: those of which the source has
/// the names and does not define them itself.
std::string preludeFor(const Request& request, const std::unordered_set<std::string_view>& words,
                       const std::unordered_set<std::string_view>& defined);

/// Why a call of that function, named as the front end does ("tex2D(s21;vf3;"), is refused; null
/// where it is not.
const char* whyRefused(std::string_view function);

} // namespace Lixel::Cg

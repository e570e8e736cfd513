#pragma once

#include "cg/translation/Request.h"

#include <string>
#include <string_view>
#include <unordered_set>

namespace Lixel::Cg {

/// What messages call the prelude.
inline constexpr const char* PreludeName = "prelude of Lixel";

/// Whether that is a function of Cg's library that the front end lacks, or reads in another way. A
/// source's calls of it are to be named preludeNameOf(name).
bool isInPrelude(Language language, std::string_view name);

std::string preludeNameOf(std::string_view name);

/// Names, for preludeFor, of functions that do what ++ and -- after a variable do.
inline constexpr std::string_view PostIncrement = "++";
inline constexpr std::string_view PostDecrement = "--";

/// HLSL that defines these functions, to go before a source.
std::string preludeFor(Stage stage, const std::unordered_set<std::string_view>& names);

/// Why a call of that function, named as the front end does ("lixel_cg_tex2D(s21;vf3;"), is
/// refused; null where it is not.
const char* whyRefused(std::string_view function);

} // namespace Lixel::Cg

#pragma once

#include "cg/translation/Tokens.h"

#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace Lixel::Cg {

/// Constants by name, whose values other constants may use.
using Constants = std::unordered_map<std::string_view, std::vector<double>>;

/// The numbers of an initial value such as 0.5, float3(1, 2, 0.5 * 6) or { 1, 2 }, in their order.
/// Nothing if it is made of something else than numbers, arithmetic, constructors and constants.
std::optional<std::vector<double>> valueOf(const Tokens& tokens, TokenRange range,
                                           const Constants& constants);

} // namespace Lixel::Cg

#pragma once

#include "cg/translation/Outline.h"

#include <optional>
#include <unordered_set>
#include <vector>

namespace Lixel::Cg {

/// The first word in these functions' bodies that nothing in the source can have declared, as the
/// index of its token. The front end finds these too, but does not survive some. Names that are
/// declared somewhere else in the source count as declared.
std::optional<std::size_t> unknownName(const Tokens& tokens, const Outline& outline,
                                       const std::vector<const FunctionOutline*>& functions);

} // namespace Lixel::Cg

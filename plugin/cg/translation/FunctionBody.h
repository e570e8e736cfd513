#pragma once

#include "cg/translation/Edits.h"
#include "cg/translation/Outline.h"

#include <string_view>
#include <unordered_set>
#include <vector>

namespace Lixel::Cg {

/// Names of functions that a function's body defines, as the indices of their tokens. The front end
/// does not survive them.
std::vector<std::size_t> functionsWithin(const Tokens& tokens, const FunctionOutline& function);

/// Puts ++ and -- that stand after their operand before it, or makes them calls of the prelude's
/// functions where their value is used: after what cannot be counted with, the front end does not
/// survive them; before it, it does.
/// @param[in,out] fromPrelude functions that the prelude has to have
void rewriteCounting(const Tokens& tokens, const FunctionOutline& function, Edits& edits,
                     std::unordered_set<std::string_view>& fromPrelude);

} // namespace Lixel::Cg

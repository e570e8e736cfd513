#pragma once

#include "cg/translation/Message.h"
#include "cg/translation/Tokens.h"

namespace Lixel::Cg {

/// Adds an error where a source is nested so deeply that a compiler that follows its nesting by
/// recursion could run out of its stack.
void checkComplexity(const Tokens& tokens, Messages& messages);

} // namespace Lixel::Cg

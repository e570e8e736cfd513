#pragma once

#include "cg/translation/Message.h"

namespace glslang {
class TIntermediate;
}

namespace Lixel::Cg {

/// Adds an error for each call of a function of the prelude that exists only to be refused: what
/// the front end would take for another function.
void checkCalls(const glslang::TIntermediate& program, Messages& messages);

} // namespace Lixel::Cg

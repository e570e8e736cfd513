#pragma once

#include "fit/core/WarpContext.h"

namespace Lixel {

/// The uniform map that does not depend on where bodies are, given whole. @see UniformOptions
WarpChoice stableMap(const WarpContext& context, RuleState state);

} // namespace Lixel

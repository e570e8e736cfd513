#pragma once

#include "fit/core/Fit.h"

namespace Lixel {

/// The uniform map that does not depend on where bodies are, given whole. @see fitUniform
WarpChoice stableMap(const WarpContext& context);

} // namespace Lixel

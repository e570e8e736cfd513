#pragma once

#include "fit/problem/ShadowProblem.h"

#include <string>

namespace Lixel {

/// Which of a problem's inputs no map can be made of, and where it comes from in OGRE, for the log.
/// Empty where each is valid.
std::string describeInvalidInput(const ShadowProblem& problem);

} // namespace Lixel

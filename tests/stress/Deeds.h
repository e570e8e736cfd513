#pragma once

#include "Application.h"

#include "Random.h"

#include <string>

namespace Lixel::Tests {

/// Does one thing at random that an application may do, and says what it was.
std::string doSomething(Application& application, Random& random);

} // namespace Lixel::Tests

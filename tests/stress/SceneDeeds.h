#pragma once

#include "Deed.h"

namespace Lixel::Tests {

const std::vector<Deed>& sceneDeeds();

} // namespace Lixel::Tests

#pragma once

#include "Deed.h"

namespace Lixel::Tests {

const std::vector<Deed>& lightDeeds();

} // namespace Lixel::Tests

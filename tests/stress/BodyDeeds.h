#pragma once

#include "Deed.h"

namespace Lixel::Tests {

const std::vector<Deed>& bodyDeeds();

} // namespace Lixel::Tests

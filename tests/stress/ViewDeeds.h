#pragma once

#include "Deed.h"

namespace Lixel::Tests {

const std::vector<Deed>& viewDeeds();

} // namespace Lixel::Tests

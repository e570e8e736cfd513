#pragma once

#include "common/Setups.h"

#include <string>

namespace Lixel::Samples {

/** A row of a table: the name of an emulated setup, and KEYWORD=VALUE for each of its options that
    is to have another value than its default, with spaces between.

    Options of Cascades-N that are not those of cascades are those of Optimal, in each slice.
    @exception std::invalid_argument that says what is wrong */
NamedSetup rowOf(const std::string& text);

} // namespace Lixel::Samples

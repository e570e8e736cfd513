#pragma once

#include "report/Table.h"

namespace Lixel::Samples {

/** Prints in which cases Optimal and XPSM lose most against the best of Uniform and OGRE's setups
    of one map, with a command that draws each.

    @param options whose setups the cases have: all of emulatedSetups()
*/
void printWorstCases(const TableOptions& options, const std::vector<TableCase>& cases);

} // namespace Lixel::Samples

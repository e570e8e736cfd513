#pragma once

#include "report/CasePictures.h"

namespace Lixel::Samples {

/** Prints in which cases Optimal and XPSM lose most against the best of Uniform and OGRE's setups
    of one map, with a command that draws each.

    @param options whose setups the cases have: all of emulatedSetups()
    @param pictures if not null, draws each case under both setups; their errors are printed too
*/
void printWorstCases(const TableOptions& options, const std::vector<TableCase>& cases,
                     CasePictures* pictures);

} // namespace Lixel::Samples

#pragma once

#include "report/Table.h"

namespace Lixel::Samples {

/** What Lixel claims, by kind of scene: Optimal beside OGRE's LiSPSM, beside the best of Lixel's
    techniques in each case, cascades beside OGRE's splits, as paired geometric means with their
    95 % interval; then how many cases are worse.

    Left out of a ratio are cases in which both err less than LeastBaseline: they say nothing.
    @param options whose setups the cases have: all of emulatedSetups()
*/
void printClaims(const TableOptions& options, const std::vector<TableCase>& cases);

} // namespace Lixel::Samples

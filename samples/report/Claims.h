#pragma once

#include "report/Table.h"

namespace Lixel::Samples {

/// Percent and percentage points by which an error has to be larger to count as worse. Less may be
/// due to how texels happen to lie on edges.
constexpr double WorseByPart = 0.05;
constexpr double WorseByPoints = 0.01;

/// Whether the first error is worse than the second beyond both.
bool isWorse(const ClassificationError& error, const ClassificationError& than);

/// Of some setups the one that errs least in a case; the first where several do.
std::size_t bestOf(const TableCase& one, const std::vector<std::size_t>& setups);

/** What Lixel claims, by kind of scene: Optimal beside OGRE's LiSPSM, beside the best of Lixel's
    techniques in each case, cascades beside OGRE's splits, as paired geometric means with their
    95 % interval; then how many cases are worse, and the worst, with a command that draws each.

    Left out of a ratio are cases in which both err less than LeastBaseline: they say nothing.
    @param options whose setups the cases have: all of emulatedSetups()
*/
void printClaims(const TableOptions& options, const std::vector<TableCase>& cases);

} // namespace Lixel::Samples

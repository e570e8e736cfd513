#pragma once

#include "report/Table.h"

namespace Lixel::Samples {

/** Prints each setup's errors in those cases of a table that were drawn, drawn and emulated.

    Nothing where no case was drawn: TableOptions::drawn.
*/
void printDrawn(const TableOptions& options, const std::vector<TableCase>& cases);

/** Prints, over the same cases, the ratios of printClaims and how many cases are worse, both ways.
    @param options whose setups the cases have: all of emulatedSetups()
*/
void printDrawnClaims(const TableOptions& options, const std::vector<TableCase>& cases);

/// Prints, over the same cases, the ratios of all setups to the first, both ways.
void printDrawnRatios(const TableOptions& options, const std::vector<TableCase>& cases);

} // namespace Lixel::Samples

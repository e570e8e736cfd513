#pragma once

#include "report/Table.h"

namespace Lixel::Samples {

/** Prints what Optimal makes of its time: for several numbers of samples and evaluations the error
    relative to the default's, as a paired geometric mean over all cases, beside the median time of
    the fit alone.

    Each is measured cold, with nothing known of a frame before, and as the last of some frames
    through which the viewer turns towards where it looks.
    @exception std::exception where a scene cannot be shown
*/
void printBudgets(TableOptions options);

} // namespace Lixel::Samples

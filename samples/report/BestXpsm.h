#pragma once

#include "report/Table.h"

namespace Lixel::Samples {

/** Prints how wrong Optimal, which has no constants, is beside XPSM with constants that were chosen
    for each scene knowing its true errors.

    XPSM runs with all of a grid of constants, guarded and literal, over all lights and views. Of
    each scene the constants with the least geometric mean of errors are chosen; ratios are then
    paired and averaged as in printTable, without the cases in which Uniform errs less than
    LeastBaseline.
    @param options its setups are not used
    @exception std::exception where a scene cannot be shown
*/
void printBestXpsm(TableOptions options);

} // namespace Lixel::Samples

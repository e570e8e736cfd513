#pragma once

#include "report/Table.h"

namespace Lixel::Samples {

/** Prints what the option `feedback` gives a walking viewer, and one whose camera cuts: errors of
    setups that judge maps by view rays, by feedback, and by the points that are really seen, how
    many visible points in shadow are outside of their map, and what feedback costs.

    All frames are drawn, since depths are read back of them; errors are emulated.
    @param frames of each walk, and of what follows the cut to the scene's next view
    @exception std::exception where a scene cannot be shown
*/
void printFeedback(const TableOptions& options, int frames);

} // namespace Lixel::Samples

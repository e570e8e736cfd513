#pragma once

#include "fit/geometry/Types.h"

#include <cstddef>

namespace Lixel {
/// @addtogroup LixelSetups
/// @{

/** What a frame may spend on drawing shadow maps, of all lights and scene managers together.

    A map that ought to be drawn and is not granted it is kept as it is, and read as it was drawn:
    what moved since then has its shadow where it was, and what came into view since then may have
    none yet. Maps that were fitted with a margin (CommonOptions::lastingMaps) have that, too.

    The nearest and the most wrong come first: a map is the more urgent the more there is wrong with
    it, the longer it has been kept, and the nearer the viewer is to what it serves. So near
    cascades are drawn in most frames and far ones in every few. Maps with nothing to keep (a new
    light, a new texture, other settings) are drawn in any case, and count. Where nobody knows what
    a map shows (with an application's render queue listener or caster material, or several maps
    drawn at once) it is drawn and does not count.

    Where a program draws the same map twice in a frame, each time is a frame of its own here.
*/
struct MapBudget {
    /// How many maps are drawn in a frame; 0: no limit.
    std::size_t maps = 0;
    /// How long that may take, in milliseconds of the thread that draws, by what each map took last
    /// time. One is always granted. 0: no limit.
    double milliseconds = 0.0;
    /// In how many frames after the one that it was drawn in a map may be kept although it ought to
    /// be drawn. Then it is drawn whatever the budget.
    unsigned oldest = 16;

    bool isLimited() const { return maps > 0 || milliseconds > 0.0; }
};

/// No limit at first. Setups with `reuse_maps` off draw all of their maps whatever the budget.
/// @throws Ogre::InvalidParametersException unless milliseconds are finite and >= 0.
LIXEL_API void setMapBudget(const MapBudget& budget);
LIXEL_API const MapBudget& mapBudget();

/// @}
} // namespace Lixel

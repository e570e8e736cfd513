#include "setup/MapBudget.h"

#include <OgreException.h>

#include <cmath>

namespace Lixel {
namespace {

MapBudget currentBudget;

} // namespace

void setMapBudget(const MapBudget& budget) {
    if (!std::isfinite(budget.milliseconds) || budget.milliseconds < 0.0)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "budget.milliseconds must be finite and not negative", "Lixel::setMapBudget");
    currentBudget = budget;
}

const MapBudget& mapBudget() {
    return currentBudget;
}

} // namespace Lixel

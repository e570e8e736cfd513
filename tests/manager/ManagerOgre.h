#pragma once

#include "HeadlessOgre.h"

namespace Lixel::Tests {

/** OGRE, once in the process: headless, with its own scene managers, Lixel's plugin and the
    reference managers of these tests, and without chance: what OGRE draws by lot (particles) is
    always the same. */
HeadlessOgre& ogreWithManagers();

} // namespace Lixel::Tests

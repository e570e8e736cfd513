#pragma once

#include "setup/MapContent.h"
#include "setup/MapPlan.h"

#include <functional>

namespace Lixel {

class CasterFingerprint;
struct ShadowTarget;

/// What to do with a map, and what its texture shows if it is drawn.
struct PlannedMap {
    MapDecision decision;
    std::optional<MapContent> content;
};

/** Decides whether a map that has something to show is drawn or reused.

    Reading all casters costs time, and is of use only where the map itself has stood still. So a
    map is drawn once more after it came to rest, with its casters read then; one that is made to
    last, or whose casters are known, has them read at once.

    @param shadowCamera placed by `fit`
    @param view the viewport that the viewer's picture is drawn in
    @param readsAtOnce whether casters are read although the map is drawn
    @param readCasters called where it matters
*/
PlannedMap planMap(const Ogre::Camera& shadowCamera, const Ogre::Viewport& view,
                   const ShadowFit& fit, const ShadowTarget& target, bool readsAtOnce,
                   const std::function<const CasterFingerprint&()>& readCasters);

} // namespace Lixel

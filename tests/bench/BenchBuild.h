#pragma once

#include "HeadlessOgre.h"

#include <string>
#include <vector>

namespace Lixel::Tests {

/// What it takes to fill a scene and to empty it again.
struct BuildRow {
    std::string manager;
    std::size_t objects = 0;
    double build = 0;      ///< milliseconds for all nodes and entities
    double firstFrame = 0; ///< milliseconds
    double move = 0;       ///< nanoseconds an entity to move all of them and to update the scene
    double clear = 0;      ///< milliseconds of clearScene
    double bytes = 0;      ///< of memory an entity, its node among it, after the first frame
};

/// Medians of a few repetitions, in turns.
std::vector<BuildRow> measureBuilds(HeadlessOgre& ogre, std::size_t objects,
                                    const std::vector<std::string>& managers);

} // namespace Lixel::Tests

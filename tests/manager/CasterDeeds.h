#pragma once

#include "../stress/Random.h"
#include "BatchScene.h"

#include <span>
#include <vector>

namespace Lixel::Tests {

/// A scene whose casters are changed.
struct ChangedScene {
    BatchScene& batches;
    std::vector<Ogre::Entity*> casters;
    std::size_t made = 0;
};

/// Something that an application may do to a caster, or to what all share.
struct CasterDeed {
    const char* name;
    void (*perform)(ChangedScene& scene, Ogre::Entity& caster, Random& random);
};

std::span<const CasterDeed> casterDeeds();

/// Adds a caster whose mesh can be reloaded.
void addPanel(ChangedScene& scene, const Ogre::Vector3& position);

} // namespace Lixel::Tests

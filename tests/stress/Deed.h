#pragma once

#include "Application.h"

#include "Random.h"

#include <functional>
#include <string>
#include <vector>

namespace Lixel::Tests {

/// One thing that an application may do.
struct Deed {
    const char* name;
    /// How often, relative to the others.
    std::size_t weight;
    /// In a world picked at random; says what was done, empty for nothing.
    std::function<std::string(Application&, World&, Random&)> perform;
};

/// One of them; null where there is none.
template <typename T>
T* anyOf(std::vector<T>& all, Random& random) {
    return all.empty() ? nullptr : &all[random.below(all.size())];
}

/// One of the world's bodies but the ground; null where there is none.
inline Ogre::Entity* anyBody(World& world, Random& random) {
    return world.bodies.size() < 2 ? nullptr
                                   : world.bodies[1 + random.below(world.bodies.size() - 1)];
}

inline Ogre::Vector3 anyPlace(Random& random, float reach, float low, float high) {
    const float x = random.between(-reach, reach);
    const float y = random.between(low, high);
    return {x, y, random.between(-reach, reach)};
}

inline Ogre::Quaternion anyTurn(Random& random) {
    const Ogre::Vector3 axis = anyPlace(random, 1, 0.1F, 1).normalisedCopy();
    return {Ogre::Degree(random.between(0, 360)), axis};
}

inline std::string text(const Ogre::Vector3& v) {
    return Ogre::StringConverter::toString(v);
}

} // namespace Lixel::Tests

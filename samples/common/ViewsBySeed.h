#pragma once

#include "common/Random.h"
#include "common/Scenes.h"
#include "common/Terrain.h"

namespace Lixel::Samples {

/// Where viewers stand and what they look at.
struct ViewRange {
    std::string name;             ///< numbers from 1 are added
    Ogre::AxisAlignedBox eyes;    ///< y above ground
    Ogre::AxisAlignedBox targets; ///< y above ground
    float leastDistance = 1.0F;   ///< between both
    float fovYLow = 45.0F;        ///< degrees
    float fovYHigh = 65.0F;       ///< degrees
    float nearDistance = 0.2F;
    float farDistance = 500.0F;
};

/// Uniform in a box.
Ogre::Vector3 pointIn(const Ogre::AxisAlignedBox& box, Random& random);

/// Adds so many views, wherever the random numbers put them. Without ground, y = 0 is the ground.
void addViews(std::vector<SampleView>& views, const ViewRange& range, int count, Random& random,
              const HeightFunction& ground = {});

/// Four suns somewhere: "high" and "low", then "from-behind" and "against" each view.
std::vector<SampleLight> sunsBySeed(Random& random);

} // namespace Lixel::Samples

#pragma once

#include <Lixel/setup/FittedShadowCameraSetup.h>

#include <functional>
#include <string>
#include <vector>

namespace Lixel::Samples {

/// A way to set up shadow cameras that a user can pick by name.
struct NamedSetup {
    std::string name;
    std::string title; ///< one line for people
    std::function<Ogre::ShadowCameraSetupPtr()> create;
};

/** Lixel's setups, then OGRE's own, which are observed so that they draw with the same materials.

    Ogre-PSSM has one split: with additive shadows OGRE draws one map a light. PlaneOptimal and
    Ogre-PlaneOptimal are given the ground, the plane y = 0.
*/
const std::vector<NamedSetup>& shadowSetups();

/// The setup of that name; null when there is none.
const NamedSetup* findShadowSetup(const std::string& name);

} // namespace Lixel::Samples

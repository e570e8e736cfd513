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
    /// Maps of one light.
    std::size_t maps = 1;
    /// The maps + 1 split depths, in world units, from the viewer and how far shadows reach; for
    /// setups that do not say themselves which view depths each map serves.
    std::function<std::vector<double>(const Ogre::Camera& viewer, double shadowDistance)>
        splitDepths = {};
};

/** Lixel's setups, then OGRE's own, which are observed so that they draw with the same materials.

    All have one map. Ogre-PSSM has one split: with additive shadows OGRE draws one map a light.
    Ogre-LiSPSM-Optimal derives its parameter from the scene's depths (Wimmer et al. 2004) instead
    of the viewer's planes. PlaneOptimal and Ogre-PlaneOptimal are given the ground, the plane
    y = 0.
*/
const std::vector<NamedSetup>& shadowSetups();

/** All that can be measured by emulation: shadowSetups(), then those with several maps.

    Ogre-LiSPSM-1 has adjust factor 1 instead of OGRE's 0.1. Ogre-PSSM-3 splits and weighs as OGRE's
    own sample does: three splits between near plane and shadow distance, padded by the near
    distance, with adjust factors 2, 1 and 0.5.
*/
const std::vector<NamedSetup>& emulatedSetups();

/// The setup of that name among shadowSetups(); null when there is none.
const NamedSetup* findShadowSetup(const std::string& name);
/// The same among emulatedSetups().
const NamedSetup* findEmulatedSetup(const std::string& name);

/** One of Lixel's setups with options set, as text: KEYWORD=VALUE each.

    Its `create` throws std::invalid_argument or Ogre::InvalidParametersException, which say what
    is wrong. */
NamedSetup withOptions(const NamedSetup& setup, const std::vector<std::string>& assignments);
/// What is wrong with such assignments, and the options that there are; empty where all are right.
std::string wrongAssignment(const NamedSetup& setup, const std::vector<std::string>& assignments);

} // namespace Lixel::Samples

#pragma once

#include "HardScene.h"

#include <functional>
#include <string>
#include <vector>

namespace Lixel::Tests {

/// A configuration on which shadow maps break.
struct HardCase {
    std::string name;
    std::function<void(HardScene&)> build;
    /// Frames drawn before the one that is judged: 3 settle setups that look at the frame before.
    int settle = 3;
    /// Called before each frame but the judged one, if set, with its number from 0.
    std::function<void(HardScene&, int frame)> eachFrame = {};
    /// What happens right before the judged frame, if anything.
    std::function<void(HardScene&)> change = {};
    /** For bad input: makes it good again. The frame with the bad input must then only be survived,
        and the first one after the repair is judged. */
    std::function<void(HardScene&)> repair = {};
    /// Whether nothing that the viewer sees is in shadow: what counts is that it is survived.
    bool nothingShadowed = false;
    /// Maps that the light needs; OGRE's setups have one use for one.
    std::size_t maps = 1;
    /// Why Lixel's own setups are known to fail; empty where they must not.
    std::string known = {};
};

/// How the viewer looks, and at how much.
std::vector<HardCase> viewCases();
/// Suns and lamps.
std::vector<HardCase> lightCases();
/// What stands where, and on how many texels.
std::vector<HardCase> bodyCases();
/// All of them; names are unique.
const std::vector<HardCase>& hardCases();

} // namespace Lixel::Tests

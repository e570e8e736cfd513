#pragma once

#include "TestStage.h"

#include <string>
#include <vector>

namespace Lixel::Tests {

inline constexpr auto AdditiveTechnique = Ogre::SHADOWTYPE_TEXTURE_ADDITIVE;
inline constexpr auto IntegratedTechnique = Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED;

/** BoxOnGround under three lights that shadow different sides: two suns and a spot, XPSM each.

    The scripts of tests/material/media are loaded, in the group General as an application's are.
*/
class MaterialScene : public BoxOnGround {
public:
    /// @param receiver the scene manager's; none for techniques that take none
    MaterialScene(Ogre::ShadowTechnique technique, const std::string& receiver);

    std::vector<Ogre::Light*> lights;

    /// Gives ground and box a material.
    void wear(const std::string& material);
    /// The next frame's red channel, row by row from the top.
    std::vector<int> draw();
    /// Writes the last frame where the environment's LIXEL_PICTURES names a folder, to be looked
    /// at.
    void keepPicture(const std::string& name);
};

/// The share of pixels, in percent, in which two pictures differ by more than `tolerance` of 255.
double differing(const std::vector<int>& a, const std::vector<int>& b, int tolerance = 3);

} // namespace Lixel::Tests

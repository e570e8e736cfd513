#pragma once

#include <string>
#include <vector>

namespace Ogre {
class Pass;
} // namespace Ogre

namespace Lixel {

/** Which samplers of a pass read another texture unit than they mean, as lines for the log.

    Samplers are recognised by name: `diffuseMap` means the unit DiffuseMap, `shadowMap` the unit
    ShadowMap. Under an integrated technique `shadowMap`, `shadowMap0` and so on mean the units of
    content_type shadow, in their order: there have to be as many of these as maps are read. Three
    more mistakes with DiffuseMap are found: its texture is in a unit without a name, or has one
    texel, or another pass of the technique cuts holes that this one fills.
*/
std::vector<std::string> findWrongUnits(const Ogre::Pass& pass, bool integrated);

} // namespace Lixel

#pragma once

#include <OgrePass.h>
#include <OgreTextureUnitState.h>

#include <algorithm>

namespace Lixel {

/// Whether a pass has texture units that OGRE puts shadow maps into.
inline bool hasShadowUnits(const Ogre::Pass& pass) {
    return std::ranges::any_of(pass.getTextureUnitStates(), [](const Ogre::TextureUnitState* unit) {
        return unit->getContentType() == Ogre::TextureUnitState::CONTENT_SHADOW;
    });
}

} // namespace Lixel

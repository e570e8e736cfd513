#pragma once

#include <Ogre.h>

namespace Lixel::Samples {

/// The pass that is drawn into shadow maps, and that decides which sides are drawn and where there
/// are holes; null for a material without any.
inline const Ogre::Pass* firstPass(const Ogre::Material& material) {
    const auto& supported = material.getSupportedTechniques();
    const auto& all = material.getTechniques();
    const Ogre::Technique* technique =
        !supported.empty() ? supported.front() : (all.empty() ? nullptr : all.front());
    return technique && technique->getNumPasses() > 0 ? technique->getPass(0) : nullptr;
}

} // namespace Lixel::Samples

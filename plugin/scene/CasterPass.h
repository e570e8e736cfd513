#pragma once

#include "scene/OgreVersions.h"

#include <OgrePass.h>

#include <string>

/// What passes and programs mean for shadow casters.
namespace Lixel {

/// Whether OGRE has a pass's texture cut holes into the pass's shadow.
inline bool cutsHoles(const Ogre::Pass& pass) {
    return pass.getAlphaRejectFunction() != Ogre::CMPF_ALWAYS_PASS ||
           (pass.getSourceBlendFactor() == Ogre::SBF_SOURCE_ALPHA &&
            pass.getDestBlendFactor() == Ogre::SBF_ONE_MINUS_SOURCE_ALPHA);
}

/// Whether shadow casters drawn for this pass are whole bodies in OGRE's caster material.
inline bool drawsWhole(const Ogre::Pass& pass) {
    return !cutsHoles(pass) && !hasOwnCasterPrograms(pass);
}

/// Whether a GPU program is one of Lixel's materials, by its name: it does nothing to vertices
/// except transform them.
inline bool isOwnProgram(const std::string& name) {
    return name.starts_with("Lixel/");
}

} // namespace Lixel

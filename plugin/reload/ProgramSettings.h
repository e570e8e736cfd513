#pragma once

#include <OgreCommon.h>
#include <OgreGpuProgram.h>

namespace Lixel {

/// What scripts set of a program with keywords of its language, such as preprocessor_defines.
Ogre::NameValuePairList settingsOf(const Ogre::GpuProgram& program);

/// Sets only those whose values differ: OGRE warns about some whenever they are set.
void setSettings(Ogre::GpuProgram& program, const Ogre::NameValuePairList& settings);

/// Loads a program; it stays unloaded where a file is missing, which the log has.
void loadIfPossible(Ogre::GpuProgram& program);

} // namespace Lixel

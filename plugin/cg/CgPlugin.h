#pragma once

#include "cg/LanguageChoice.h"
#include "cg/ProgramFactory.h"

#include <OgrePlugin.h>

#include <vector>

namespace Lixel::Cg {

/// Cg and HLSL for OGRE's OpenGL render systems, as OGRE's plugin. A language that OGRE knows
/// already, from Direct3D or from NVIDIA's Cg, is left to what it knows it from.
class CgPlugin : public Ogre::Plugin {
public:
    CgPlugin();

    const Ogre::String& getName() const override;
    void install() override {}
    void initialise() override;
    void shutdown() override;
    void uninstall() override {}

private:
    ProgramFactory mCg;
    ProgramFactory mHlsl;
    LanguageChoice mLanguageChoice;
    std::vector<ProgramFactory*> mAdded;
};

} // namespace Lixel::Cg

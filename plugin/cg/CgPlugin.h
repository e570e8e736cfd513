#pragma once

#include "cg/LanguageChoice.h"
#include "cg/ProgramFactory.h"

#include <OgrePlugin.h>
#include <OgreStringInterface.h>

#include <vector>

namespace Lixel::Cg {

/// Cg and HLSL for OGRE's OpenGL render systems, as OGRE's plugin. A language that OGRE knows
/// already, from Direct3D or from NVIDIA's Cg, is left to what it knows it from.
///
/// Has the parameter cache_folder: where translations are kept on disk, for the next start. It is
/// empty at first, and they are kept in memory alone. An application sets it through the interface
/// that its plugin has among Root::getInstalledPlugins.
class CgPlugin : public Ogre::Plugin, public Ogre::StringInterface {
public:
    CgPlugin();
    TranslationCache& cache() { return *mCache; }
    const TranslationCache& cache() const { return *mCache; }

    const Ogre::String& getName() const override;
    void install() override {}
    void initialise() override;
    void shutdown() override;
    void uninstall() override {}

private:
    const std::shared_ptr<TranslationCache> mCache;
    ProgramFactory mCg;
    ProgramFactory mHlsl;
    LanguageChoice mLanguageChoice;
    std::vector<ProgramFactory*> mAdded;
};

} // namespace Lixel::Cg

#pragma once

#include "cg/translation/Request.h"

#include <OgreHighLevelGpuProgramManager.h>

namespace Lixel::Cg {

/// Makes programs of one language for OGRE's scripts.
class ProgramFactory : public Ogre::HighLevelGpuProgramFactory {
public:
    explicit ProgramFactory(Language language) : mLanguage(language) {}

    const Ogre::String& getLanguage() const override;
    Ogre::GpuProgram* create(Ogre::ResourceManager* creator, const Ogre::String& name,
                             Ogre::ResourceHandle handle, const Ogre::String& group, bool isManual,
                             Ogre::ManualResourceLoader* loader) override;

private:
    Language mLanguage;
};

} // namespace Lixel::Cg

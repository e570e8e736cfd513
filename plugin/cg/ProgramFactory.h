#pragma once

#include "cg/translation/Cache.h"
#include "cg/translation/Request.h"

#include <OgreHighLevelGpuProgramManager.h>

#include <memory>

namespace Lixel::Cg {

/// Makes programs of one language for OGRE's scripts.
class ProgramFactory : public Ogre::HighLevelGpuProgramFactory {
public:
    ProgramFactory(Language language, std::shared_ptr<TranslationCache> cache)
        : mLanguage(language), mCache(std::move(cache)) {}

    const Ogre::String& getLanguage() const override;
    Ogre::GpuProgram* create(Ogre::ResourceManager* creator, const Ogre::String& name,
                             Ogre::ResourceHandle handle, const Ogre::String& group, bool isManual,
                             Ogre::ManualResourceLoader* loader) override;

private:
    Language mLanguage;
    std::shared_ptr<TranslationCache> mCache;
};

} // namespace Lixel::Cg

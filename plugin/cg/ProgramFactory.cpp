#include "cg/ProgramFactory.h"

#include "cg/TranslatedProgram.h"

namespace Lixel::Cg {

const Ogre::String& ProgramFactory::getLanguage() const {
    static const Ogre::String cg = "cg";
    static const Ogre::String hlsl = "hlsl";
    return mLanguage == Language::Cg ? cg : hlsl;
}

Ogre::GpuProgram* ProgramFactory::create(Ogre::ResourceManager* creator, const Ogre::String& name,
                                         Ogre::ResourceHandle handle, const Ogre::String& group,
                                         bool isManual, Ogre::ManualResourceLoader* loader) {
    return new TranslatedProgram(mLanguage, mCache, creator, name, handle, group, isManual, loader);
}

} // namespace Lixel::Cg

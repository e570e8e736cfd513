#include "cg/CgPlugin.h"

#include <OgreHighLevelGpuProgramManager.h>
#include <OgreScriptCompiler.h>
#include <OgreUnifiedHighLevelGpuProgram.h>

namespace Lixel::Cg {
namespace {

/// Gives a language a rank among the delegates of unified programs, unless it has one: of several
/// without a rank OGRE takes the last.
void setRank(const Ogre::String& language, int rank) {
    if (Ogre::UnifiedHighLevelGpuProgram::getPriority(language) < 0)
        Ogre::UnifiedHighLevelGpuProgram::setPriority(language, rank);
}

class CacheFolderCommand : public Ogre::ParamCommand {
public:
    Ogre::String doGet(const void* target) const override {
        return static_cast<const CgPlugin*>(static_cast<const Ogre::StringInterface*>(target))
            ->cache()
            .folder()
            .string();
    }
    void doSet(void* target, const Ogre::String& value) override {
        static_cast<CgPlugin*>(static_cast<Ogre::StringInterface*>(target))
            ->cache()
            .setFolder(value);
    }
};

} // namespace

CgPlugin::CgPlugin()
    : mCache(std::make_shared<TranslationCache>()),
      mCg(Language::Cg, mCache),
      mHlsl(Language::Hlsl, mCache) {
    static CacheFolderCommand command;
    if (createParamDictionary("LixelCg"))
        getParamDictionary()->addParameter(
            Ogre::ParameterDef("cache_folder", "Where translations are kept on disk.",
                               Ogre::PT_STRING),
            &command);
}

const Ogre::String& CgPlugin::getName() const {
    static const Ogre::String name = "Lixel Cg";
    return name;
}

void CgPlugin::initialise() {
    auto& programs = Ogre::HighLevelGpuProgramManager::getSingleton();
    for (ProgramFactory* factory : {&mCg, &mHlsl}) {
        if (programs.isLanguageSupported(factory->getLanguage())) continue;
        programs.addFactory(factory);
        mAdded.push_back(factory);
        mLanguageChoice.add(factory->getLanguage());
    }
    Ogre::ScriptCompilerManager::getSingleton().addTranslatorManager(&mLanguageChoice);
    setRank("glsl", 2);
    setRank("cg", 1);
    setRank("hlsl", 0);
}

void CgPlugin::shutdown() {
    Ogre::ScriptCompilerManager::getSingleton().removeTranslatorManager(&mLanguageChoice);
    mLanguageChoice.clear();
    // A render system may have put its own in the place of one; OGRE then leaves that.
    for (ProgramFactory* factory : mAdded)
        Ogre::HighLevelGpuProgramManager::getSingleton().removeFactory(factory);
    mAdded.clear();
}

} // namespace Lixel::Cg

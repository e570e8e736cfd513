#pragma once

#include "cg/ProgramOptions.h"
#include "cg/translation/Cache.h"

#include <OgreHighLevelGpuProgram.h>

#include <memory>
#include <optional>

namespace Lixel::Cg {

/// A Cg or HLSL program of OGRE's, drawn by an inner GLSL program that is its translation.
///
/// It is translated where OGRE prepares it, which may be in a thread of its own; OpenGL is needed
/// only to load it. What is wrong with it is logged, and makes it unsupported, so that its material
/// takes another technique.
class TranslatedProgram : public Ogre::HighLevelGpuProgram {
public:
    TranslatedProgram(Language language, std::shared_ptr<TranslationCache> cache,
                      Ogre::ResourceManager* creator, const Ogre::String& name,
                      Ogre::ResourceHandle handle, const Ogre::String& group, bool isManual,
                      Ogre::ManualResourceLoader* loader);
    ~TranslatedProgram() override;

    /// Whether the render system has GLSL, one of the profiles can be translated, and no error has
    /// been found.
    bool isSupported() const override;
    const Ogre::String& getLanguage() const override;
    /// With the units of its samplers, and the default values of its source.
    Ogre::GpuProgramParametersSharedPtr createParameters() override;

    const ProgramOptions& options() const { return mOptions; }
    ProgramOptions& options() { return mOptions; }

protected:
    void prepareImpl() override;
    void unprepareImpl() override;
    void loadFromSource() override;
    void createLowLevelImpl() override {}
    void unloadHighLevelImpl() override;
    void buildConstantDefinitions() const override;

private:
    void addScriptWords();
    std::optional<Profile> profile() const;
    std::vector<Define> allDefines() const;
    void translateSource(const Profile& profile);
    void logWarnings() const;
    /// Those of the inner program, which OGRE uploads by; null before it is loaded.
    Ogre::GpuNamedConstants* innerConstants() const;
    void addDefinition(const Parameter& parameter, Ogre::GpuNamedConstants* inner) const;
    void setUnits(Ogre::GpuProgramParameters& parameters) const;
    void setDefaults(Ogre::GpuProgramParameters& parameters) const;

    Language mLanguage;
    std::shared_ptr<TranslationCache> mCache;
    ProgramOptions mOptions;
    Translation mTranslation;
    /// Why the source could not be read; empty if it could.
    Ogre::String mReadError;
};

} // namespace Lixel::Cg

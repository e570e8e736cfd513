#pragma once

#include "scene/OgreVersions.h"

#if LIXEL_UNIFORMS_BY_TEXT

#include <map>
#include <memory>

namespace Lixel {

/** A GLSL program that OpenGL compiles when a material that uses it is compiled.

    OGRE's own GLSL programs are compiled as soon as a script names a parameter of them, because
    only then are their uniforms known. Here that takes the text alone, preprocessed.

    A program of OGRE's does all the work: it reads and preprocesses the text, lays the uniforms out
    as it always does without separate shader objects, is compiled, and is bound. Parameters share
    its record of uniforms, in which OGRE also notes how often each changes: a copy would not do.
    With separate shader objects OpenGL has to be asked, and the program is compiled at once.

    OGRE asks isSupported both where scripts name parameters and where a material chooses among its
    techniques. In the second case it is compiled, so that a material falls back to another
    technique where that fails.
*/
class OnDemandProgram : public Ogre::HighLevelGpuProgram {
public:
    /// What scripts name.
    static const Ogre::String& language();

    OnDemandProgram(Ogre::ResourceManager* creator, const Ogre::String& name,
                    Ogre::ResourceHandle handle, const Ogre::String& group, bool isManual,
                    Ogre::ManualResourceLoader* loader);
    ~OnDemandProgram() override;

    const Ogre::String& getLanguage() const override { return language(); }
    bool isSupported() const override;
    Ogre::GpuProgramParametersSharedPtr createParameters() override;
    const Ogre::GpuProgramParametersPtr& getDefaultParameters() override;
    const Ogre::GpuNamedConstants& getConstantDefinitions() const override;
    Ogre::GpuProgram* _getBindingDelegate() override;

    /// Lines of scripts that are OGRE's program's to heed, by their keyword.
    const Ogre::String& passedOn(const Ogre::String& keyword) const;
    void passOn(const Ogre::String& keyword, const Ogre::String& value);

protected:
    void prepareImpl() override;
    void unprepareImpl() override;
    void unloadImpl() override;
    void loadFromSource() override;
    void createLowLevelImpl() override {}
    void unloadHighLevelImpl() override {}
    void buildConstantDefinitions() const override {}

private:
    /// Whether nothing that is known without OpenGL speaks against it.
    bool mayCompile() const;
    void compile();

    /// OGRE's, which no manager knows: this one has its name. Null until the text is read.
    std::unique_ptr<Ogre::HighLevelGpuProgram> mProgram;
    std::map<Ogre::String, Ogre::String> mPassedOn;
};

} // namespace Lixel

#endif

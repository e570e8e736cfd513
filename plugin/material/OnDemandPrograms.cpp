#include "material/OnDemandPrograms.h"

#include "material/OnDemandProgram.h"
#include "material/ScriptReading.h"
#include "scene/OgreVersions.h"

namespace Lixel {
namespace {

/// OGRE notes it, and tells nobody.
struct CompiledAccess : Ogre::HighLevelGpuProgram {
    using HighLevelGpuProgram::mHighLevelLoaded;
};

#if LIXEL_UNIFORMS_BY_TEXT

class OnDemandProgramFactory : public Ogre::HighLevelGpuProgramFactory {
public:
    OnDemandProgramFactory() { Ogre::HighLevelGpuProgramManager::getSingleton().addFactory(this); }
    ~OnDemandProgramFactory() override {
        Ogre::HighLevelGpuProgramManager::getSingleton().removeFactory(this);
    }
    OnDemandProgramFactory(const OnDemandProgramFactory&) = delete;
    OnDemandProgramFactory& operator=(const OnDemandProgramFactory&) = delete;

    const Ogre::String& getLanguage() const override { return OnDemandProgram::language(); }
    Ogre::GpuProgram* create(Ogre::ResourceManager* creator, const Ogre::String& name,
                             Ogre::ResourceHandle handle, const Ogre::String& group, bool isManual,
                             Ogre::ManualResourceLoader* loader) override {
        return OGRE_NEW OnDemandProgram(creator, name, handle, group, isManual, loader);
    }
};

#endif

} // namespace

#if LIXEL_UNIFORMS_BY_TEXT

struct OnDemandPrograms::Registration {
    ScriptReading reading;
    OnDemandProgramFactory factory;
};

#else

struct OnDemandPrograms::Registration {};

#endif

OnDemandPrograms::OnDemandPrograms() : mRegistration(std::make_unique<Registration>()) {}
OnDemandPrograms::~OnDemandPrograms() = default;

bool isCompiled(const Ogre::GpuProgram& program) {
    const auto* const highLevel = dynamic_cast<const Ogre::HighLevelGpuProgram*>(&program);
    return highLevel != nullptr && highLevel->*(&CompiledAccess::mHighLevelLoaded);
}

} // namespace Lixel

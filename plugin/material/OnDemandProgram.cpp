#include "material/OnDemandProgram.h"

#if LIXEL_UNIFORMS_BY_TEXT

#include "material/ScriptReading.h"

#include <OgreMaterialManager.h>
#include <OgreRenderSystemCapabilities.h>
#include <OgreTechnique.h>

#include <dlfcn.h>

namespace Lixel {
namespace {

const char* const OgresLanguage = "glsl";

// OGRE makes programs for their manager alone, and has parameters made along with a compilation:
// these members are protected.
struct ManagerAccess : Ogre::HighLevelGpuProgramManager {
    using HighLevelGpuProgramManager::getFactory;
};
struct ProgramAccess : Ogre::HighLevelGpuProgram {
    using HighLevelGpuProgram::populateParameterNames;
};

class PassedOnLine : public Ogre::ParamCommand {
public:
    explicit PassedOnLine(const char* keyword) : mKeyword(keyword) {}
    Ogre::ParameterDef definition() const {
        return {mKeyword, "as in GLSL programs", Ogre::PT_STRING};
    }
    Ogre::String doGet(const void* target) const override {
        return static_cast<const OnDemandProgram*>(
                   static_cast<const Ogre::StringInterface*>(target))
            ->passedOn(mKeyword);
    }
    void doSet(void* target, const Ogre::String& value) override {
        static_cast<OnDemandProgram*>(static_cast<Ogre::StringInterface*>(target))
            ->passOn(mKeyword, value);
    }

private:
    Ogre::String mKeyword;
};

bool hasProgram(const Ogre::Material& material, const Ogre::GpuProgram& program) {
    for (const Ogre::Technique* const technique : material.getTechniques())
        for (const Ogre::Pass* const pass : technique->getPasses())
            if (pass->hasGpuProgram(program.getType()) &&
                pass->getGpuProgram(program.getType()).get() == &program)
                return true;
    return false;
}

/// Has materials that took a program for one that compiles choose among their techniques again.
/// They did if they were loaded while a script was being read, as by a listener of the application.
void askMaterialsAgain(const Ogre::GpuProgram& program) {
    for (const auto& [handle, resource] :
         Ogre::MaterialManager::getSingleton().getResourceIterator()) {
        auto& material = static_cast<Ogre::Material&>(*resource);
        // One that is choosing now has not finished.
        if (!material.getCompilationRequired() && hasProgram(material, program))
            material._notifyNeedsRecompile();
    }
}

/// OGRE keeps programs, and the commands of their class, when it unloads the plugin.
void keepLibrary() {
    [[maybe_unused]] static void* const kept = [] {
        Dl_info library;
        return dladdr(reinterpret_cast<const void*>(&keepLibrary), &library) != 0
                   ? dlopen(library.dli_fname, RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE)
                   : nullptr;
    }();
}

} // namespace

const Ogre::String& OnDemandProgram::language() {
    static const Ogre::String name = "lixel_glsl";
    return name;
}

OnDemandProgram::OnDemandProgram(Ogre::ResourceManager* creator, const Ogre::String& name,
                                 Ogre::ResourceHandle handle, const Ogre::String& group,
                                 bool isManual, Ogre::ManualResourceLoader* loader)
    : HighLevelGpuProgram(creator, name, handle, group, isManual, loader) {
    keepLibrary();
    static PassedOnLine attach("attach");
    static PassedOnLine columnMajor("column_major_matrices");
    if (createParamDictionary("Lixel/OnDemandProgram")) {
        setupBaseParamDictionary();
        for (PassedOnLine* line : {&attach, &columnMajor})
            getParamDictionary()->addParameter(line->definition(), line);
    }
    mLoadFromFile = false; // until it has a file
}

OnDemandProgram::~OnDemandProgram() {
    // The base class cannot: it calls what is virtual.
    if (isLoaded()) unload();
}

const Ogre::String& OnDemandProgram::passedOn(const Ogre::String& keyword) const {
    static const Ogre::String none;
    const auto found = mPassedOn.find(keyword);
    return found == mPassedOn.end() ? none : found->second;
}

void OnDemandProgram::passOn(const Ogre::String& keyword, const Ogre::String& value) {
    mPassedOn[keyword] = value;
}

bool OnDemandProgram::mayCompile() const {
    // The language first: before there is a render system, nothing else can be asked.
    return Ogre::HighLevelGpuProgramManager::getSingleton().isLanguageSupported(OgresLanguage) &&
           !mCompileError && isRequiredCapabilitiesSupported() &&
           Ogre::GpuProgramManager::getSingleton().isSyntaxSupported(OgresLanguage);
}

void OnDemandProgram::compile() {
    safePrepare();
    if (!mCompileError) loadHighLevel();
}

bool OnDemandProgram::isSupported() const {
    if (!mayCompile()) return false;
    if (ScriptReading::isOpen()) return true;
    const_cast<OnDemandProgram*>(this)->compile();
    return !mCompileError;
}

Ogre::GpuProgramParametersSharedPtr OnDemandProgram::createParameters() {
    const bool isRead = mProgram != nullptr;
    const bool isUsable = mayCompile();
    Ogre::GpuProgramParametersSharedPtr parameters =
        Ogre::GpuProgramManager::getSingleton().createParameters();
    if (isUsable) {
        safePrepare();
        if (Ogre::Root::getSingleton().getRenderSystem()->getCapabilities()->hasCapability(
                Ogre::RSC_SEPARATE_SHADER_OBJECTS))
            compile();
        if (!mCompileError) (*mProgram.*&ProgramAccess::populateParameterNames)(parameters);
    } else if (!mCompileError) {
        parameters->setIgnoreMissingParams(true); // as OGRE does for languages that it has not
    }
    // Defaults of another text are laid out as that was.
    if (!isRead) postLoadImpl();
    if (mDefaultParams) parameters->copyConstantsFrom(*mDefaultParams);
    return parameters;
}

const Ogre::GpuProgramParametersPtr& OnDemandProgram::getDefaultParameters() {
    if (mDefaultParams && !mProgram) createParameters();
    return HighLevelGpuProgram::getDefaultParameters();
}

const Ogre::GpuNamedConstants& OnDemandProgram::getConstantDefinitions() const {
    if (!mProgram && mayCompile()) const_cast<OnDemandProgram*>(this)->safePrepare();
    return mProgram ? mProgram->getConstantDefinitions() : *mConstantDefs;
}

Ogre::GpuProgram* OnDemandProgram::_getBindingDelegate() {
    // OGRE may bind what no material has loaded.
    if (!mHighLevelLoaded && !mCompileError) load();
    return mProgram ? mProgram->_getBindingDelegate() : nullptr;
}

void OnDemandProgram::prepareImpl() {
    auto& manager = Ogre::HighLevelGpuProgramManager::getSingleton();
    mProgram.reset(static_cast<Ogre::HighLevelGpuProgram*>(
        (manager.*&ManagerAccess::getFactory)(OgresLanguage)
            ->create(&manager, getName(), getHandle(), getGroup(), false, nullptr)));
    mProgram->setType(getType());
    mProgram->setSyntaxCode(OgresLanguage);
    mProgram->setPreprocessorDefines(getPreprocessorDefines());
    if (mLoadFromFile)
        mProgram->setSourceFile(mFilename);
    else
        mProgram->setSource(mSource);
    for (const auto& [keyword, value] : mPassedOn)
        mProgram->setParameter(keyword, value);
    mProgram->prepare();
    mSource = mProgram->getSource();
}

void OnDemandProgram::unprepareImpl() {
    unloadImpl();
}

void OnDemandProgram::unloadImpl() {
    HighLevelGpuProgram::unloadImpl();
    mProgram.reset();
}

void OnDemandProgram::loadFromSource() {
    mProgram->load();
    mCompileError = mProgram->hasCompileError();
    if (mCompileError) askMaterialsAgain(*this);
}

} // namespace Lixel

#endif

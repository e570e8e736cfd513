#include "cg/TranslatedProgram.h"

#include "cg/RenderSystemGlsl.h"

#include <OgreException.h>
#include <OgreGpuProgramManager.h>
#include <OgreHighLevelGpuProgramManager.h>
#include <OgreLogManager.h>
#include <OgreResourceGroupManager.h>
#include <OgreRoot.h>
#include <OgreStringConverter.h>

#include <algorithm>

namespace Lixel::Cg {
namespace {

/// OGRE hands commands their target as a StringInterface.
ProgramOptions& optionsOf(void* target) {
    return static_cast<TranslatedProgram*>(static_cast<Ogre::StringInterface*>(target))->options();
}
const ProgramOptions& optionsOf(const void* target) {
    return static_cast<const TranslatedProgram*>(static_cast<const Ogre::StringInterface*>(target))
        ->options();
}

/// One of a script's words that says something of a program.
template <std::string ProgramOptions::*Member>
class TextCommand : public Ogre::ParamCommand {
public:
    Ogre::String doGet(const void* target) const override { return optionsOf(target).*Member; }
    void doSet(void* target, const Ogre::String& value) override {
        optionsOf(target).*Member = value;
    }
};

class ColumnMajorCommand : public Ogre::ParamCommand {
public:
    Ogre::String doGet(const void* target) const override {
        return Ogre::StringConverter::toString(optionsOf(target).columnMajor);
    }
    void doSet(void* target, const Ogre::String& value) override {
        optionsOf(target).columnMajor = Ogre::StringConverter::parseBool(value);
    }
};

/// For words that tell Direct3D's compiler how to go about it, and mean nothing here.
class IgnoredCommand : public Ogre::ParamCommand {
public:
    Ogre::String doGet(const void*) const override { return {}; }
    void doSet(void*, const Ogre::String&) override {}
};

TextCommand<&ProgramOptions::entry> theEntryCommand;
TextCommand<&ProgramOptions::profiles> theProfilesCommand;
TextCommand<&ProgramOptions::compileArguments> theArgumentsCommand;
ColumnMajorCommand theColumnMajorCommand;
IgnoredCommand theIgnoredCommand;

/// Makes GLSL programs that OGRE's manager does not list. When OGRE ends it walks its lists and
/// lets go of what is in them; the destructor of a translated program would take its inner one from
/// the list that is being walked.
class UnlistedPrograms : public Ogre::HighLevelGpuProgramManager {
public:
    static Ogre::GpuProgramPtr make(const Ogre::String& name, const Ogre::String& group,
                                    Ogre::GpuProgramType type) {
        auto& manager = Ogre::HighLevelGpuProgramManager::getSingleton();
        const Ogre::NameValuePairList language = {{"language", "glsl"}};
        constexpr auto create = &UnlistedPrograms::createImpl;
        auto* program = static_cast<Ogre::GpuProgram*>(
            (manager.*create)(name, 0, group, false, nullptr, &language));
        program->setType(type);
        program->setSyntaxCode("glsl");
        return Ogre::GpuProgramPtr(program);
    }
};

Stage stageOf(Ogre::GpuProgramType type) {
    return type == Ogre::GPT_VERTEX_PROGRAM ? Stage::Vertex : Stage::Fragment;
}

Ogre::GpuConstantType constantTypeOf(const Parameter& parameter) {
    if (parameter.rows == 2) return Ogre::GCT_MATRIX_2X4;
    if (parameter.rows == 3) return Ogre::GCT_MATRIX_3X4;
    if (parameter.rows == 4) return Ogre::GCT_MATRIX_4X4;
    return parameter.base == Parameter::Base::Float ? Ogre::GCT_FLOAT4 : Ogre::GCT_INT4;
}

} // namespace

TranslatedProgram::TranslatedProgram(Language language, std::shared_ptr<TranslationCache> cache,
                                     Ogre::ResourceManager* creator, const Ogre::String& name,
                                     Ogre::ResourceHandle handle, const Ogre::String& group,
                                     bool isManual, Ogre::ManualResourceLoader* loader)
    : HighLevelGpuProgram(creator, name, handle, group, isManual, loader),
      mLanguage(language),
      mCache(std::move(cache)) {
    if (createParamDictionary("Lixel program in " + getLanguage())) {
        setupBaseParamDictionary();
        addScriptWords();
    }
}

TranslatedProgram::~TranslatedProgram() {
    // Not left to the base class, which could not call what is overridden here.
    if (isLoaded()) {
        unload();
    } else {
        unloadHighLevel();
    }
}

void TranslatedProgram::addScriptWords() {
    Ogre::ParamDictionary& words = *getParamDictionary();
    const auto add = [&words](const char* name, const char* use, Ogre::ParamCommand& command) {
        words.addParameter(Ogre::ParameterDef(name, use, Ogre::PT_STRING), &command);
    };
    add("entry_point", "The function to start at.", theEntryCommand);
    if (mLanguage == Language::Cg) {
        add("profiles", "Profiles of Cg or Direct3D; the first known one is used.",
            theProfilesCommand);
        add("compile_arguments", "The command line of Cg's compiler.", theArgumentsCommand);
    } else {
        add("target", "Direct3D's target.", theProfilesCommand);
        add("column_major_matrices", "Whether matrices are laid out in columns.",
            theColumnMajorCommand);
        add("optimisation_level", "Has no effect.", theIgnoredCommand);
        add("backwards_compatibility", "Has no effect.", theIgnoredCommand);
        add("enable_backwards_compatibility", "Has no effect.", theIgnoredCommand);
    }
}

const Ogre::String& TranslatedProgram::getLanguage() const {
    static const Ogre::String cg = "cg";
    static const Ogre::String hlsl = "hlsl";
    return mLanguage == Language::Cg ? cg : hlsl;
}

std::optional<Profile> TranslatedProgram::profile() const {
    if (mType != Ogre::GPT_VERTEX_PROGRAM && mType != Ogre::GPT_FRAGMENT_PROGRAM) return {};
    return chosenProfile(mOptions, mLanguage, stageOf(mType));
}

bool TranslatedProgram::isSupported() const {
    return !mCompileError && isRequiredCapabilitiesSupported() &&
           glslVersionOfRenderSystem() != 0 && profile().has_value();
}

std::vector<Define> TranslatedProgram::allDefines() const {
    std::vector<std::string> ignored;
    auto defines = definesOf(mPreprocessorDefines, ignored);
    const auto arguments = definesOf(mOptions.compileArguments, ignored);
    defines.insert(defines.end(), arguments.begin(), arguments.end());
    if (mLanguage == Language::Cg) {
        defines.push_back({"OGRE_CG", "1"});
    } else {
        defines.push_back({"OGRE_HLSL", std::to_string(shaderModelOf(mOptions))});
    }
    const bool isVertex = mType == Ogre::GPT_VERTEX_PROGRAM;
    defines.push_back({isVertex ? "OGRE_VERTEX_SHADER" : "OGRE_FRAGMENT_SHADER", "1"});
    const auto* renderSystem = Ogre::Root::getSingleton().getRenderSystem();
    if (renderSystem != nullptr && renderSystem->isReverseDepthBufferEnabled())
        defines.push_back({"OGRE_REVERSED_Z", "1"});
    return defines;
}

void TranslatedProgram::prepareImpl() {
    mTranslation = {};
    mReadError.clear();
    const auto chosen = profile();
    if (!chosen || glslVersionOfRenderSystem() == 0) return;
    try {
        HighLevelGpuProgram::prepareImpl();
    } catch (const Ogre::Exception& error) {
        // OGRE lets those who load a program hear of it only from loadFromSource.
        mReadError = error.getDescription();
        return;
    }
    translateSource(*chosen);
}

void TranslatedProgram::unprepareImpl() {
    mTranslation = {};
}

void TranslatedProgram::translateSource(const Profile& chosen) {
    Request request;
    request.language = mLanguage;
    request.stage = chosen.stage;
    request.profile = chosen.name;
    request.source = mSource;
    request.file = mFilename.empty() ? mName : mFilename;
    request.entry = mOptions.entry;
    request.glslVersion = glslVersionOfRenderSystem();
    request.defines = allDefines();
    // OGRE hands Cg's compiler its matrices as they are, in rows.
    request.columnMajor = mLanguage == Language::Hlsl && mOptions.columnMajor;
    request.clampColours = chosen.clampColours;
    request.readInclude = [this](const std::string& name) -> std::optional<std::string> {
        try {
            const auto stream =
                Ogre::ResourceGroupManager::getSingleton().openResource(name, mGroup, this, false);
            if (stream) return stream->getAsString();
        } catch (const Ogre::Exception&) {
            // The translation says that there is no such file, and where it is included.
        }
        return {};
    };
    mTranslation = mCache->translate(request);
    if (mCache->takeFailedFolder())
        Ogre::LogManager::getSingleton().logWarning(
            "Lixel Cg: translations cannot be written to the cache_folder '" +
            mCache->folder().string() + "'; they are kept in memory alone");
}

void TranslatedProgram::logWarnings() const {
    for (const Message& message : mTranslation.messages)
        if (message.kind == Message::Kind::Warning)
            Ogre::LogManager::getSingleton().logWarning("Program '" + mName +
                                                        "': " + toString(message));
}

void TranslatedProgram::loadFromSource() {
    const Message* error = firstError(mTranslation.messages);
    const Ogre::String reason = !mReadError.empty()         ? mReadError
                                : error != nullptr          ? toString(*error)
                                : !mTranslation.succeeded() ? "it has no source"
                                                            : Ogre::String();
    logWarnings();
    if (!reason.empty())
        OGRE_EXCEPT(Ogre::Exception::ERR_RENDERINGAPI_ERROR, reason, "TranslatedProgram");
    const auto inner = UnlistedPrograms::make(mName + "/GLSL", mGroup, mType);
    inner->setSource(mTranslation.glsl);
    inner->setParameter("column_major_matrices", "false");
    inner->load();
    if (!inner->isSupported())
        OGRE_EXCEPT(Ogre::Exception::ERR_RENDERINGAPI_ERROR,
                    "the driver refuses its translation to GLSL, see above", "TranslatedProgram");
    mAssemblerProgram = inner;
}

void TranslatedProgram::unloadHighLevelImpl() {
    mAssemblerProgram.reset();
}

void TranslatedProgram::buildConstantDefinitions() const {
    createParameterMappingStructures(true);
    Ogre::GpuNamedConstants* const constants = innerConstants();
    if (constants != nullptr) {
        mConstantDefs->floatBufferSize = constants->floatBufferSize;
        mConstantDefs->doubleBufferSize = constants->doubleBufferSize;
        mConstantDefs->intBufferSize = constants->intBufferSize;
    }
    for (const Parameter& parameter : mTranslation.parameters)
        addDefinition(parameter, constants);
    // Scripts may set units as they do in GLSL.
    for (const Sampler& sampler : mTranslation.samplers) {
        Parameter unit;
        unit.name = sampler.name;
        unit.glslName = sampler.glslName;
        unit.base = Parameter::Base::Int;
        addDefinition(unit, constants);
    }
}

Ogre::GpuNamedConstants* TranslatedProgram::innerConstants() const {
    if (!mAssemblerProgram) return nullptr;
    const auto& inner = static_cast<const HighLevelGpuProgram&>(*mAssemblerProgram);
    // OGRE gives them as const to all but itself. They are those of a program of our own.
    return const_cast<Ogre::GpuNamedConstants*>(&inner.getConstantDefinitions());
}

void TranslatedProgram::addDefinition(const Parameter& parameter,
                                      Ogre::GpuNamedConstants* inner) const {
    const bool isActive = inner != nullptr && inner->map.count(parameter.glslName) != 0;
    if (isActive) {
        // OGRE notes in our definition how often a script's value changes. Without separate shader
        // objects it uploads by the inner one, which must not be thought to change less often.
        Ogre::GpuConstantDefinition& definition = inner->map.at(parameter.glslName);
        definition.variability = Ogre::GPV_ALL;
        mConstantDefs->map.emplace(parameter.name, definition);
        return;
    }
    // What OpenGL has no use for can be set all the same, as scripts do: after all others, and at
    // no location of OpenGL's.
    Ogre::GpuConstantDefinition definition;
    definition.constType = constantTypeOf(parameter);
    definition.elementSize =
        Ogre::GpuConstantDefinition::getElementSize(definition.constType, true);
    definition.arraySize = std::max(parameter.elements, 1u);
    definition.logicalIndex = static_cast<std::size_t>(-1);
    std::size_t& size =
        definition.isFloat() ? mConstantDefs->floatBufferSize : mConstantDefs->intBufferSize;
    definition.physicalIndex = size;
    size += definition.elementSize * definition.arraySize;
    mConstantDefs->map.emplace(parameter.name, definition);
}

Ogre::GpuProgramParametersSharedPtr TranslatedProgram::createParameters() {
    const bool isFirst = !mDefaultParams;
    auto parameters = HighLevelGpuProgram::createParameters();
    if (!mAssemblerProgram || !isSupported()) return parameters;
    // Later ones are copies of a script's default_params, which begin with them.
    if (isFirst) {
        setUnits(*parameters);
        setDefaults(*parameters);
    }
    return parameters;
}

void TranslatedProgram::setUnits(Ogre::GpuProgramParameters& parameters) const {
    for (const Sampler& sampler : mTranslation.samplers) {
        const auto definition = mConstantDefs->map.find(sampler.name);
        if (definition == mConstantDefs->map.end()) continue;
        const int unit = static_cast<int>(sampler.unit);
        parameters._writeRawConstants(definition->second.physicalIndex, &unit, 1);
    }
}

void TranslatedProgram::setDefaults(Ogre::GpuProgramParameters& parameters) const {
    for (const Parameter& parameter : mTranslation.parameters) {
        if (parameter.defaults.empty()) continue;
        const auto definition = mConstantDefs->map.find(parameter.name);
        if (definition == mConstantDefs->map.end()) continue;
        // Each row begins with a component of its own four; what is not active is not there.
        const std::size_t rows =
            std::min(parameter.defaults.size() / parameter.columns,
                     definition->second.arraySize * definition->second.elementSize / 4);
        for (std::size_t row = 0; row < rows; ++row) {
            const std::size_t index = definition->second.physicalIndex + row * 4;
            const float* values = parameter.defaults.data() + row * parameter.columns;
            if (parameter.base == Parameter::Base::Float) {
                parameters._writeRawConstants(index, values, parameter.columns);
                continue;
            }
            int whole[4];
            for (std::size_t i = 0; i < parameter.columns; ++i)
                whole[i] = static_cast<int>(values[i]);
            parameters._writeRawConstants(index, whole, parameter.columns);
        }
    }
}

} // namespace Lixel::Cg

#include "cg/translation/Glslang.h"

#include "cg/translation/CallCheck.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <charconv>

namespace Lixel::Cg {
namespace {

constexpr int Version = 100; // of GLSL, which HLSL does not have; glslang asks for one
constexpr auto Options =
    static_cast<EShMessages>(EShMsgSpvRules | EShMsgReadHlsl | EShMsgHlslDX9Compatible);

/// glslang's tables, made when first needed. They stay until the process ends: other libraries may
/// use a glslang of their own, but this one is linked to this room alone.
void startGlslang() {
    static const bool started = glslang::InitializeProcess();
    (void)started;
}

EShLanguage stageOf(const Request& request) {
    return request.stage == Stage::Vertex ? EShLangVertex : EShLangFragment;
}

/// Before the shader's constructor, which uses the tables.
EShLanguage startFor(const Request& request) {
    startGlslang();
    return stageOf(request);
}

} // namespace

GlslangShader::GlslangShader(const Request& request, const std::string& preamble,
                             const std::vector<std::string>& texts,
                             const std::vector<std::string>& names)
    : mShader(startFor(request)), mPreamble(preamble), mEntry(request.entry) {
    for (std::size_t i = 0; i < texts.size(); ++i) {
        mTexts.push_back(texts[i].data());
        mLengths.push_back(static_cast<int>(texts[i].size()));
        mNames.push_back(names[i].c_str());
    }
    mShader.setStringsWithLengthsAndNames(mTexts.data(), mLengths.data(), mNames.data(),
                                          static_cast<int>(mTexts.size()));
    mShader.setPreamble(mPreamble.c_str());
    mShader.setEntryPoint(mEntry.c_str());
    mShader.setEnvInput(glslang::EShSourceHlsl, stageOf(request), glslang::EShClientVulkan,
                        Version);
    mShader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
    mShader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
    mShader.setEnvTargetHlslFunctionality1();
    mShader.setAutoMapBindings(true);
    mShader.setAutoMapLocations(true);
}

std::optional<std::string> GlslangShader::preprocess(glslang::TShader::Includer& includer,
                                                     Messages& messages) {
    std::string result;
    const bool good = mShader.preprocess(GetDefaultResources(), Version, ENoProfile, false, false,
                                         Options, &result, includer);
    readLog(mShader.getInfoLog(), messages);
    if (!good && firstError(messages) == nullptr)
        messages.push_back({Message::Kind::Error, mNames.front(), 0, "cannot be preprocessed"});
    if (firstError(messages) != nullptr) return {};
    return result;
}

std::vector<unsigned> GlslangShader::compile(bool optimise, Messages& messages) {
    const bool parsed = mShader.parse(GetDefaultResources(), Version, false, Options);
    readLog(mShader.getInfoLog(), messages);
    if (parsed) checkCalls(*mShader.getIntermediate(), messages);
    const auto fail = [&](const char* text) {
        if (firstError(messages) == nullptr)
            messages.push_back({Message::Kind::Error, mNames.back(), 0, text});
    };
    if (!parsed) fail("cannot be compiled");
    if (firstError(messages) != nullptr) return {};
    glslang::TProgram program;
    program.addShader(&mShader);
    const bool linked = program.link(Options) && program.mapIO();
    readLog(program.getInfoLog(), messages);
    if (!linked) fail("cannot be linked");
    if (firstError(messages) != nullptr) return {};

    std::vector<unsigned> code;
    glslang::SpvOptions options;
    options.disableOptimizer = !optimise;
    spv::SpvBuildLogger logger;
    glslang::GlslangToSpv(*program.getIntermediate(mShader.getStage()), code, &logger, &options);
    const std::string problems = logger.getAllMessages();
    if (problems.find("error") != std::string::npos) fail(problems.c_str());
    if (firstError(messages) != nullptr) return {};
    if (code.empty()) fail("cannot be compiled to SPIR-V");
    return code;
}

void readLog(std::string_view log, Messages& messages) {
    while (!log.empty()) {
        const std::size_t end = std::min(log.find('\n'), log.size());
        std::string_view line = log.substr(0, end);
        log.remove_prefix(std::min(end + 1, log.size()));
        Message message;
        if (line.starts_with("ERROR: ")) {
            line.remove_prefix(7);
        } else if (line.starts_with("WARNING: ")) {
            message.kind = Message::Kind::Warning;
            line.remove_prefix(9);
        } else {
            continue;
        }
        if (line.find("compilation errors.") != std::string_view::npos) continue;
        const std::size_t colon = line.find(": ");
        const std::string_view place = line.substr(0, colon);
        const std::size_t split = place.rfind(':');
        if (colon != std::string_view::npos && split != std::string_view::npos) {
            const std::string_view number = place.substr(split + 1);
            const auto [rest, error] =
                std::from_chars(number.data(), number.data() + number.size(), message.line);
            if (error == std::errc() && rest == number.data() + number.size()) {
                message.file = place.substr(0, split);
                line.remove_prefix(colon + 2);
            }
        }
        while (!line.empty() && line.back() == ' ')
            line.remove_suffix(1);
        message.text = line;
        // A missing entry point is only a warning to glslang.
        if (message.text.find("ntry point not found") != std::string::npos)
            message.kind = Message::Kind::Error;
        messages.push_back(std::move(message));
    }
}

} // namespace Lixel::Cg

#include "cg/translation/Translate.h"

#include "cg/translation/Glsl.h"
#include "cg/translation/Glslang.h"
#include "cg/translation/Prelude.h"
#include "cg/translation/Rewrite.h"
#include "cg/translation/SpirvCross.h"

#include <exception>

namespace Lixel::Cg {
namespace {

void translateSteps(const Request& request, std::vector<IncludedFile>& includes,
                    Translation& result) {
    auto preprocessed = preprocess(request, result.messages);
    if (!preprocessed) return;
    includes = std::move(preprocessed->includes);
    const auto source = rewrite(request, preprocessed->text, result.messages);
    if (!source) return;
    std::vector<unsigned> code;
    {
        const std::vector<std::string> texts = {source->prelude, source->text};
        const std::vector<std::string> names = {PreludeName, request.file};
        code = GlslangShader(request, "", texts, names)
                   .compile(source->hasSeparateSamplers, result.messages);
    }
    if (code.empty()) return;
    const RawGlsl raw = translateSpirv(request, code, result.messages);
    if (!raw.text.empty()) finishGlsl(request, *source, raw, result);
}

} // namespace

Translation translate(const Request& request) {
    std::vector<IncludedFile> includes;
    return translate(request, includes);
}

Translation translate(const Request& request, std::vector<IncludedFile>& includes) {
    Translation result;
    try {
        translateSteps(request, includes, result);
    } catch (const std::exception& error) {
        result.messages.push_back({Message::Kind::Error, request.file, 0, error.what()});
    }
    if (!result.succeeded() && firstError(result.messages) == nullptr)
        result.messages.push_back(
            {Message::Kind::Error, request.file, 0, "cannot be translated, for no known reason"});
    return result;
}

} // namespace Lixel::Cg

#include "cg/translation/Preprocess.h"

#include "cg/translation/Glslang.h"
#include "cg/translation/Literals.h"

#include <memory>

namespace Lixel::Cg {
namespace {

/// More are taken for a file that includes itself.
constexpr std::size_t MostIncludes = 32;

/// Reads files for glslang, and keeps them.
class KeepingIncluder : public glslang::TShader::Includer {
public:
    KeepingIncluder(const Request& request, std::vector<IncludedFile>& files)
        : mRequest(request), mFiles(files) {}

    IncludeResult* includeLocal(const char* name, const char*, std::size_t depth) override {
        return include(name, depth);
    }
    /// glslang asks for it after includeLocal, for "" as well.
    IncludeResult* includeSystem(const char* name, const char*, std::size_t depth) override {
        return include(name, depth);
    }
    void releaseInclude(IncludeResult* result) override { delete result; }

private:
    IncludeResult* include(const std::string& name, std::size_t depth) {
        static const std::string tooDeep =
            "includes are nested too deeply; does it include itself?";
        if (depth > MostIncludes)
            return new IncludeResult("", tooDeep.data(), tooDeep.size(), nullptr);
        std::optional<std::string> text;
        if (mRequest.readInclude) text = mRequest.readInclude(name);
        if (!text) return nullptr;
        mFiles.push_back({name, *text});
        mTexts.push_back(std::make_unique<std::string>(withPlainLiterals(*text)));
        return new IncludeResult(name, mTexts.back()->data(), mTexts.back()->size(), nullptr);
    }

    const Request& mRequest;
    std::vector<IncludedFile>& mFiles;
    std::vector<std::unique_ptr<std::string>> mTexts;
};

std::string definesOf(const Request& request) {
    std::string defines;
    for (const Define& define : request.defines)
        defines += "#define " + define.name + ' ' + define.value + '\n';
    return defines;
}

} // namespace

std::optional<Preprocessed> preprocess(const Request& request, Messages& messages) {
    Preprocessed result;
    KeepingIncluder includer(request, result.includes);
    const std::vector<std::string> texts = {withPlainLiterals(request.source)};
    const std::vector<std::string> names = {request.file};
    GlslangShader shader(request, definesOf(request), texts, names);
    std::optional<std::string> text = shader.preprocess(includer, messages);
    if (!text) return {};
    result.text = std::move(*text);
    return result;
}

} // namespace Lixel::Cg

#pragma once

#include "cg/translation/Message.h"
#include "cg/translation/Request.h"

#include <glslang/Public/ShaderLang.h>

#include <memory>
#include <string_view>

namespace Lixel::Cg {

/// One source in glslang's hands, with the options of this room.
class GlslangShader {
public:
    /// `file` is what messages call the texts' first lines; `preamble` comes before all of them,
    /// without a name. The texts must outlive this.
    GlslangShader(const Request& request, const std::string& preamble,
                  const std::vector<std::string>& texts, const std::vector<std::string>& names);

    /// The text after its preprocessing. Nothing if there was an error, which is added to messages.
    std::optional<std::string> preprocess(glslang::TShader::Includer& includer, Messages& messages);
    /// The program in SPIR-V, empty if there was an error. Optimised code takes longer, and has no
    /// copies of textures, which GLSL cannot have.
    std::vector<unsigned> compile(bool optimise, Messages& messages);

private:
    void setTexts(const std::string& preamble, const std::vector<std::string>& texts,
                  const std::vector<std::string>& names);

    glslang::TShader mShader;
    std::string mPreamble;
    std::string mEntry;
    std::vector<const char*> mTexts;
    std::vector<int> mLengths;
    std::vector<const char*> mNames;
};

/// Adds the messages of one of glslang's logs. Those that say only how many there were are left
/// out.
void readLog(std::string_view log, Messages& messages);

} // namespace Lixel::Cg

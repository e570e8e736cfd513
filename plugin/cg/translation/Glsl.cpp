#include "cg/translation/Glsl.h"

#include "cg/translation/GlslInterface.h"
#include "cg/translation/GlslUniforms.h"

#include <algorithm>
#include <unordered_set>

namespace Lixel::Cg {
namespace {

constexpr const char* InnerMain = "lixel_main";

class GlslWriter {
public:
    GlslWriter(const Request& request, const Rewritten& source, const RawGlsl& raw,
               Translation& translation)
        : mRequest(request),
          mSource(source),
          mRaw(raw),
          mTranslation(translation),
          mTokens(tokensOf(raw.text, "")),
          mEdits(raw.text, mTokens) {}

    void write() {
        const GlslInterface interface = interfaceOf(mRequest, mRaw);
        for (Message message : interface.messages) {
            message.file = mSource.entryFile;
            message.line = mSource.entryLine;
            mTranslation.messages.push_back(std::move(message));
        }
        takeOutDeclarations();
        replaceWords();
        std::string head = replaceGlobals(mSource, mRaw, mTokens, mEdits, mTranslation);
        nameTextures();
        head += interface.declarations;
        head += functionsOfLaterVersions();
        if (mTokens.size() > 0) mEdits.insertBefore(0, head);
        const std::string main = std::string("\nvoid main()\n{\n") + interface.readInputs + "    " +
                                 InnerMain + "();\n" + interface.writeOutputs + "}\n";
        mTranslation.attributes = interface.attributes;
        if (firstError(mTranslation.messages) == nullptr) mTranslation.glsl = mEdits.apply() + main;
    }

private:
    void fail(std::string text) {
        mTranslation.messages.push_back(
            {Message::Kind::Error, mSource.entryFile, mSource.entryLine, std::move(text)});
    }
    void warn(std::string text) {
        mTranslation.messages.push_back(
            {Message::Kind::Warning, mSource.entryFile, mSource.entryLine, std::move(text)});
    }

    /// Those that get others: the structure of globals, and what goes in and out.
    void takeOutDeclarations() {
        std::unordered_set<std::string_view> names;
        for (const InterfaceVariable& variable : mRaw.inputs)
            names.insert(variable.variable);
        for (const InterfaceVariable& variable : mRaw.outputs)
            names.insert(variable.variable);
        std::size_t begin = 0;
        for (std::size_t at = 0; at < mTokens.size(); ++at) {
            const Token& token = mTokens[at];
            if (token.is("{")) {
                const bool isGlobals = at > 0 && mTokens[at - 1].is(GlobalsType);
                const std::size_t after = mTokens.afterClosing(at);
                if (isGlobals) mEdits.erase({begin, std::min(after + 1, mTokens.size())});
                at = after - 1;
                // A structure's semicolon follows.
                begin = after;
            } else if (token.is(";")) {
                // uniform lixel_Globals lixel_globals; in vec4 lixel_in0; out vec3 lixel_out1[2];
                for (std::size_t i = begin; i < at; ++i) {
                    if (!mTokens[i].is(GlobalsName) && names.count(mTokens[i].text) == 0) continue;
                    mEdits.erase({begin, at + 1});
                    break;
                }
                begin = at + 1;
            }
        }
    }

    void replaceWords() {
        for (std::size_t at = 0; at < mTokens.size(); ++at) {
            const Token& token = mTokens[at];
            if (token.is("main") && at > 0 && mTokens[at - 1].is("void")) {
                mEdits.replace(at, InnerMain);
            } else if (token.is("gl_FragData") && mTokens.isAt(at + 1, "[")) {
                // Their index is the output's, not yet a render target's.
                mEdits.replace({at, at + 4}, "lixel_out" + std::string(mTokens[at + 2].text));
            } else if (token.is("switch") && mRequest.glslVersion < 130) {
                fail("OpenGL 2.1 has no switch; use if");
            }
        }
    }

    /// Gives textures the names of the source's, and their units.
    void nameTextures() {
        std::vector<std::string> taken;
        std::unordered_set<unsigned> units;
        struct Named {
            Sampler sampler;
            std::size_t order; ///< in the source
            int unit;
        };
        std::vector<Named> all;
        for (const TextTexture& texture : mRaw.textures) {
            const auto known = std::find_if(
                mSource.samplers.begin(), mSource.samplers.end(),
                [&](const SourceSampler& sampler) { return sampler.hlslName == texture.texture; });
            if (known == mSource.samplers.end()) {
                fail("the texture '" + texture.texture + "' is none of the program's parameters");
                return;
            }
            Named named;
            named.sampler.name = known->name;
            named.sampler.glslName = glslNameFor("s_", known->name, taken);
            taken.push_back(named.sampler.glslName);
            named.sampler.glslType = typeOf(texture.variable);
            named.order = static_cast<std::size_t>(known - mSource.samplers.begin());
            named.unit = known->unit;
            if (named.unit >= 0) units.insert(static_cast<unsigned>(named.unit));
            warnOfOtherState(texture, *known);
            rename(texture.variable, named.sampler.glslName);
            all.push_back(std::move(named));
        }
        std::stable_sort(all.begin(), all.end(),
                         [](const Named& a, const Named& b) { return a.order < b.order; });
        unsigned next = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            Named& named = all[i];
            // One texture that is read in two states has one unit.
            const bool again = i > 0 && all[i - 1].order == named.order;
            if (named.unit >= 0) {
                named.sampler.unit = static_cast<unsigned>(named.unit);
            } else if (again) {
                named.sampler.unit = all[i - 1].sampler.unit;
            } else {
                while (units.count(next) != 0)
                    ++next;
                named.sampler.unit = next++;
            }
            mTranslation.samplers.push_back(std::move(named.sampler));
        }
    }

    /// OpenGL's texture unit has the state of the texture's own index.
    void warnOfOtherState(const TextTexture& texture, const SourceSampler& known) {
        const auto state = std::find_if(
            mSource.samplers.begin(), mSource.samplers.end(),
            [&](const SourceSampler& sampler) { return sampler.hlslName == texture.state; });
        if (state == mSource.samplers.end() || state->unit < 0 || known.unit < 0 ||
            state->unit == known.unit)
            return;
        warn("the texture '" + known.name +
             "' is read with the addressing and filtering of its own "
             "unit " +
             std::to_string(known.unit) + ", not of the sampler '" + state->name +
             "' with the unit " + std::to_string(state->unit));
    }

    std::string typeOf(std::string_view variable) const {
        for (std::size_t at = 1; at < mTokens.size(); ++at)
            if (mTokens[at].is(variable)) return std::string(mTokens[at - 1].text);
        return {};
    }

    void rename(std::string_view from, const std::string& to) {
        for (std::size_t at = 0; at < mTokens.size(); ++at)
            if (mTokens[at].is(from)) mEdits.replace(at, to);
    }

    /// GLSL 1.20 lacks them.
    std::string functionsOfLaterVersions() const {
        if (mRequest.glslVersion >= 130) return {};
        struct LaterFunction {
            const char* name;
            const char* body; ///< of its argument x, with T for its type
        };
        constexpr LaterFunction Functions[] = {
            {"trunc", "sign(x) * floor(abs(x))"},
            {"round", "sign(x) * floor(abs(x) + 0.5)"},
            {"roundEven", "floor(x + 0.5) - (1.0 - step(0.25, abs(fract(x) - 0.5) * 1e30)) * "
                          "mod(floor(x + 0.5), 2.0)"},
            {"sinh", "(exp(x) - exp(-x)) * 0.5"},
            {"cosh", "(exp(x) + exp(-x)) * 0.5"},
            {"tanh", "1.0 - 2.0 / (exp(2.0 * x) + 1.0)"}};
        std::string text;
        for (const LaterFunction& function : Functions) {
            const bool isUsed =
                std::any_of(mTokens.list.begin(), mTokens.list.end(),
                            [&](const Token& token) { return token.is(function.name); });
            if (!isUsed) continue;
            for (const std::string type : {"float", "vec2", "vec3", "vec4"})
                text += type + ' ' + function.name + '(' + type + " x) { return " + function.body +
                        "; }\n";
        }
        return text;
    }

    const Request& mRequest;
    const Rewritten& mSource;
    const RawGlsl& mRaw;
    Translation& mTranslation;
    Tokens mTokens;
    Edits mEdits;
};

} // namespace

void finishGlsl(const Request& request, const Rewritten& source, const RawGlsl& raw,
                Translation& translation) {
    GlslWriter(request, source, raw, translation).write();
}

} // namespace Lixel::Cg

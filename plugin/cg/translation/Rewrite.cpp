#include "cg/translation/Rewrite.h"

#include "cg/translation/Complexity.h"
#include "cg/translation/DefaultValue.h"
#include "cg/translation/Edits.h"
#include "cg/translation/FunctionBody.h"
#include "cg/translation/Initializers.h"
#include "cg/translation/Names.h"
#include "cg/translation/Prelude.h"
#include "cg/translation/Types.h"

#include <algorithm>
#include <charconv>
#include <unordered_map>
#include <unordered_set>

namespace Lixel::Cg {
namespace {

using Words = std::unordered_set<std::string_view>;

/// Words that the front end reserves and sources use as names. Where they are meant as keywords
/// another word follows them.
const Words ReservedWords = {
    "sample",     "texture",        "point",       "line",          "triangle", "linear",
    "lineadj",    "centroid",       "triangleadj", "precise",       "snorm",    "unorm",
    "shared",     "groupshared",    "string",      "noperspective", "vector",   "matrix",
    "dword",      "pass",           "technique",   "sampler",       "class",    "this",
    "export",     "namespace",      "buffer",      "volatile",      "extern",   "interface",
    "packoffset", "nointerpolation"};

/// The register or texture unit that a semantic names, or -1.
int unitOf(const Tokens& tokens, TokenRange semantic) {
    int unit = -1;
    for (std::size_t at = semantic.first; at < semantic.last; ++at) {
        std::string_view word = tokens[at].text;
        if (word.starts_with("TEXUNIT")) {
            word.remove_prefix(7);
        } else if (word.size() > 1 && (word[0] == 's' || word[0] == 't')) {
            word.remove_prefix(1);
        } else {
            continue;
        }
        int number = -1;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
        if (error == std::errc() && end == word.data() + word.size()) unit = number;
    }
    return unit;
}

class Rewriter {
public:
    Rewriter(const Request& request, std::string_view text, Messages& messages)
        : mRequest(request),
          mTokens(tokensOf(text, request.file)),
          mEdits(text, mTokens),
          mMessages(messages),
          mRowMajorPragma(text.find("pack_matrix") != std::string_view::npos &&
                          text.find("row_major") != std::string_view::npos) {}

    std::optional<Rewritten> rewrite() {
        checkComplexity(mTokens, mMessages);
        if (firstError(mMessages) != nullptr) return {};
        mOutline = outlineOf(mTokens);
        chooseProfiles();
        const FunctionOutline* entry = findEntry();
        if (entry == nullptr) return {};
        keepWhatIsReached(*entry);
        for (const TokenRange mark : mOutline.bufferMarks)
            mEdits.erase(mark);
        for (const TokenRange effect : mOutline.effects)
            mEdits.erase(effect);
        mGlobals = mOutline.structNames;
        mGlobals.insert(mOutline.typeNames.begin(), mOutline.typeNames.end());
        for (const Declaration& variable : mOutline.variables)
            rewriteGlobal(variable);
        for (const TokenRange range : mOutline.unknown)
            fail(range.first, "this is not a declaration");
        for (const FunctionOutline* function : mKept) {
            if (!function->hasGoodHead)
                fail(function->name,
                     "neither a function nor a variable: '" + nameAt(function->name) + '\'');
            checkBody(*function);
            if (function != entry) rewriteParameters(*function);
        }
        // As the front end would say it.
        if (const auto unknown = unknownName(mTokens, mOutline, mKept))
            fail(*unknown, '\'' + nameAt(*unknown) + "' : unknown variable");
        rewriteEntry(*entry);
        groupInitializers(mTokens, mConstants, mEdits);
        rewriteWords();
        if (firstError(mMessages) != nullptr) return {};
        mResult.text = mEdits.apply();
        mResult.prelude = preludeFor(mRequest.stage, mFromPrelude);
        const Place place = mTokens[entry->name].place;
        mResult.entryFile = mTokens.files[place.file];
        mResult.entryLine = place.line;
        return std::move(mResult);
    }

private:
    void fail(std::size_t token, std::string text) {
        const Place place = token < mTokens.size() ? mTokens[token].place : Place{};
        mMessages.push_back(
            {Message::Kind::Error, mTokens.files[place.file], place.line, std::move(text)});
    }

    std::string nameAt(std::size_t token) const { return std::string(mTokens[token].text); }

    /// The name as rewriteWords makes it.
    std::string plainNameAt(std::size_t token) const {
        const std::string name = nameAt(token);
        return ReservedWords.count(name) != 0 ? plainWord(name) : name;
    }

    std::string textOf(TokenRange range) const {
        std::string text;
        for (std::size_t at = range.first; at < range.last; ++at) {
            if (!text.empty()) text += ' ';
            text += mTokens[at].text;
        }
        return text;
    }

    const FunctionOutline* findEntry() {
        const FunctionOutline* entry = nullptr;
        for (const FunctionOutline& function : mOutline.functions) {
            if (!function.body.empty() && mTokens[function.name].is(mRequest.entry))
                entry = &function;
        }
        if (entry == nullptr) {
            mMessages.push_back({Message::Kind::Error, mRequest.file, 0,
                                 "there is no function '" + mRequest.entry +
                                     "', which the script names as the entry point"});
        }
        return entry;
    }

    /// Leaves out functions for other profiles, where there is one for this or for all.
    void chooseProfiles() {
        Words suitable;
        for (const FunctionOutline& function : mOutline.functions)
            if (function.profile.empty() || function.profile == mRequest.profile)
                suitable.insert(mTokens[function.name].text);
        Words taken;
        std::vector<FunctionOutline> chosen;
        for (const FunctionOutline& function : mOutline.functions) {
            const std::string_view name = mTokens[function.name].text;
            const bool isFirst = function.profile.empty() || taken.insert(name).second;
            const bool isSuitable = function.profile.empty() ||
                                    function.profile == mRequest.profile ||
                                    suitable.count(name) == 0;
            if (isFirst && isSuitable) {
                chosen.push_back(function);
                if (!function.profile.empty()) mEdits.erase({function.begin, function.begin + 1});
            } else {
                if (!function.profile.empty()) taken.erase(name);
                eraseFunction(function);
            }
        }
        mOutline.functions = std::move(chosen);
    }

    void eraseFunction(const FunctionOutline& function) {
        const std::size_t end =
            function.body.empty() ? function.parameters.last + 1 : function.body.last;
        mEdits.erase({function.begin, std::min(end, mTokens.size())});
    }

    void addWords(TokenRange range, std::vector<std::string_view>& fresh) {
        for (std::size_t at = range.first; at < range.last; ++at)
            if (mTokens[at].isWord() && mWords.insert(mTokens[at].text).second)
                fresh.push_back(mTokens[at].text);
    }

    /// Leaves out functions that nothing calls: they may be for another stage.
    void keepWhatIsReached(const FunctionOutline& entry) {
        std::unordered_map<std::string_view, std::vector<const FunctionOutline*>> byName;
        for (const FunctionOutline& function : mOutline.functions) {
            byName[mTokens[function.name].text].push_back(&function);
            mDefined.insert(mTokens[function.name].text);
        }
        std::vector<std::string_view> fresh;
        for (const Declaration& variable : mOutline.variables) {
            if (isConstant(variable) || variable.declarators.empty()) {
                addWords(variable.all, fresh);
                continue;
            }
            for (const Declarator& declarator : variable.declarators)
                addWords(declarator.arrays, fresh);
        }
        Words kept;
        const auto keep = [&](const FunctionOutline& function) {
            mKept.push_back(&function);
            addWords(function.parameters, fresh);
            addWords(function.body, fresh);
        };
        keep(entry);
        while (!fresh.empty()) {
            const std::string_view word = fresh.back();
            fresh.pop_back();
            const auto functions = byName.find(word);
            if (functions == byName.end() || !kept.insert(word).second) continue;
            for (const FunctionOutline* function : functions->second)
                if (function != &entry) keep(*function);
        }
        for (const FunctionOutline& function : mOutline.functions) {
            if (std::find(mKept.begin(), mKept.end(), &function) != mKept.end()) continue;
            eraseFunction(function);
        }
    }

    bool isType(const Declaration& declaration, const char* name) const {
        return mTokens[declaration.type.first].is(name);
    }

    /// Whether it has the same value for all uses of the program.
    bool isConstant(const Declaration& declaration) const {
        if (hasModifier(mTokens, declaration, "static") ||
            hasModifier(mTokens, declaration, "groupshared"))
            return true;
        return hasModifier(mTokens, declaration, "const") &&
               !hasModifier(mTokens, declaration, "uniform") && !declaration.declarators.empty() &&
               !declaration.declarators.front().initial.empty() &&
               !isSamplerType(mTokens[declaration.type.first].text);
    }

    void rewriteGlobal(const Declaration& declaration) {
        if (declaration.declarators.empty()) return; // a structure
        if (isConstant(declaration)) {
            noteConstants(declaration);
            if (!hasModifier(mTokens, declaration, "static"))
                mEdits.insertBefore(declaration.all.first, "static ");
            return;
        }
        std::string text;
        for (const Declarator& declarator : declaration.declarators) {
            const std::size_t messages = mMessages.size();
            std::string one = parameterText(declaration, declarator, plainNameAt(declarator.name));
            if (mWords.count(mTokens[declarator.name].text) != 0) {
                checkNew(declarator);
                text += one;
            } else {
                // Whatever it is, it does not matter here.
                mMessages.resize(messages);
            }
        }
        if (!text.empty()) text.pop_back(); // the semicolon stands after the declaration
        mEdits.replace(declaration.all, std::move(text));
    }

    /// A declaration of a parameter that the front end takes, with its semicolon.
    std::string parameterText(const Declaration& declaration, const Declarator& declarator,
                              const std::string& hlslName) {
        const std::string_view type = mTokens[declaration.type.first].text;
        if (const char* reason = whyUnsupported(type)) {
            fail(declaration.type.first, std::string(type) + ": " + reason);
            return {};
        }
        // Which texture a sampler reads is said by the script.
        if (type == "texture") return {};
        return isSamplerType(type) ? samplerText(declaration, declarator, hlslName)
                                   : uniformText(declaration, declarator, hlslName);
    }

    /// The front end does not survive a parameter with the name of another global variable.
    void checkNew(const Declarator& declarator) {
        const std::string_view name = mTokens[declarator.name].text;
        if (!mGlobals.insert(name).second)
            fail(declarator.name, "declared twice: '" + std::string(name) + '\'');
    }

    void noteConstants(const Declaration& declaration) {
        for (const Declarator& declarator : declaration.declarators) {
            checkNew(declarator);
            if (auto value = valueOf(mTokens, declarator.initial, mConstants))
                mConstants[mTokens[declarator.name].text] = std::move(*value);
            if (!declarator.annotation.empty()) mEdits.erase(declarator.annotation);
        }
    }

    /// A declaration of a sampler that the front end takes, with its semicolon.
    std::string samplerText(const Declaration& declaration, const Declarator& declarator,
                            const std::string& hlslName) {
        SourceSampler sampler;
        sampler.name = nameAt(declarator.name);
        sampler.hlslName = hlslName;
        sampler.unit = unitOf(mTokens, declarator.semantic);
        if (!declarator.arrays.empty()) {
            fail(declarator.name, "arrays of samplers are not supported: '" + sampler.name + '\'');
            return {};
        }
        std::string type = textOf(declaration.type);
        if (type == "sampler") type = kindOfSampler(sampler.name);
        if (type.starts_with("Texture")) mResult.hasSeparateSamplers = true;
        mResult.samplers.push_back(std::move(sampler));
        return "uniform " + type + ' ' + hlslName + ';';
    }

    /// The type of a sampler that is declared without dimensions, by the first function it goes to.
    std::string kindOfSampler(std::string_view name) const {
        for (std::size_t at = 2; at < mTokens.size(); ++at) {
            if (!mTokens[at].is(name) || !mTokens[at - 1].is("(")) continue;
            const std::string_view function = mTokens[at - 2].text;
            if (function.find("tex1D") != std::string_view::npos) return "sampler1D";
            if (function.find("tex2D") != std::string_view::npos) return "sampler2D";
            if (function.find("tex3D") != std::string_view::npos) return "sampler3D";
            if (function.find("texCUBE") != std::string_view::npos) return "samplerCUBE";
            if (function.starts_with("Sample")) return "SamplerState";
        }
        return "sampler2D";
    }

    /// A declaration of a uniform parameter that the front end takes, with its semicolon.
    std::string uniformText(const Declaration& declaration, const Declarator& declarator,
                            const std::string& hlslName) {
        SourceParameter source;
        Parameter& parameter = source.parameter;
        parameter.name = nameAt(declarator.name);
        const auto type = numberTypeOf(mTokens, declaration.type);
        if (!type) {
            const std::string typeName = textOf(declaration.type);
            const bool isStruct =
                isType(declaration, "struct") || mOutline.structNames.count(typeName) != 0;
            fail(declarator.name,
                 (isStruct ? "structures cannot be parameters: '"
                           : "cannot be a parameter, with the type " + typeName + ": '") +
                     parameter.name + '\'');
            return {};
        }
        parameter.base = type->base;
        parameter.rows = type->isMatrix ? type->rows : 1;
        parameter.columns = type->columns;
        if (!readElements(declarator, parameter) || !readDefaults(declarator, parameter)) return {};

        const bool transposed = type->isMatrix && isTransposed(declaration);
        source.hlslName = hlslName;
        std::string derived;
        if (type->isBool || transposed) {
            if (parameter.elements != 0 || (transposed && type->rows != type->columns)) {
                fail(declarator.name,
                     transposed ? "only square matrices, and no arrays of them, can be declared in "
                                  "another order than the script's column_major_matrices: '" +
                                      parameter.name + '\''
                                : "arrays of bool cannot be parameters: '" + parameter.name + '\'');
                return {};
            }
            source.hlslName = "lixel_raw_" + hlslName;
            derived = transposed ? "static " + hlslNameOf(*type) + ' ' + hlslName +
                                       " = transpose(" + source.hlslName + ");"
                                 : "static bool" +
                                       (type->columns > 1 ? std::to_string(type->columns) : "") +
                                       ' ' + hlslName + " = " + source.hlslName + " != 0;";
        }
        const std::string arrays =
            parameter.elements == 0 ? "" : '[' + std::to_string(parameter.elements) + ']';
        const std::string text =
            "uniform " + hlslNameOf(*type) + ' ' + source.hlslName + arrays + ';' + derived;
        mResult.parameters.push_back(std::move(source));
        return text;
    }

    bool readElements(const Declarator& declarator, Parameter& parameter) {
        std::size_t at = declarator.arrays.first;
        double elements = declarator.arrays.empty() ? 0 : 1;
        while (at < declarator.arrays.last) {
            const std::size_t end = mTokens.afterClosing(at, declarator.arrays.last);
            auto size = valueOf(mTokens, {at + 1, end - 1}, mConstants);
            if (end == at + 2) size = sizeByInitial(declarator, parameter);
            if (!size || size->size() != 1 || !(size->front() >= 1) || size->front() > 65536) {
                fail(at, "the size of the array '" + parameter.name + "' is not known");
                return false;
            }
            if (at != declarator.arrays.first) {
                fail(at, "arrays of arrays cannot be parameters: '" + parameter.name + '\'');
                return false;
            }
            elements *= size->front();
            at = end;
        }
        parameter.elements = static_cast<unsigned>(elements);
        return true;
    }

    /// The number of elements of an array without a size, which its initial value has.
    std::optional<std::vector<double>> sizeByInitial(const Declarator& declarator,
                                                     const Parameter& parameter) const {
        const auto value = valueOf(mTokens, declarator.initial, mConstants);
        if (!value || value->empty()) return {};
        return std::vector<double>{static_cast<double>(value->size()) /
                                   (parameter.rows * parameter.columns)};
    }

    bool readDefaults(const Declarator& declarator, Parameter& parameter) {
        if (declarator.initial.empty()) return true;
        auto value = valueOf(mTokens, declarator.initial, mConstants);
        const std::size_t count = static_cast<std::size_t>(parameter.rows) * parameter.columns *
                                  std::max(parameter.elements, 1u);
        if (value && value->size() == 1) value->resize(count, value->front());
        if (!value || value->size() != count) {
            fail(declarator.initial.first, "the default value of the parameter '" + parameter.name +
                                               "' is not made of numbers alone");
            return false;
        }
        for (const double number : *value)
            parameter.defaults.push_back(static_cast<float>(number));
        return true;
    }

    /// Whether a matrix is declared in another order than the application lays it out.
    bool isTransposed(const Declaration& declaration) const {
        if (hasModifier(mTokens, declaration, "row_major")) return mRequest.columnMajor;
        if (hasModifier(mTokens, declaration, "column_major")) return !mRequest.columnMajor;
        return mRowMajorPragma && mRequest.columnMajor;
    }

    /// The front end does not survive some of what is wrong in a function.
    void checkBody(const FunctionOutline& function) {
        for (const std::size_t name : functionsWithin(mTokens, function))
            fail(name, "a function within a function: '" + nameAt(name) + '\'');
        rewriteCounting(mTokens, function, mEdits, mFromPrelude);
    }

    /// Takes away what only parameters of an entry point may have.
    void rewriteParameters(const FunctionOutline& function) {
        for (const TokenRange range : splitAtCommas(mTokens, function.parameters)) {
            const auto declaration = declarationOf(mTokens, range);
            if (!declaration || declaration->declarators.empty()) continue;
            checkType(*declaration);
            const Declarator& declarator = declaration->declarators.front();
            eraseModifiers(*declaration, {"uniform", "varying"});
            if (!declarator.semantic.empty()) mEdits.erase(declarator.semantic);
            if (isType(*declaration, "sampler"))
                mEdits.replace(declaration->type.first, kindOfSampler(nameAt(declarator.name)));
        }
    }

    void checkType(const Declaration& declaration) {
        const std::string_view type = mTokens[declaration.type.first].text;
        if (const char* reason = whyUnsupported(type))
            fail(declaration.type.first, std::string(type) + ": " + reason);
    }

    void eraseModifiers(const Declaration& declaration, std::initializer_list<const char*> names) {
        for (std::size_t at = declaration.modifiers.first; at < declaration.modifiers.last; ++at)
            for (const char* name : names)
                if (mTokens[at].is(name)) mEdits.erase({at, at + 1});
    }

    void rewriteEntry(const FunctionOutline& entry) {
        bool keptOne = false;
        const auto parts = splitAtCommas(mTokens, entry.parameters);
        for (const TokenRange range : parts) {
            const auto declaration = declarationOf(mTokens, range);
            if (!declaration || declaration->declarators.empty()) {
                if (!mTokens[range.first].is("void") || range.last != range.first + 1)
                    fail(range.first, "this is not a parameter");
                continue;
            }
            if (isUniformParameter(*declaration)) {
                hoist(entry, *declaration);
                // With the comma before it, or after it where it is the first.
                const bool commaAfter = !keptOne && range.last < entry.parameters.last;
                mEdits.erase({keptOne ? range.first - 1 : range.first,
                              commaAfter ? range.last + 1 : range.last});
                continue;
            }
            keptOne = true;
            checkType(*declaration);
            checkVarying(*declaration);
            eraseModifiers(*declaration, {"varying"});
            const Declarator& declarator = declaration->declarators.front();
            if (!declarator.initial.empty())
                mEdits.erase({declarator.initial.first - 1, declarator.initial.last});
        }
    }

    bool isUniformParameter(const Declaration& declaration) const {
        return hasModifier(mTokens, declaration, "uniform") ||
               isSamplerType(mTokens[declaration.type.first].text) ||
               whyUnsupported(mTokens[declaration.type.first].text) != nullptr;
    }

    void checkVarying(const Declaration& declaration) {
        const Declarator& declarator = declaration.declarators.front();
        if (declarator.semantic.empty() && numberTypeOf(mTokens, declaration.type))
            fail(declarator.name, "the parameter '" + nameAt(declarator.name) +
                                      "' is neither uniform nor has it a semantic");
    }

    /// Makes a uniform parameter of the entry point a global one: as an argument it would be
    /// copied, arrays as a whole.
    void hoist(const FunctionOutline& entry, const Declaration& declaration) {
        const Declarator& declarator = declaration.declarators.front();
        const std::string name = nameAt(declarator.name);
        std::string hlslName = plainNameAt(declarator.name);
        if (isTaken(name)) {
            hlslName = "lixel_of_entry_" + name;
            for (std::size_t at = entry.body.first; at < entry.body.last; ++at)
                if (mTokens[at].is(name) && !mTokens[at - 1].is(".")) mRenamed[at] = hlslName;
        }
        if (hlslName == name) checkNew(declarator);
        if (!mHoisted.insert(mTokens[declarator.name].text).second)
            return fail(declarator.name, "declared twice: '" + name + '\'');
        const std::string text = parameterText(declaration, declarator, hlslName);
        mEdits.insertBefore(entry.begin, lineDirective(mTokens, mTokens[declarator.name].place) +
                                             text +
                                             lineDirective(mTokens, mTokens[entry.begin].place));
    }

    /// Whether a name means something outside of functions.
    bool isTaken(std::string_view name) const {
        if (mDefined.count(name) != 0 || mOutline.typeNames.count(name) != 0 ||
            mOutline.structNames.count(name) != 0)
            return true;
        for (const Declaration& variable : mOutline.variables)
            for (const Declarator& declarator : variable.declarators)
                if (mTokens[declarator.name].is(name)) return true;
        return false;
    }

    static std::string plainWord(std::string_view word) {
        return "lixel_word_" + std::string(word);
    }

    void rewriteWords() {
        const bool isCg = mRequest.language == Language::Cg;
        for (std::size_t at = 0; at < mTokens.size(); ++at) {
            const Token& token = mTokens[at];
            if (!token.isWord()) continue;
            if (const auto renamed = mRenamed.find(at); renamed != mRenamed.end()) {
                mEdits.replace(at, renamed->second);
                continue;
            }
            if (token.is("glstate") && mWords.count(token.text) != 0)
                fail(at, "glstate is not supported; take a parameter, and have the script set it "
                         "by param_named_auto");
            if (token.text.starts_with("lixel_") && mWords.count(token.text) != 0)
                fail(at,
                     "names that begin with lixel_ are taken: '" + std::string(token.text) + '\'');
            const bool wordNext = at + 1 < mTokens.size() && mTokens[at + 1].isWord();
            const bool templateNext =
                (token.is("vector") || token.is("matrix")) && mTokens.isAt(at + 1, "<");
            if (!wordNext && !templateNext && ReservedWords.count(token.text) != 0) {
                mEdits.replace(at, plainWord(token.text));
            } else if (token.is("varying") || token.is("packed")) {
                mEdits.erase({at, at + 1});
            } else if (isInPrelude(mRequest.language, token.text) && mTokens.isAt(at + 1, "(") &&
                       mDefined.count(token.text) == 0) {
                mFromPrelude.insert(token.text);
                mEdits.replace(at, preludeNameOf(token.text));
            } else if (isCg) {
                if (std::string plain = plainTypeName(token.text); plain != token.text)
                    mEdits.replace(at, std::move(plain));
            }
        }
    }

    const Request& mRequest;
    Tokens mTokens;
    Edits mEdits;
    Messages& mMessages;
    bool mRowMajorPragma;
    Outline mOutline;
    std::vector<const FunctionOutline*> mKept;
    Words mWords;   ///< of what is kept
    Words mDefined; ///< the names of functions
    Words mFromPrelude;
    Words mHoisted; ///< uniform parameters of the entry point
    Words mGlobals; ///< names that are taken outside of functions
    Constants mConstants;
    std::unordered_map<std::size_t, std::string> mRenamed;
    Rewritten mResult;
};

} // namespace

std::optional<Rewritten> rewrite(const Request& request, std::string_view preprocessed,
                                 Messages& messages) {
    return Rewriter(request, preprocessed, messages).rewrite();
}

} // namespace Lixel::Cg

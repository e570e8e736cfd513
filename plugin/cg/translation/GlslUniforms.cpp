#include "cg/translation/GlslUniforms.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace Lixel::Cg {
namespace {

/// How a parameter is declared, and how its value is got from that.
struct Layout {
    std::string type;
    std::string array;     ///< [4]
    std::string convert;   ///< a constructor that makes the parameter of it, or empty
    std::string swizzle;   ///< .xyz, or empty
    std::string plainType; ///< the type that the source has
};

Layout layoutOf(const Parameter& parameter) {
    Layout layout;
    const bool isFloat = parameter.base == Parameter::Base::Float;
    const unsigned columns = parameter.columns;
    if (parameter.elements != 0) layout.array = '[' + std::to_string(parameter.elements) + ']';
    if (parameter.rows > 1) {
        // The source's rows are GLSL's columns.
        const std::string rows = "mat" + std::to_string(parameter.rows) + 'x';
        layout.type = rows + '4';
        layout.plainType = rows + std::to_string(columns);
        if (columns < 4) layout.convert = layout.plainType;
        return layout;
    }
    const std::string vector = isFloat ? "vec" : "ivec";
    layout.plainType =
        columns == 1 ? (isFloat ? "float" : "int") : vector + std::to_string(columns);
    layout.type = vector + '4';
    if (columns < 4) layout.swizzle = '.' + std::string("xyz").substr(0, columns);
    return layout;
}

/// The index in m12, or nothing.
std::optional<std::size_t> memberOf(std::string_view word) {
    if (!word.starts_with('m')) return {};
    word.remove_prefix(1);
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (error != std::errc() || end != word.data() + word.size()) return {};
    return index;
}

/// An array as the source has it, made of the padded one.
std::string wholeArray(const Parameter& parameter, const Layout& layout) {
    std::string text = layout.plainType + "[](";
    for (unsigned i = 0; i < parameter.elements; ++i) {
        if (i > 0) text += ", ";
        const std::string element = parameter.glslName + '[' + std::to_string(i) + ']';
        text += layout.convert.empty() ? element + layout.swizzle
                                       : layout.convert + '(' + element + ')';
    }
    return text + ')';
}

/// Replaces one use, whose three tokens begin at `at`.
void replaceUse(const Parameter& parameter, const Layout& layout, std::size_t at,
                const Tokens& tokens, Edits& edits) {
    const bool isPadded = !layout.convert.empty() || !layout.swizzle.empty();
    const bool isIndexed = tokens.isAt(at + 3, "[");
    if (parameter.elements != 0 && isPadded && !isIndexed) {
        edits.replace({at, at + 3}, wholeArray(parameter, layout));
        return;
    }
    const std::size_t after =
        parameter.elements != 0 && isIndexed ? tokens.afterClosing(at + 3) : at + 3;
    const bool isConverted = !layout.convert.empty();
    edits.replace({at, at + 3}, (isConverted ? layout.convert + '(' : "") + parameter.glslName);
    if (isConverted) edits.insertAfter(after - 1, ")");
    if (!layout.swizzle.empty()) edits.insertAfter(after - 1, layout.swizzle);
}

} // namespace

std::string glslNameFor(const std::string& prefix, const std::string& name,
                        const std::vector<std::string>& taken) {
    std::string clean = prefix;
    for (const char c : name) {
        const char next = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
        if (next != '_' || clean.back() != '_') clean += next;
    }
    std::string unique = clean;
    for (unsigned i = 2; std::find(taken.begin(), taken.end(), unique) != taken.end(); ++i)
        unique = clean + (clean.back() == '_' ? "n" : "_") + std::to_string(i);
    return unique;
}

std::string replaceGlobals(const Rewritten& source, const RawGlsl& raw, const Tokens& tokens,
                           Edits& edits, Translation& translation) {
    std::vector<std::string> taken;
    std::vector<std::size_t> indexOfMember(raw.members.size(), source.parameters.size());
    for (const SourceParameter& known : source.parameters) {
        Parameter parameter = known.parameter;
        parameter.glslName = glslNameFor("u_", parameter.name, taken);
        taken.push_back(parameter.glslName);
        const auto member = std::find(raw.members.begin(), raw.members.end(), known.hlslName);
        if (member != raw.members.end())
            indexOfMember[static_cast<std::size_t>(member - raw.members.begin())] =
                translation.parameters.size();
        translation.parameters.push_back(std::move(parameter));
    }
    for (std::size_t at = 0; at + 2 < tokens.size(); ++at) {
        if (!tokens[at].is(GlobalsName) || !tokens[at + 1].is(".")) continue;
        const auto member = memberOf(tokens[at + 2].text);
        if (!member || *member >= indexOfMember.size()) continue;
        const std::size_t index = indexOfMember[*member];
        if (index >= translation.parameters.size()) continue;
        Parameter& parameter = translation.parameters[index];
        parameter.used = true;
        replaceUse(parameter, layoutOf(parameter), at, tokens, edits);
    }
    std::string declarations;
    for (const Parameter& parameter : translation.parameters) {
        if (!parameter.used) continue;
        const Layout layout = layoutOf(parameter);
        declarations += "uniform " + layout.type + ' ' + parameter.glslName + layout.array + ";\n";
    }
    return declarations;
}

} // namespace Lixel::Cg

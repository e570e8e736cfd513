#include "cg/translation/GlslInterface.h"

#include "cg/translation/Semantics.h"

#include <algorithm>
#include <unordered_set>

namespace Lixel::Cg {
namespace {

constexpr unsigned LegacyTexCoords = 8; ///< gl_TexCoord of OpenGL 2.1, at least
constexpr unsigned MostColours = 8;

/// float, ivec3 and so on.
std::string vectorType(InterfaceVariable::Base base, unsigned components) {
    const bool scalar = components == 1;
    switch (base) {
    case InterfaceVariable::Base::Float: {
        if (scalar) return "float";
        break;
    }
    case InterfaceVariable::Base::Int:
        return scalar ? "int" : "ivec" + std::to_string(components);
    case InterfaceVariable::Base::Bool:
        return scalar ? "bool" : "bvec" + std::to_string(components);
    }
    return "vec" + std::to_string(components);
}

/// The first components of a vector of four.
std::string swizzled(const std::string& vector, unsigned components) {
    return components == 4 ? vector : vector + '.' + std::string("xyz").substr(0, components);
}

/// A vector of floats of four components as what a variable holds.
std::string converted(const InterfaceVariable& variable, const std::string& vector) {
    const std::string part = swizzled(vector, variable.components);
    const std::string type = vectorType(variable.base, variable.components);
    switch (variable.base) {
    case InterfaceVariable::Base::Float:
        return part;
    case InterfaceVariable::Base::Int:
        return type + "(floor(" + part + " + 0.5))";
    case InterfaceVariable::Base::Bool:
        return type + '(' + part + ')';
    }
    return part;
}

/// What a variable holds as a vector of four floats; what is missing is 0, and 1 in w.
std::string widened(const InterfaceVariable& variable, const std::string& part) {
    if (variable.base == InterfaceVariable::Base::Float && variable.components == 4) return part;
    constexpr const char* Rest[] = {"", ", 0.0, 0.0, 1.0)", ", 0.0, 1.0)", ", 1.0)", ")"};
    const std::string floats =
        variable.base == InterfaceVariable::Base::Float
            ? part
            : (variable.components == 1 ? "float" : "vec" + std::to_string(variable.components)) +
                  '(' + part + ')';
    return "vec4(" + floats + Rest[variable.components];
}

/// The vectors of a variable: elements of an array, columns of a matrix. With each, the index of
/// the semantic is one more.
std::vector<std::string> partsOf(const InterfaceVariable& variable) {
    std::vector<std::string> parts;
    for (unsigned element = 0; element < std::max(variable.elements, 1u); ++element) {
        const std::string name = variable.elements == 0
                                     ? variable.variable
                                     : variable.variable + '[' + std::to_string(element) + ']';
        for (unsigned column = 0; column < variable.columns; ++column)
            parts.push_back(variable.columns == 1 ? name
                                                  : name + '[' + std::to_string(column) + ']');
    }
    return parts;
}

class InterfaceWriter {
public:
    InterfaceWriter(const Request& request, const RawGlsl& raw) : mRequest(request), mRaw(raw) {}

    GlslInterface write() {
        for (const InterfaceVariable& variable : mRaw.inputs)
            writeVariable(variable, false);
        for (const InterfaceVariable& variable : mRaw.outputs)
            writeVariable(variable, true);
        return std::move(mResult);
    }

private:
    bool isLegacy() const { return mRequest.glslVersion < 130; }
    bool isVertex() const { return mRequest.stage == Stage::Vertex; }

    void tell(Message::Kind kind, std::string text) {
        mResult.messages.push_back({kind, {}, 0, std::move(text)});
    }

    void writeVariable(const InterfaceVariable& variable, bool isOutput) {
        mResult.declarations += declarationOf(variable) + ";\n";
        if (variable.semantic.empty()) {
            tell(Message::Kind::Error, std::string(isOutput ? "an output" : "an input") +
                                           " of the entry point has no semantic");
            return;
        }
        Semantic semantic = semanticOf(variable.semantic);
        const std::vector<std::string> parts = partsOf(variable);
        semantic.index += variable.element * static_cast<unsigned>(parts.size());
        for (const std::string& part : parts) {
            if (isOutput) {
                writeOutput(variable, semantic, part);
            } else {
                mResult.readInputs +=
                    "    " + part + " = " + converted(variable, input(semantic)) + ";\n";
            }
            ++semantic.index;
        }
    }

    void declare(const char* qualifier, const std::string& name) {
        if (mDeclared.insert(name).second)
            mResult.declarations += std::string(qualifier) + " vec4 " + name + ";\n";
    }

    /// Where an input comes from, as a vector of four floats.
    std::string input(const Semantic& semantic) {
        if (isVertex()) {
            const auto attribute = attributeOf(semantic);
            if (!attribute) {
                tell(Message::Kind::Error,
                     "OGRE has no vertex element for the input '" + semantic.name() + '\'');
                return "vec4(0.0)";
            }
            if (mDeclared.count(*attribute) == 0) mResult.attributes.push_back(*attribute);
            declare(isLegacy() ? "attribute" : "in", *attribute);
            return *attribute;
        }
        if (semantic.is("WPOS") || semantic.is("POSITION")) return "gl_FragCoord";
        if (semantic.is("VPOS")) {
            tell(Message::Kind::Warning, "VPOS counts rows from the bottom in OpenGL");
            return "vec4(gl_FragCoord.xy - 0.5, gl_FragCoord.zw)";
        }
        if (semantic.is("VFACE")) return "vec4(gl_FrontFacing ? 1.0 : -1.0)";
        // A structure of both stages has it; nothing passes it on.
        if (semantic.is("PSIZE")) return "vec4(1.0)";
        return varying(semantic, false);
    }

    /// The name of a varying, which is declared. For OpenGL 2.1 it is one of those that OpenGL's
    /// fixed functions write and read, so that either program works without the other.
    std::string varying(const Semantic& semantic, bool isOutput) {
        if (isLegacy()) {
            if (semantic.is("TEXCOORD") && semantic.index < LegacyTexCoords)
                return "gl_TexCoord[" + std::to_string(semantic.index) + ']';
            if (semantic.is("COLOR") && semantic.index < 2) {
                const bool second = semantic.index == 1;
                if (isOutput) return second ? "gl_FrontSecondaryColor" : "gl_FrontColor";
                return second ? "gl_SecondaryColor" : "gl_Color";
            }
            if (semantic.is("FOG")) return isOutput ? "gl_FogFragCoord" : "vec4(gl_FogFragCoord)";
        }
        std::string name = "v_" + semantic.name();
        declare(isLegacy() ? "varying" : isOutput ? "out" : "in", name);
        return name;
    }

    void writeOutput(const InterfaceVariable& variable, const Semantic& semantic,
                     const std::string& part) {
        if (!mWritten.insert(semantic.name()).second)
            tell(Message::Kind::Error, "two outputs have the semantic '" + semantic.name() + '\'');
        const std::string value = widened(variable, part);
        std::string target;
        if (isVertex()) {
            writeVertexOutput(semantic, value);
        } else if (semantic.is("COLOR") && semantic.index < MostColours) {
            if (isLegacy()) {
                target = "gl_FragData[" + std::to_string(semantic.index) + ']';
            } else {
                target = "f_" + semantic.name();
                mResult.declarations += "layout(location = " + std::to_string(semantic.index) +
                                        ") out vec4 " + target + ";\n";
            }
            mResult.writeOutputs += "    " + target + " = " + value + ";\n";
        } else if (semantic.is("DEPTH")) {
            mResult.writeOutputs += "    gl_FragDepth = (" + value + ").x;\n";
        } else {
            tell(Message::Kind::Error,
                 "a fragment program cannot write '" + semantic.name() + '\'');
        }
    }

    void writeVertexOutput(const Semantic& semantic, const std::string& value) {
        if (semantic.is("POSITION")) {
            mResult.writeOutputs += "    gl_Position = " + value + ";\n";
            return;
        }
        if (semantic.is("PSIZE")) {
            mResult.writeOutputs += "    gl_PointSize = (" + value + ").x;\n";
            return;
        }
        const std::string target = varying(semantic, true);
        const bool isFog = target == "gl_FogFragCoord";
        const bool clamp = mRequest.clampColours && semantic.is("COLOR");
        mResult.writeOutputs += "    " + target + " = " + (clamp ? "clamp(" : "") +
                                (isFog ? "(" + value + ").x" : value) +
                                (clamp ? ", 0.0, 1.0)" : "") + ";\n";
    }

    const Request& mRequest;
    const RawGlsl& mRaw;
    GlslInterface mResult;
    std::unordered_set<std::string> mDeclared;
    std::unordered_set<std::string> mWritten;
};

} // namespace

std::string declarationOf(const InterfaceVariable& variable) {
    const bool isMatrix = variable.columns > 1;
    const std::string type = isMatrix ? "mat" + std::to_string(variable.columns) + 'x' +
                                            std::to_string(variable.components)
                                      : vectorType(variable.base, variable.components);
    const std::string array =
        variable.elements == 0 ? "" : '[' + std::to_string(variable.elements) + ']';
    return type + ' ' + variable.variable + array;
}

GlslInterface interfaceOf(const Request& request, const RawGlsl& raw) {
    return InterfaceWriter(request, raw).write();
}

} // namespace Lixel::Cg

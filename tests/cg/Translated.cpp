#include "Translated.h"

#include <gtest/gtest.h>

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

namespace Lixel::Tests {

Cg::Request requestOf(const Source& source) {
    Cg::Request request;
    request.language = source.language;
    request.columnMajor = source.language == Cg::Language::Hlsl;
    request.stage = source.stage;
    request.source = source.text;
    request.file = "test.cg";
    request.glslVersion = source.glslVersion;
    request.readInclude =
        [includes = source.includes](const std::string& name) -> std::optional<std::string> {
        const auto found = includes.find(name);
        if (found == includes.end()) return {};
        return found->second;
    };
    return request;
}

Cg::Translation translated(const Source& source) {
    const Cg::Translation translation = translate(requestOf(source));
    const Cg::Message* error = firstError(translation.messages);
    EXPECT_EQ(error, nullptr) << (error == nullptr ? "" : toString(*error));
    if (error == nullptr) {
        EXPECT_EQ(problemOf(translation.glsl, source.stage), "") << translation.glsl;
    }
    return translation;
}

std::string errorOf(const Source& source) {
    const Cg::Translation translation = translate(requestOf(source));
    const Cg::Message* error = firstError(translation.messages);
    EXPECT_EQ(translation.succeeded(), error == nullptr);
    return error == nullptr ? "" : toString(*error);
}

Cg::Parameter parameterOf(const Cg::Translation& translation, const std::string& name) {
    for (const Cg::Parameter& parameter : translation.parameters)
        if (parameter.name == name) return parameter;
    ADD_FAILURE() << "no parameter " << name;
    return {};
}

std::string problemOf(const std::string& glsl, Cg::Stage stage) {
    static const bool started = glslang::InitializeProcess();
    (void)started;
    glslang::TShader shader(stage == Cg::Stage::Vertex ? EShLangVertex : EShLangFragment);
    const char* const text = glsl.c_str();
    shader.setStrings(&text, 1);
    if (shader.parse(GetDefaultResources(), 110, false, EShMsgDefault)) return {};
    return shader.getInfoLog();
}

} // namespace Lixel::Tests

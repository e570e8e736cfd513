// lixel-shaderc FILE --entry NAME --profile P: what Plugin_LixelCg makes of a Cg or HLSL program,
// for people who port programs, or who look for what is wrong with one.

#include "cg/translation/Profile.h"
#include "cg/translation/Translate.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace {

using namespace Lixel::Cg;

std::optional<std::string> textOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file || std::filesystem::is_directory(path)) return {};
    return std::string(std::istreambuf_iterator<char>(file), {});
}

std::string typeOf(const Parameter& parameter) {
    std::string type = parameter.base == Parameter::Base::Float ? "float" : "int";
    if (parameter.rows > 1) {
        type += fmt::format("{}x{}", parameter.rows, parameter.columns);
    } else if (parameter.columns > 1) {
        type += std::to_string(parameter.columns);
    }
    if (parameter.elements > 0) type += fmt::format("[{}]", parameter.elements);
    return type;
}

/// What a script can set, as comments after the program.
void printParameters(const Translation& translation) {
    for (const Parameter& parameter : translation.parameters) {
        fmt::print("// parameter {} {}", typeOf(parameter), parameter.name);
        if (parameter.used) {
            fmt::print(": {}", parameter.glslName);
        } else {
            fmt::print(" is not used");
        }
        for (std::size_t i = 0; i < parameter.defaults.size(); ++i)
            fmt::print("{} {}", i == 0 ? "; default" : "", parameter.defaults[i]);
        fmt::print("\n");
    }
    for (const Sampler& sampler : translation.samplers)
        fmt::print("// texture unit {}: {} {}: {}\n", sampler.unit, sampler.glslType, sampler.name,
                   sampler.glslName);
    for (const std::string& attribute : translation.attributes)
        fmt::print("// vertex attribute {}\n", attribute);
}

/// "NAME=VALUE", or "NAME", which is 1.
Define defineOf(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) return {text, "1"};
    return {text.substr(0, equals), text.substr(equals + 1)};
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{
        "Translates a Cg or HLSL program to GLSL, as Plugin_LixelCg does, and prints it with "
        "the parameters that scripts can set."};
    std::string file;
    std::string profileName;
    std::string language;
    std::vector<std::string> defines;
    std::vector<std::string> folders;
    Request request;
    app.add_option("FILE", file, "the program's source")->required();
    app.add_option("--entry", request.entry, "the function to start at")->capture_default_str();
    app.add_option("--profile", profileName, "such as arbvp1 or ps_2_0")->required();
    app.add_option("--language", language, "cg or hlsl; else the file's extension says it")
        ->check(CLI::IsMember({"cg", "hlsl"}));
    app.add_option("--glsl", request.glslVersion, "330 for GL3+, 120 for the older GL")
        ->check(CLI::IsMember({330, 120}))
        ->capture_default_str();
    app.add_option("-D,--define", defines, "NAME or NAME=VALUE, defined before the source");
    app.add_option("-I,--include", folders, "a folder of included files, besides the source's");
    CLI11_PARSE(app, argc, argv);

    const auto profile = profileOf(profileName);
    if (!profile) {
        fmt::print(stderr, "lixel-shaderc: the profile '{}' is not known\n", profileName);
        return 1;
    }
    const auto source = textOf(file);
    if (!source) {
        fmt::print(stderr, "lixel-shaderc: cannot read {}\n", file);
        return 1;
    }
    const std::filesystem::path path = file;
    const bool isHlsl = language.empty() ? path.extension() == ".hlsl" : language == "hlsl";
    request.language = isHlsl ? Language::Hlsl : Language::Cg;
    request.columnMajor = isHlsl;
    request.stage = profile->stage;
    request.profile = profile->name;
    request.clampColours = profile->clampColours;
    request.source = *source;
    request.file = path.filename().string();
    for (const std::string& define : defines)
        request.defines.push_back(defineOf(define));
    folders.insert(folders.begin(), path.parent_path().string());
    request.readInclude = [&](const std::string& name) -> std::optional<std::string> {
        for (const std::string& folder : folders)
            if (auto text = textOf(std::filesystem::path(folder) / name)) return text;
        return {};
    };

    const Translation translation = translate(request);
    fmt::print("{}", translation.glsl);
    if (translation.succeeded()) printParameters(translation);
    for (const Message& message : translation.messages)
        fmt::print(stderr, "{}\n", toString(message));
    return translation.succeeded() ? 0 : 1;
}

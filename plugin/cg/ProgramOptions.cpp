#include "cg/ProgramOptions.h"

#include <algorithm>
#include <sstream>

namespace Lixel::Cg {
namespace {

std::vector<std::string> wordsOf(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
        words.push_back(word);
    return words;
}

void addDefine(std::string text, std::vector<Define>& defines) {
    const auto isSpace = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
    while (!text.empty() && isSpace(text.front()))
        text.erase(text.begin());
    while (!text.empty() && isSpace(text.back()))
        text.pop_back();
    if (text.empty()) return;
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
        defines.push_back({text, "1"});
    } else {
        defines.push_back({text.substr(0, equals), text.substr(equals + 1)});
    }
}

} // namespace

std::optional<Profile> chosenProfile(const ProgramOptions& options, Language language,
                                     Stage stage) {
    auto names = wordsOf(options.profiles);
    if (names.empty() && language == Language::Hlsl)
        names.push_back(stage == Stage::Vertex ? "vs_2_0" : "ps_2_0");
    for (const std::string& name : names) {
        const auto profile = profileOf(name);
        if (profile && profile->stage == stage) return profile;
    }
    return {};
}

int shaderModelOf(const ProgramOptions& options) {
    int lowest = 0;
    for (const std::string& name : wordsOf(options.profiles)) {
        if (!profileOf(name)) continue;
        const bool isDirect3D = name.starts_with("vs_") || name.starts_with("ps_");
        const int model = isDirect3D ? std::max(3, name[3] - '0') : 3;
        lowest = lowest == 0 ? model : std::min(lowest, model);
    }
    return std::max(lowest, 3);
}

std::vector<Define> definesOf(const std::string& text, std::vector<std::string>& ignored) {
    std::vector<Define> defines;
    const auto words = wordsOf(text);
    if (words.empty()) return defines;
    if (!words.front().starts_with('-')) {
        std::string rest = text;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find_first_of(";,"), rest.size());
            addDefine(rest.substr(0, end), defines);
            rest.erase(0, end + 1);
        }
        return defines;
    }
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "-D" && i + 1 < words.size()) {
            addDefine(words[++i], defines);
        } else if (words[i].starts_with("-D")) {
            addDefine(words[i].substr(2), defines);
        } else {
            ignored.push_back(words[i]);
        }
    }
    return defines;
}

} // namespace Lixel::Cg

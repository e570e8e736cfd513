#include "script/PresetSettings.h"

#include "fit/problem/Option.h"
#include "scene/NameList.h"
#include "setup/SetupList.h"

#include <OgrePixelFormat.h>

#include <algorithm>
#include <array>
#include <vector>

namespace Lixel {
namespace {

using Text = std::optional<std::string>;

/// Room for one value of each type.
struct Value {
    int count = 0;
    double number = 0.0;
    bool flag = false;
};

Text readOption(const Option& declared, std::string_view text) {
    Value value;
    if (!setOption(declared, &value, text).empty()) return std::nullopt;
    return optionText(declared, &value);
}

template <int Least, int Greatest>
Text readCount(std::string_view text) {
    return readOption(option<&Value::count>("", between(Least, Greatest), "", ""), text);
}

Text readDistance(std::string_view text) {
    return readOption(option<&Value::number>("", atLeast(0.0), "", ""), text);
}

Text readFlag(std::string_view text) {
    return readOption(option<&Value::flag>("", ""), text);
}

/// One side for both, or width and height.
Text readSize(std::string_view text) {
    constexpr auto readSide = readCount<16, 16384>;
    const std::size_t space = text.find(' ');
    const Text width = readSide(text.substr(0, space));
    const Text height = space == std::string_view::npos ? width : readSide(text.substr(space + 1));
    if (!width || !height) return std::nullopt;
    return *width + " " + *height;
}

/// Formats that hold a depth. Others may be read by materials of the user's own.
Text readFormat(std::string_view text) {
    const Ogre::PixelFormat format = Ogre::PixelUtil::getFormatFromName(std::string(text));
    if (format == Ogre::PF_UNKNOWN) return std::nullopt;
    return Ogre::PixelUtil::getFormatName(format);
}

template <const auto& Words>
Text readWord(std::string_view text) {
    const auto found = std::ranges::find(Words, text);
    return found == std::end(Words) ? Text() : Text(std::string(*found));
}

constexpr std::array<std::string_view, 4> Techniques{
    "texture_additive", "texture_additive_integrated", "texture_modulative",
    "texture_modulative_integrated"};
constexpr std::array<std::string_view, 2> Filters{"nearest", "bilinear"};

Text readKind(std::string_view text) {
    return findSetupKind(text) == nullptr ? Text() : Text(std::string(text));
}

Text readSliceKind(std::string_view text) {
    return text == "Cascades" ? std::nullopt : readKind(text);
}

Text readName(std::string_view text) {
    return text.empty() ? Text() : Text(std::string(text));
}

/// Names of all setups, in a text that lives on.
std::string_view kindNames(bool withCascades) {
    const auto join = [](bool isWithCascades) {
        std::vector<std::string> names;
        for (const SetupKind& kind : setupKinds())
            if (isWithCascades || kind.name != "Cascades") names.emplace_back(kind.name);
        return "one of " + joinNames(names);
    };
    static const std::string all = join(true);
    static const std::string single = join(false);
    return withCascades ? all : single;
}

} // namespace

std::span<const PresetSetting> presetSettings() {
    static const std::array settings{
        PresetSetting{"technique", kindNames(true), "XPSM",
                      "which setup: the name before ShadowCameraSetup", readKind},
        PresetSetting{"slices", kindNames(false), "Optimal",
                      "of Cascades: the setup of each slice; its options stand beside those of "
                      "Cascades",
                      readSliceKind},
        PresetSetting{"maps", "a whole number, at least 1 and at most 8", "",
                      "shadow maps of each light of that type; several need an integrated "
                      "shadow_technique; without it, one, or three for Cascades",
                      readCount<1, 8>},
        PresetSetting{"map_size",
                      "one or two whole numbers of texels, at least 16 and at most 16384",
                      "1024 1024", "side of a map, or its width and height", readSize},
        PresetSetting{"map_format", "one of OGRE's pixel formats, such as PF_FLOAT32_R",
                      "PF_FLOAT32_R", "format of a map; Lixel's materials read PF_FLOAT32_R",
                      readFormat},
        PresetSetting{"shadow_technique",
                      "one of texture_additive, texture_additive_integrated, texture_modulative, "
                      "texture_modulative_integrated",
                      "texture_additive_integrated", "OGRE's shadow technique",
                      readWord<Techniques>},
        PresetSetting{"filter", "one of nearest, bilinear", "bilinear",
                      "which of Lixel's receivers draws shadows, where receiver_material does not "
                      "say it; surfaces under integrated techniques choose their own",
                      readWord<Filters>},
        PresetSetting{"far_distance", "a number of world units, at least 0", "",
                      "how far from the viewer there are shadows; 0: up to the far plane",
                      readDistance},
        PresetSetting{"self_shadow", "true or false", "true",
                      "whether what casts shadows receives them too", readFlag},
        PresetSetting{
            "caster_material", "the name of a material, or none", "Lixel/Caster",
            "the scene manager's caster; none: OGRE's own, which GL3Plus draws through the shader "
            "system alone",
            readName},
        PresetSetting{"receiver_material", "the name of a material, or none", "",
                      "the scene manager's receiver, which integrated techniques do not use; "
                      "without it, the one of Lixel's that fits shadow_technique and filter",
                      readName},
    };
    return settings;
}

const PresetSetting* findPresetSetting(std::string_view keyword) {
    const auto found = std::ranges::find(presetSettings(), keyword, &PresetSetting::keyword);
    return found == presetSettings().end() ? nullptr : &*found;
}

std::string settingOf(const SettingValues& values, std::string_view keyword) {
    const auto found = values.find(keyword);
    return found != values.end() ? found->second
                                 : std::string(findPresetSetting(keyword)->standard);
}

} // namespace Lixel

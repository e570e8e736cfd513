#include "script/PresetSettings.h"

#include "fit/problem/Option.h"
#include "scene/NameList.h"
#include "script/PresetWords.h"
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

template <const Option& Declared>
Text readAs(std::string_view text) {
    return readOption(Declared, text);
}

constexpr Option Maps = option<&Value::count>("", between(1, 8), "", "");
constexpr Option Side = option<&Value::count>("", between(16, 16384), "texels", "");
constexpr Option Flag = option<&Value::flag>("", "");
constexpr Option NoDistance = option<&Value::number>("", between(0.0, 0.0), "", "");
/// OGRE squares it in single precision: the square is neither 0 nor infinite.
constexpr Option Distance = option<&Value::number>("", between(1e-18, 1e18), "world units", "");

Text readDistance(std::string_view text) {
    const Text none = readOption(NoDistance, text);
    return none ? none : readOption(Distance, text);
}

/// One side for both, or width and height.
Text readSize(std::string_view text) {
    const std::size_t space = text.find(' ');
    const Text width = readOption(Side, text.substr(0, space));
    const Text height =
        space == std::string_view::npos ? width : readOption(Side, text.substr(space + 1));
    if (!width || !height) return std::nullopt;
    return *width + " " + *height;
}

std::string describeSizes() {
    return "one or two whole numbers" +
           describeValues(Side).substr(std::string_view("a whole number").size());
}

/// Any OGRE format; Lixel's materials need PF_FLOAT32_R.
Text readFormat(std::string_view text) {
    const Ogre::PixelFormat format = Ogre::PixelUtil::getFormatFromName(std::string(text));
    if (format == Ogre::PF_UNKNOWN) return std::nullopt;
    return Ogre::PixelUtil::getFormatName(format);
}

constexpr auto Techniques = [] {
    std::array<std::string_view, ShadowTechniqueWords.size()> names;
    std::ranges::transform(ShadowTechniqueWords, names.begin(), &ShadowTechniqueWord::name);
    return names;
}();
constexpr std::array<std::string_view, 2> Filters{"nearest", "bilinear"};

template <const auto& Words>
Text readWord(std::string_view text) {
    const auto found = std::ranges::find(Words, text);
    return found == std::end(Words) ? Text() : Text(std::string(*found));
}

std::string oneOf(std::span<const std::string_view> words) {
    return "one of " + joinNames(words);
}

Text readKind(std::string_view text) {
    return findSetupKind(text) == nullptr ? Text() : Text(std::string(text));
}

Text readSliceKind(std::string_view text) {
    return text == CascadesWord ? std::nullopt : readKind(text);
}

Text readName(std::string_view text) {
    return text.empty() ? Text() : Text(std::string(text));
}

std::string kindNames(bool withCascades) {
    std::vector<std::string_view> names;
    for (const SetupKind& kind : setupKinds())
        if (withCascades || kind.name != CascadesWord) names.push_back(kind.name);
    return oneOf(names);
}

std::string materialNames() {
    return "the name of a material, or " + std::string(NoMaterialWord);
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
        PresetSetting{
            "maps", describeValues(Maps), "",
            "shadow maps of each light of that type; several need an integrated "
            "shadow_technique; without it, three for Cascades, and else as many as others "
            "of that type say, or one",
            readAs<Maps>},
        PresetSetting{"map_size", describeSizes(), "1024 1024",
                      "side of a map, or its width and height", readSize},
        PresetSetting{"map_format", "one of OGRE's pixel formats, such as PF_FLOAT32_R",
                      "PF_FLOAT32_R", "format of a map; Lixel's materials read PF_FLOAT32_R",
                      readFormat},
        PresetSetting{"shadow_technique", oneOf(Techniques), "texture_additive_integrated",
                      "OGRE's shadow technique", readWord<Techniques>},
        PresetSetting{"filter", oneOf(Filters), "bilinear",
                      "filtering of Lixel's default receiver; has no effect with receiver_material "
                      "or an integrated technique",
                      readWord<Filters>},
        PresetSetting{"far_distance", "0, or " + describeValues(Distance), "",
                      "how far from the viewer there are shadows; 0: up to the far plane",
                      readDistance},
        PresetSetting{"self_shadow", describeValues(Flag), "true",
                      "whether what casts shadows receives them too", readAs<Flag>},
        PresetSetting{
            "caster_material", materialNames(), "Lixel/Caster",
            "the scene manager's caster; none: OGRE's own, which GL3Plus draws through the shader "
            "system alone",
            readName},
        PresetSetting{"receiver_material", materialNames(), "",
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

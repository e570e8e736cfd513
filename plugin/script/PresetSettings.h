#pragma once

#include "fit/geometry/Types.h"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace Lixel {

/// A keyword of shadow_camera_setup scripts, beside those of a technique's options.
struct PresetSetting {
    std::string_view keyword;
    /// Describes the values that it takes: "a whole number, at least 1 and at most 8".
    std::string values;
    /// Default value; empty means OGRE's value is left unchanged.
    std::string_view standard;
    /// What it does, in one line.
    std::string_view use;
    /// The value in its one spelling; none where the text is not valid.
    std::optional<std::string> (*read)(std::string_view text);
};

/// All of them: what belongs to a light and its maps, and not to a technique.
LIXEL_API std::span<const PresetSetting> presetSettings();

/// That keyword's; null where there is none.
const PresetSetting* findPresetSetting(std::string_view keyword);

/// What scripts say of settings: values by keyword, as PresetSetting::read spells them.
using SettingValues = std::map<std::string, std::string, std::less<>>;

/// A setting's value, or its standard.
std::string settingOf(const SettingValues& values, std::string_view keyword);

} // namespace Lixel

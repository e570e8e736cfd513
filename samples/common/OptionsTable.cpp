#include "common/OptionsTable.h"

#include <Lixel/script/PresetSettings.h>
#include <Lixel/setup/SetupList.h>

#include <fmt/core.h>

namespace Lixel::Samples {
namespace {

/// @param label of the first row
void addRows(std::string label, std::span<const Option> options,
             const FittedShadowCameraSetup& setup, std::string& table) {
    for (const Option& option : options) {
        const std::string keyword(option.keyword);
        const std::string value = setup.getParameter(keyword);
        table += fmt::format("| {} | `{}` | {} | {} | {} |\n", label, keyword,
                             describeValues(option), value.empty() ? "none" : value, option.use);
        label.clear();
    }
}

} // namespace

std::string optionsTable() {
    std::string table = "| setup | option | values | default | |\n|---|---|---|---|---|\n";
    addRows("all of these", CommonOptions::declared(), *setupKinds().front().create(), table);
    for (const SetupKind& kind : setupKinds())
        addRows(fmt::format("`{}ShadowCameraSetup`", kind.name), kind.options, *kind.create(),
                table);
    return table;
}

std::string settingsTable() {
    std::string table = "| keyword | values | default | |\n|---|---|---|---|\n";
    for (const PresetSetting& setting : presetSettings())
        table += fmt::format("| `{}` | {} | {} | {} |\n", setting.keyword, setting.values,
                             setting.standard.empty() ? "–" : setting.standard, setting.use);
    return table;
}

} // namespace Lixel::Samples

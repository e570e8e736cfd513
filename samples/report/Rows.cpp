#include "report/Rows.h"

#include "common/Names.h"

#include <Lixel/setup/SetupList.h>
#include <Lixel/setup/ShadowCameraSetups.h>

#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace Lixel::Samples {
namespace {

bool isForSlices(const std::string& assignment) {
    const std::string_view keyword = std::string_view(assignment).substr(0, assignment.find('='));
    return findOption(CascadeOptions::declared(), keyword) == nullptr &&
           findOption(CommonOptions::declared(), keyword) == nullptr;
}

} // namespace

NamedSetup rowOf(const std::string& text) {
    std::istringstream words(text);
    std::string name;
    words >> name;
    const NamedSetup* const setup = findEmulatedSetup(name);
    if (setup == nullptr)
        throw std::invalid_argument(noneOfThatName("setup", name, emulatedSetups()));
    const bool hasSlices = name.starts_with("Cascades-");
    std::vector<std::string> own;
    std::vector<std::string> ofSlices;
    for (std::string word; words >> word;)
        (hasSlices && isForSlices(word) ? ofSlices : own).push_back(word);

    NamedSetup row = *setup;
    if (hasSlices) {
        const NamedSetup& slice = *findEmulatedSetup("Optimal");
        std::string wrong = wrongAssignment(slice, ofSlices);
        if (!wrong.empty()) throw std::invalid_argument(wrong);
        row.create = [create = withOptions(slice, ofSlices).create] {
            return CascadesShadowCameraSetup::create(create());
        };
    } else if (std::string wrong = wrongAssignment(row, own); !wrong.empty()) {
        throw std::invalid_argument(wrong);
    }
    row = withOptions(row, own);
    row.name = text;
    return row;
}

} // namespace Lixel::Samples

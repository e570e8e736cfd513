#pragma once

#include <string>
#include <vector>

namespace Lixel::Samples {

/// What to tell a user who named nothing that there is: "there is no setup 'X'; there are: A, B".
/// @param kind what it should have been, such as "setup"
/// @param all have a `name` each
template <typename Named>
std::string noneOfThatName(const std::string& kind, const std::string& name,
                           const std::vector<Named>& all) {
    std::string text = "there is no " + kind + " '" + name + "'; there are: ";
    for (const Named& one : all)
        text += (&one == &all.front() ? "" : ", ") + one.name;
    return text;
}

} // namespace Lixel::Samples

#pragma once

#include <nlohmann/json.hpp>

#include <fstream>
#include <stdexcept>
#include <string>

namespace Lixel::Tests {

/// Writes numbers into a file, if one is named.
/// @exception std::runtime_error where it cannot be written
inline void writeJson(const nlohmann::json& json, const std::string& name) {
    if (name.empty()) return;
    std::ofstream file(name);
    file << json.dump(1) << '\n';
    if (!file) throw std::runtime_error("cannot write " + name);
}

} // namespace Lixel::Tests

#pragma once

#include "BenchBuild.h"
#include "BenchFrames.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace Lixel::Tests {

/// For people, on the standard output.
void print(const std::vector<FrameRow>& rows);
void print(const std::vector<BuildRow>& rows);

/// For programs: an object a row.
nlohmann::json toJson(const std::vector<FrameRow>& rows);
nlohmann::json toJson(const std::vector<BuildRow>& rows);

} // namespace Lixel::Tests

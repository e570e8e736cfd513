#pragma once

#include <string>
#include <vector>

/// Where a walk was when OGRE aborted the process, on the standard error output.
namespace Lixel::Tests::LastWords {

/// A walk begins; its deeds are read when the process ends.
void begin(const std::string& walk, const std::vector<std::string>& deeds);
/// What is done now; has to outlive the step.
void say(const char* deed);
/// A walk has ended.
void forget();

} // namespace Lixel::Tests::LastWords

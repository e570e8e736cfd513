#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace Lixel::Samples {

/// Notices when files of an OGRE resource group are edited on disk.
class FileWatch {
public:
    /// @param group whose files lie in folders
    explicit FileWatch(std::string group);

    /// Whether any file has changed since the last time this was true. It waits for a file that is
    /// still being written: until it stays the same from one call to the next.
    bool changed();

private:
    using Times = std::map<std::filesystem::path, std::filesystem::file_time_type>;
    Times look() const;

    std::string mGroup;
    Times mKnown; ///< when it was last true
    Times mLast;  ///< at the last call
};

} // namespace Lixel::Samples

#pragma once

#include "cg/translation/CacheEntry.h"
#include "cg/translation/Request.h"
#include "cg/translation/Translation.h"

#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>

namespace Lixel::Cg {

/// Translations that have been made, in memory and, where there is a folder for it, on disk.
///
/// One is found again by all that it was made of: the request, the texts of the files that it
/// includes, and the versions of the translator. Those with errors are not kept. For several
/// threads, and a folder for several processes, at once.
class TranslationCache {
public:
    /// Where translations are kept on disk; it is made where it does not exist. Empty, as it is at
    /// first: nowhere.
    void setFolder(const std::filesystem::path& folder);
    std::filesystem::path folder() const;

    /// What was made of the same before, or else a new translation. Nothing is thrown.
    Translation translate(const Request& request);

    /// What has become of the requests so far.
    struct Counts {
        unsigned inMemory = 0;
        unsigned onDisk = 0;
        unsigned made = 0;
    };
    Counts counts() const;

    /// Whether a translation could not be written to the folder. Says so once for each folder.
    bool takeFailedFolder();

private:
    std::optional<Translation> findInMemory(const std::string& key, const Request& request);
    void keepInMemory(CacheEntry entry);

    mutable std::mutex mMutex;
    std::filesystem::path mFolder;
    std::unordered_map<std::string, CacheEntry> mEntries;
    std::deque<std::string> mOrder; ///< keys, the oldest first
    std::size_t mBytes = 0;
    Counts mCounts;
    enum class Folder { Good, Failed, FailedAndTold } mState = Folder::Good;
};

} // namespace Lixel::Cg

#pragma once

#include "cg/translation/Preprocess.h"
#include "cg/translation/Request.h"
#include "cg/translation/Translation.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace Lixel::Cg {

/// A translation and all that it was made of.
struct CacheEntry {
    std::string key; ///< keyOf the request
    std::vector<IncludedFile> includes;
    Translation translation;

    /// Bytes of its texts, about.
    std::size_t size() const;
};

/// All of a request that its translation depends on, the files that it includes apart, and the
/// versions of the translator and its libraries.
std::string keyOf(const Request& request);

/// Whether the files that were included are still the same.
bool hasSameIncludes(const CacheEntry& entry, const Request& request);

/// 64 bits that tell texts apart, well enough for names of files and for broken files.
std::uint64_t hashOf(std::string_view text);

/// What a file holds: a header with a checksum, and the entry.
std::string toFile(const CacheEntry& entry);

/// The entry that a file holds. Nothing if it is another's, of another version, or broken.
std::optional<CacheEntry> fromFile(std::string_view file);

} // namespace Lixel::Cg

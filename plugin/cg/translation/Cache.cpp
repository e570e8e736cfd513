#include "cg/translation/Cache.h"

#include "cg/translation/Translate.h"

#include <unistd.h>

#include <atomic>
#include <fstream>
#include <iterator>

namespace Lixel::Cg {
namespace {

/// Beyond it the oldest go.
constexpr std::size_t MostBytesInMemory = 32u << 20;

std::filesystem::path fileFor(const std::filesystem::path& folder, const std::string& key) {
    constexpr char Digits[] = "0123456789abcdef";
    std::string name;
    for (std::uint64_t hash = hashOf(key), i = 0; i < 16; ++i, hash >>= 4)
        name += Digits[hash & 15];
    return folder / (name + ".lixelcg");
}

std::optional<CacheEntry> readFromDisk(const std::filesystem::path& folder,
                                       const std::string& key) {
    std::ifstream file(fileFor(folder, key), std::ios::binary);
    if (!file) return {};
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    auto entry = fromFile(bytes);
    if (!entry || entry->key != key) return {};
    return entry;
}

/// Under another name first: who reads at the same time reads the whole or nothing.
bool writeToDisk(const std::filesystem::path& folder, const CacheEntry& entry) {
    static std::atomic<unsigned> count = 0;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const auto path = fileFor(folder, entry.key);
    auto temporary = path;
    temporary += "." + std::to_string(getpid()) + "." + std::to_string(count++) + ".tmp";
    {
        std::ofstream file(temporary, std::ios::binary);
        const std::string bytes = toFile(entry);
        file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        file.close();
        if (!file) {
            std::filesystem::remove(temporary, error);
            return false;
        }
    }
    std::filesystem::rename(temporary, path, error);
    if (!error) return true;
    std::filesystem::remove(temporary, error);
    return false;
}

} // namespace

void TranslationCache::setFolder(const std::filesystem::path& folder) {
    const std::lock_guard lock(mMutex);
    mFolder = folder;
    mState = Folder::Good;
}

bool TranslationCache::takeFailedFolder() {
    const std::lock_guard lock(mMutex);
    if (mState != Folder::Failed) return false;
    mState = Folder::FailedAndTold;
    return true;
}

std::filesystem::path TranslationCache::folder() const {
    const std::lock_guard lock(mMutex);
    return mFolder;
}

TranslationCache::Counts TranslationCache::counts() const {
    const std::lock_guard lock(mMutex);
    return mCounts;
}

Translation TranslationCache::translate(const Request& request) {
    const std::string key = keyOf(request);
    if (auto found = findInMemory(key, request)) return std::move(*found);
    const std::filesystem::path path = folder();
    if (!path.empty()) {
        auto entry = readFromDisk(path, key);
        if (entry && hasSameIncludes(*entry, request)) {
            Translation found = entry->translation;
            keepInMemory(std::move(*entry));
            const std::lock_guard lock(mMutex);
            ++mCounts.onDisk;
            return found;
        }
    }
    CacheEntry entry;
    entry.key = key;
    entry.translation = Cg::translate(request, entry.includes);
    Translation made = entry.translation;
    bool written = true;
    if (made.succeeded()) {
        if (!path.empty()) written = writeToDisk(path, entry);
        keepInMemory(std::move(entry));
    }
    const std::lock_guard lock(mMutex);
    ++mCounts.made;
    if (!written && mState == Folder::Good) mState = Folder::Failed;
    return made;
}

std::optional<Translation> TranslationCache::findInMemory(const std::string& key,
                                                          const Request& request) {
    CacheEntry entry;
    {
        const std::lock_guard lock(mMutex);
        const auto found = mEntries.find(key);
        if (found == mEntries.end()) return {};
        entry = found->second;
    }
    // Outside of the lock: it reads files.
    if (!hasSameIncludes(entry, request)) return {};
    const std::lock_guard lock(mMutex);
    ++mCounts.inMemory;
    return std::move(entry.translation);
}

void TranslationCache::keepInMemory(CacheEntry entry) {
    const std::lock_guard lock(mMutex);
    const std::string key = entry.key;
    mBytes += entry.size();
    const auto [place, isNew] = mEntries.try_emplace(key);
    if (isNew) {
        mOrder.push_back(key);
    } else {
        mBytes -= place->second.size();
    }
    place->second = std::move(entry);
    while (mBytes > MostBytesInMemory && mOrder.size() > 1) {
        const auto oldest = mEntries.find(mOrder.front());
        mBytes -= oldest->second.size();
        mEntries.erase(oldest);
        mOrder.pop_front();
    }
}

} // namespace Lixel::Cg

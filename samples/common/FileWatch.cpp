#include "common/FileWatch.h"

#include <OgreArchive.h>
#include <OgreResourceGroupManager.h>

#include <utility>

namespace Lixel::Samples {

FileWatch::FileWatch(std::string group) : mGroup(std::move(group)), mKnown(look()), mLast(mKnown) {}

bool FileWatch::changed() {
    Times now = look();
    const bool isSteady = now == mLast;
    mLast = std::move(now);
    if (!isSteady || mLast == mKnown) return false;
    mKnown = mLast;
    return true;
}

FileWatch::Times FileWatch::look() const {
    Times times;
    const Ogre::FileInfoListPtr files =
        Ogre::ResourceGroupManager::getSingleton().listResourceFileInfo(mGroup);
    for (const Ogre::FileInfo& file : *files) {
        const std::filesystem::path path =
            std::filesystem::path(file.archive->getName()) / file.filename;
        std::error_code missing;
        const auto time = std::filesystem::last_write_time(path, missing);
        if (!missing) times.emplace(path, time);
    }
    return times;
}

} // namespace Lixel::Samples

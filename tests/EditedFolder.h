#pragma once

#include <Lixel/reload/Reload.h>

#include <OgreResourceGroupManager.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace Lixel::Tests {

/// A resource group whose files are edited.
class EditedFolder {
public:
    static constexpr const char* Group = "EditedFolder";

    explicit EditedFolder(const std::string& group = Group, bool isInGlobalPool = true)
        : mGroup(group),
          mIsInGlobalPool(isInGlobalPool),
          mFolder(std::filesystem::temp_directory_path() /
                  ("lixel-edited-" + group + "-" + std::to_string(getpid()))) {
        std::filesystem::create_directories(mFolder);
    }
    ~EditedFolder() { std::filesystem::remove_all(mFolder); }
    EditedFolder(const EditedFolder&) = delete;
    EditedFolder& operator=(const EditedFolder&) = delete;

    void write(const std::string& file, const std::string& text) const {
        std::ofstream(mFolder / file) << text;
    }
    void remove(const std::string& file) const { std::filesystem::remove(mFolder / file); }
    /// Has OGRE read the files that were written so far.
    void parse() const {
        auto& groups = Ogre::ResourceGroupManager::getSingleton();
        groups.createResourceGroup(mGroup, mIsInGlobalPool);
        groups.addResourceLocation(mFolder.string(), "FileSystem", mGroup);
        groups.initialiseResourceGroup(mGroup);
    }
    std::vector<std::string> reload() const { return Lixel::reload(mGroup); }
    const std::filesystem::path& path() const { return mFolder; }

private:
    std::string mGroup;
    bool mIsInGlobalPool;
    std::filesystem::path mFolder;
};

} // namespace Lixel::Tests

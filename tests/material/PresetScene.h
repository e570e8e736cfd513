#pragma once

#include "EditedFolder.h"
#include "MaterialScene.h"

#include <Lixel/script/ShadowCameraSetupManager.h>

#include <string>

namespace Lixel::Tests {

inline constexpr const char* EditedGroup = "Edited";

/// A resource group of one script, which is edited.
class EditedScript {
public:
    explicit EditedScript(const std::string& text, const std::string& group = EditedGroup,
                          bool isInGlobalPool = true);

    void write(const std::string& text) const;
    /// @return how many errors there were
    std::size_t edit(const std::string& text) const;

private:
    std::string mGroup;
    EditedFolder mFolder;
};

void apply(const std::string& name, Ogre::Light& light);

/// What an application is told; empty where nothing is wrong.
std::string refusalOf(const std::string& name, Ogre::Light& light);

/// A scene in which one light shines, and shadows are off until something turns them on.
struct UnshadowedScene : MaterialScene {
    explicit UnshadowedScene(const std::string& material);
};

} // namespace Lixel::Tests

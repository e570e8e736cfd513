#pragma once

#include "common/StartedShaderSystem.h"

#include <string>

namespace Lixel::Samples {

/** What a stage needs for a scene whose materials OGRE's shader system draws, from when the scene
    is shown until the stage is cleared or ends.

    Materials without programs get theirs from OGRE when they are drawn, with Lixel's shadows. The
    scene's own resource group is there only as long as this: its scripts have parts that only the
    shader system understands.
*/
class ShaderSystemStage {
public:
    /** Starts the shader system and reads the group's resources.
        @param resourceFile where the group's locations are listed
        @exception std::runtime_error where it cannot be started; Ogre::Exception where resources
        are missing
    */
    ShaderSystemStage(const std::string& resourceFile, const std::string& group,
                      Ogre::SceneManager& sceneManager, Ogre::Viewport& viewport);
    /// While the scene manager lives.
    ~ShaderSystemStage();
    ShaderSystemStage(const ShaderSystemStage&) = delete;
    ShaderSystemStage& operator=(const ShaderSystemStage&) = delete;

private:
    std::string mGroup;
    StartedShaderSystem mShaderSystem;
};

} // namespace Lixel::Samples

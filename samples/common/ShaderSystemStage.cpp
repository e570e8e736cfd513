#include "common/ShaderSystemStage.h"

#include "common/ResourceFile.h"

#include <Lixel/rtss/ShaderSystem.h>

namespace Lixel::Samples {

ShaderSystemStage::ShaderSystemStage(const std::string& resourceFile, const std::string& group,
                                     Ogre::SceneManager& sceneManager, Ogre::Viewport& viewport)
    : mGroup(group) {
    mShaderSystem.generator.addSceneManager(&sceneManager);
    viewport.setMaterialScheme(StartedShaderSystem::Scheme);
    ShaderSystem::enable(mShaderSystem.generator);

    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    // In the global pool, so that its scripts can import Lixel's.
    groups.createResourceGroup(group, true);
    try {
        addResources(resourceFile, [&](const std::string& section) { return section == group; });
        groups.initialiseResourceGroup(group);
    } catch (...) {
        groups.destroyResourceGroup(group);
        throw;
    }
}

ShaderSystemStage::~ShaderSystemStage() {
    // Its materials are another shader system's the next time.
    Ogre::ResourceGroupManager::getSingleton().destroyResourceGroup(mGroup);
}

} // namespace Lixel::Samples

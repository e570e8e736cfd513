#include "BenchMaterials.h"

#include <OgreMaterialManager.h>
#include <OgreResourceGroupManager.h>

#include <string>

namespace Lixel::Tests {

Ogre::MaterialPtr benchCaster() {
    constexpr const char* MaterialGroup = "Lixel";
    Ogre::ResourceGroupManager& groups = Ogre::ResourceGroupManager::getSingleton();
    if (!groups.resourceGroupExists(MaterialGroup)) {
        groups.createResourceGroup(MaterialGroup);
        for (const char* folder : {"/scripts", "/programs/glsl"})
            groups.addResourceLocation(std::string(LIXEL_MATERIALS_DIR) + folder, "FileSystem",
                                       MaterialGroup);
        groups.initialiseResourceGroup(MaterialGroup);
    }
    return Ogre::MaterialManager::getSingleton().getByName("Lixel/Caster", MaterialGroup);
}

} // namespace Lixel::Tests

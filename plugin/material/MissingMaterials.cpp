#include "material/MissingMaterials.h"

#include <OgreMaterial.h>
#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreRenderSystem.h>
#include <OgreRenderSystemCapabilities.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreTechnique.h>

namespace Lixel {
namespace {

#if OGRE_VERSION_MAJOR < 14
/// OGRE has no function that tells the two materials.
class Access : public Ogre::SceneManager {
public:
    static bool hasCaster(Ogre::SceneManager& manager) {
        return (manager.*(&Access::mShadowRenderer)).mShadowTextureCustomCasterPass != nullptr;
    }
    static bool hasReceiver(Ogre::SceneManager& manager) {
        return (manager.*(&Access::mShadowRenderer)).mShadowTextureCustomReceiverPass != nullptr;
    }
};
#else
struct Access {
    static bool hasCaster(Ogre::SceneManager&) { return true; }
    static bool hasReceiver(Ogre::SceneManager&) { return true; }
};
#endif

bool canDraw(const char* material) {
    if (Ogre::Root::getSingleton().getRenderSystem()->getCapabilities()->hasCapability(
            Ogre::RSC_FIXED_FUNCTION))
        return true;
    const Ogre::MaterialPtr found =
        Ogre::MaterialManager::getSingleton().getByName(material, Ogre::RGN_INTERNAL);
    if (!found) return true;
    found->load();
    const Ogre::Technique* const technique = found->getBestTechnique();
    return technique != nullptr && technique->getPass(0)->hasVertexProgram();
}

} // namespace

std::vector<std::string> findMissingMaterials(Ogre::SceneManager& manager) {
    std::vector<std::string> missing;
    if (!Access::hasCaster(manager) && !canDraw("Ogre/TextureShadowCaster"))
        missing.push_back("scene manager '" + manager.getName() +
                          "' has no shadow caster material, and OGRE's own cannot be drawn here: "
                          "give setShadowTextureCasterMaterial 'Lixel/Caster'. A name that no "
                          "material has is none");
    if (!manager.isShadowTechniqueIntegrated() && !Access::hasReceiver(manager) &&
        !canDraw("Ogre/TextureShadowReceiver"))
        missing.push_back(
            "scene manager '" + manager.getName() +
            "' has no shadow receiver material, and OGRE's own cannot be drawn here: "
            "give setShadowTextureReceiverMaterial 'Lixel/Receiver/Bilinear', or "
            "'Lixel/Receiver/Modulative/Bilinear' for modulative shadows. A name that "
            "no material has is none");
    return missing;
}

} // namespace Lixel

#include "material/MissingMaterials.h"

#include "scene/OgreVersions.h"

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

bool canDraw(const char* material, const std::string& scheme) {
    if (Ogre::Root::getSingleton().getRenderSystem()->getCapabilities()->hasCapability(
            Ogre::RSC_FIXED_FUNCTION))
        return true;
    auto& materials = Ogre::MaterialManager::getSingleton();
    const Ogre::MaterialPtr found = materials.getByName(material, Ogre::RGN_INTERNAL);
    if (!found) return true;
    // OGRE activates the viewport's scheme when it draws, which is later.
    const Ogre::String active = materials.getActiveScheme();
    materials.setActiveScheme(scheme);
    found->load();
    const Ogre::Technique* const technique = found->getBestTechnique();
    materials.setActiveScheme(active);
    return technique != nullptr && technique->getPass(0)->hasVertexProgram();
}

} // namespace

std::vector<std::string> findMissingMaterials(Ogre::SceneManager& manager,
                                              const std::string& scheme) {
    std::vector<std::string> missing;
    if (shadowCasterPassOf(manager) == nullptr && !canDraw("Ogre/TextureShadowCaster", scheme))
        missing.push_back("scene manager '" + manager.getName() +
                          "' has no shadow caster material, and OGRE's own cannot be drawn here: "
                          "give setShadowTextureCasterMaterial 'Lixel/Caster'. A name that no "
                          "material has is none, and so is one whose programs do not compile");
    if (!manager.isShadowTechniqueIntegrated() && shadowReceiverPassOf(manager) == nullptr &&
        !canDraw("Ogre/TextureShadowReceiver", scheme))
        missing.push_back(
            "scene manager '" + manager.getName() +
            "' has no shadow receiver material, and OGRE's own cannot be drawn here: "
            "give setShadowTextureReceiverMaterial 'Lixel/Receiver/Bilinear', or "
            "'Lixel/Receiver/Modulative/Bilinear' for modulative shadows. A name that "
            "no material has is none, and so is one whose programs do not compile");
    return missing;
}

} // namespace Lixel

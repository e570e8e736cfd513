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

/// A material without programs, as OGRE's own shadow materials are. Not one of those: the shader
/// system would copy the receiver before OGRE has set its ambient colour to black.
Ogre::MaterialPtr plainMaterial() {
    static const char* const Name = "Lixel/WithoutPrograms";
    auto& materials = Ogre::MaterialManager::getSingleton();
    if (Ogre::MaterialPtr known = materials.getByName(Name, Ogre::RGN_INTERNAL)) return known;
    Ogre::MaterialPtr made = materials.create(Name, Ogre::RGN_INTERNAL);
    made->setReceiveShadows(false);
    made->setLightingEnabled(false);
    return made;
}

/// Whether materials without programs can be drawn: by a fixed function, or by programs that the
/// shader system makes for the scheme.
bool drawsWithoutPrograms(const std::string& scheme) {
    if (Ogre::Root::getSingleton().getRenderSystem()->getCapabilities()->hasCapability(
            Ogre::RSC_FIXED_FUNCTION))
        return true;
    auto& materials = Ogre::MaterialManager::getSingleton();
    const Ogre::MaterialPtr plain = plainMaterial();
    // OGRE activates the viewport's scheme when it draws, which is later.
    const Ogre::String active = materials.getActiveScheme();
    materials.setActiveScheme(scheme);
    plain->load();
    const Ogre::Technique* const technique = plain->getBestTechnique();
    materials.setActiveScheme(active);
    return technique != nullptr && technique->getPass(0)->hasVertexProgram();
}

} // namespace

std::vector<std::string> findMissingMaterials(Ogre::SceneManager& manager,
                                              const std::string& scheme) {
    const bool lacksCaster = shadowCasterPassOf(manager) == nullptr;
    const bool lacksReceiver =
        !manager.isShadowTechniqueIntegrated() && shadowReceiverPassOf(manager) == nullptr;
    std::vector<std::string> missing;
    if ((!lacksCaster && !lacksReceiver) || drawsWithoutPrograms(scheme)) return missing;
    if (lacksCaster)
        missing.push_back("scene manager '" + manager.getName() +
                          "' has no shadow caster material, and OGRE's own cannot be drawn here: "
                          "give setShadowTextureCasterMaterial 'Lixel/Caster'. A name that no "
                          "material has is none, and so is one whose programs do not compile");
    if (lacksReceiver)
        missing.push_back(
            "scene manager '" + manager.getName() +
            "' has no shadow receiver material, and OGRE's own cannot be drawn here: "
            "give setShadowTextureReceiverMaterial 'Lixel/Receiver/Bilinear', or "
            "'Lixel/Receiver/Modulative/Bilinear' for modulative shadows. A name that "
            "no material has is none, and so is one whose programs do not compile");
    return missing;
}

} // namespace Lixel

#include "material/OwnShadowMaterials.h"

#include <OgreMaterial.h>
#include <OgreMaterialManager.h>
#include <OgreTechnique.h>

namespace Lixel {
namespace {

bool canBeDrawn(const Ogre::MaterialPtr& material) {
    material->load();
    return material->getBestTechnique() != nullptr;
}

std::string sentence(const Ogre::Technique& technique, const char* kind, const std::string& name) {
    return "material '" + technique.getParent()->getName() + "': its " + kind + " '" + name +
           "' cannot be drawn, and the scene manager's is used: see the errors of its programs in "
           "this log";
}

} // namespace

std::vector<std::string> dropUnusableShadowMaterials() {
    std::vector<std::string> lines;
    for (const auto& [handle, resource] :
         Ogre::MaterialManager::getSingleton().getResourceIterator()) {
        if (!resource->isLoaded()) continue; // nothing wears it
        for (Ogre::Technique* technique :
             static_cast<const Ogre::Material&>(*resource).getTechniques()) {
            const Ogre::MaterialPtr receiver = technique->getShadowReceiverMaterial();
            if (receiver && !canBeDrawn(receiver)) {
                lines.push_back(
                    sentence(*technique, "shadow_receiver_material", receiver->getName()));
                technique->setShadowReceiverMaterial(Ogre::MaterialPtr());
            }
            const Ogre::MaterialPtr caster = technique->getShadowCasterMaterial();
            if (caster && !canBeDrawn(caster)) {
                lines.push_back(sentence(*technique, "shadow_caster_material", caster->getName()));
                technique->setShadowCasterMaterial(Ogre::MaterialPtr());
            }
        }
    }
    return lines;
}

} // namespace Lixel

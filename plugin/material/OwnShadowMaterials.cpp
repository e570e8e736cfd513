#include "material/OwnShadowMaterials.h"

#include "material/QueuedPasses.h"

#include <OgreMaterial.h>
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

std::vector<std::string> dropUnusableShadowMaterials(Ogre::SceneManager& manager) {
    std::vector<std::string> lines;
    forQueuedTechniques(manager, [&](Ogre::Technique& technique) {
        const Ogre::MaterialPtr receiver = technique.getShadowReceiverMaterial();
        if (receiver && !canBeDrawn(receiver)) {
            lines.push_back(sentence(technique, "shadow_receiver_material", receiver->getName()));
            technique.setShadowReceiverMaterial(Ogre::MaterialPtr());
        }
        const Ogre::MaterialPtr caster = technique.getShadowCasterMaterial();
        if (caster && !canBeDrawn(caster)) {
            lines.push_back(sentence(technique, "shadow_caster_material", caster->getName()));
            technique.setShadowCasterMaterial(Ogre::MaterialPtr());
        }
    });
    return lines;
}

} // namespace Lixel

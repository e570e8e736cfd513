#include "material/ShadowMaterials.h"

#include "material/MapReads.h"
#include "scene/NameList.h"

#include <OgreException.h>
#include <OgreMaterial.h>
#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreSceneManager.h>
#include <OgreTechnique.h>

#include <vector>

namespace Lixel {
namespace {

/// Names of the materials that begin so, for a message.
std::string materialsLike(const std::string& prefix) {
    std::vector<std::string> names;
    for (const auto& [handle, material] :
         Ogre::MaterialManager::getSingleton().getResourceIterator())
        if (Ogre::StringUtil::startsWith(material->getName(), prefix, false))
            names.push_back(material->getName());
    return joinNames(names);
}

Ogre::MaterialPtr find(const char* argument, const Ogre::String& name, const std::string& prefix) {
    if (const Ogre::MaterialPtr material = Ogre::MaterialManager::getSingleton().getByName(name))
        return material;
    const std::string known = materialsLike(prefix);
    OGRE_EXCEPT(Ogre::Exception::ERR_ITEM_NOT_FOUND,
                argument + (": there is no material '" + name + "'; ") +
                    (known.empty() ? "none of Lixel's is loaded: are materials/scripts and "
                                     "materials/programs/glsl resource locations of the group "
                                     "General, and is it initialised?"
                                   : "Lixel's are " + known),
                "setShadowMaterials");
}

/// What a material is for, where its first pass tells; empty where it does not.
std::string roleOf(Ogre::Material& material) {
    material.load();
    const Ogre::Technique* const technique = material.getBestTechnique();
    if (technique == nullptr || technique->getNumPasses() == 0) return {};
    const Ogre::Pass& pass = *technique->getPass(0);
    if (pass.getIlluminationStage() != Ogre::IS_UNKNOWN) return "surface";
    if (readsMaps(pass)) return "receiver";
    return writesCasterDepth(pass) ? "caster" : "";
}

void refuseUnless(const std::string& wanted, Ogre::Material& material) {
    const std::string role = roleOf(material);
    if (role.empty() || role == wanted) return;
    OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                wanted + ": material '" + material.getName() + "' is a " + role +
                    "; the receiver is the first name, the caster the second",
                "setShadowMaterials");
}

} // namespace

void setShadowMaterials(Ogre::SceneManager& sceneManager, const Ogre::String& receiver,
                        const Ogre::String& caster) {
    const Ogre::MaterialPtr casts = find("caster", caster, "Lixel/Caster");
    const Ogre::MaterialPtr receives =
        receiver.empty() ? Ogre::MaterialPtr() : find("receiver", receiver, "Lixel/Receiver");
    refuseUnless("caster", *casts);
    if (receives) refuseUnless("receiver", *receives);
    sceneManager.setShadowTextureCasterMaterial(casts);
    sceneManager.setShadowTextureReceiverMaterial(receives);
}

} // namespace Lixel

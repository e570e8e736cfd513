#include "material/ShadowMaterials.h"

#include <OgreException.h>
#include <OgreMaterial.h>
#include <OgreMaterialManager.h>
#include <OgreSceneManager.h>

namespace Lixel {
namespace {

/// Names of the materials that begin so, for a message.
std::string materialsLike(const std::string& prefix) {
    std::string names;
    for (const auto& [handle, material] :
         Ogre::MaterialManager::getSingleton().getResourceIterator())
        if (Ogre::StringUtil::startsWith(material->getName(), prefix, false))
            names += (names.empty() ? "" : ", ") + material->getName();
    return names;
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

} // namespace

void setShadowMaterials(Ogre::SceneManager& sceneManager, const Ogre::String& receiver,
                        const Ogre::String& caster) {
    const Ogre::MaterialPtr casts = find("caster", caster, "Lixel/Caster");
    const Ogre::MaterialPtr receives =
        receiver.empty() ? Ogre::MaterialPtr() : find("receiver", receiver, "Lixel/Receiver");
    sceneManager.setShadowTextureCasterMaterial(casts);
    sceneManager.setShadowTextureReceiverMaterial(receives);
}

} // namespace Lixel

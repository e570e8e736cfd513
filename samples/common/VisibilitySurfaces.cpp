#include "common/VisibilitySurfaces.h"

#include <string>

namespace Lixel::Samples {
namespace {

const char* const Surface = "Lixel/Samples/Visibility";

/// Lixel's receiver of six maps, which serves lights with fewer too, without its filter and light.
const std::string Script = R"(
import * from "Lixel.program"
import * from "Lixel.material"

fragment_program Lixel/Samples/VisibilityFP glsl : Lixel/ReceiverFP/Maps6
{
    preprocessor_defines LIXEL_VISIBILITY_ONLY=1,LIXEL_MAPS=6
}

material Lixel/Samples/Visibility : Lixel/Surface/Integrated/Maps6
{
    technique
    {
        pass Light
        {
            fragment_program_ref Lixel/Samples/VisibilityFP
            {
            }
        }
    }
}
)";

Ogre::MaterialPtr surface() {
    auto& materials = Ogre::MaterialManager::getSingleton();
    if (!materials.resourceExists(Surface, Ogre::RGN_DEFAULT)) {
        // OGRE wants mutable bytes and does not write to them.
        Ogre::DataStreamPtr script = std::make_shared<Ogre::MemoryDataStream>(
            const_cast<char*>(Script.data()), Script.size(), false, true);
        materials.parseScript(script, Ogre::RGN_DEFAULT);
    }
    return materials.getByName(Surface, Ogre::RGN_DEFAULT);
}

} // namespace

VisibilitySurfaces::VisibilitySurfaces(Ogre::SceneManager& sceneManager) {
    const Ogre::MaterialPtr material = surface();
    for (const auto& [name, object] : sceneManager.getMovableObjects("Entity")) {
        for (Ogre::SubEntity* const part : static_cast<Ogre::Entity*>(object)->getSubEntities()) {
            mSurfaces.emplace_back(part, part->getMaterial());
            part->setMaterial(material);
        }
    }
}

VisibilitySurfaces::~VisibilitySurfaces() {
    for (const auto& [part, material] : mSurfaces)
        part->setMaterial(material);
}

} // namespace Lixel::Samples

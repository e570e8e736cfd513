#include "PresetScene.h"

namespace Lixel::Tests {

EditedScript::EditedScript(const std::string& text, const std::string& group, bool isInGlobalPool)
    : mGroup(group), mFolder(group, isInGlobalPool) {
    write(text);
    mFolder.parse();
}

void EditedScript::write(const std::string& text) const {
    mFolder.write("my.shadow", text);
}

std::size_t EditedScript::edit(const std::string& text) const {
    write(text);
    return ShadowCameraSetupManager::getSingleton().reload(mGroup).size();
}

void apply(const std::string& name, Ogre::Light& light) {
    ShadowCameraSetupManager::getByName(name)->applyTo(light);
}

std::string refusalOf(const std::string& name, Ogre::Light& light) {
    try {
        apply(name, light);
    } catch (const Ogre::Exception& exception) {
        return exception.getDescription();
    }
    return {};
}

UnshadowedScene::UnshadowedScene(const std::string& material)
    : MaterialScene(IntegratedTechnique, "") {
    Ogre::SceneManager& manager = stage.sceneManager();
    manager.setShadowTechnique(Ogre::SHADOWTYPE_NONE);
    for (Ogre::Light* light : lights) {
        light->setCustomShadowCameraSetup({});
        light->setCastShadows(false);
        light->setVisible(light == lights.front());
    }
    wear(material);
}

} // namespace Lixel::Tests

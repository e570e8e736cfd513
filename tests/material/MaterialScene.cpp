#include "MaterialScene.h"

#include <Lixel/setup/ShadowCameraSetups.h>

#include <cstdlib>

namespace Lixel::Tests {

MaterialScene::MaterialScene(Ogre::ShadowTechnique technique, const std::string& receiver) {
    Ogre::ResourceGroupManager& groups = Ogre::ResourceGroupManager::getSingleton();
    groups.addResourceLocation(LIXEL_TEST_MEDIA, "FileSystem", Ogre::RGN_DEFAULT);
    groups.clearResourceGroup(Ogre::RGN_DEFAULT);
    groups.initialiseResourceGroup(Ogre::RGN_DEFAULT);
    for (const auto& [name, object] : stage.sceneManager().getMovableObjects("Entity"))
        static_cast<Ogre::Entity*>(object)->setMaterialName("Lixel/Surface");

    Ogre::SceneManager& manager = stage.sceneManager();
    auto& materials = Ogre::MaterialManager::getSingleton();
    manager.setAmbientLight(Ogre::ColourValue::Black);
    manager.setShadowColour(Ogre::ColourValue(0.5F, 0.5F, 0.5F));
    manager.setShadowTechnique(technique);
    manager.setShadowTextureCasterMaterial(materials.getByName("Lixel/Caster"));
    manager.setShadowTextureReceiverMaterial(receiver.empty() ? Ogre::MaterialPtr()
                                                              : materials.getByName(receiver));
    manager.setShadowTextureSettings(512, 3, Ogre::PF_FLOAT32_R);

    const auto add = [&](Ogre::Light* light, const Ogre::Vector3& position,
                         const Ogre::Vector3& direction) {
        light->setDiffuseColour(0.3F, 0.3F, 0.3F);
        light->setSpecularColour(Ogre::ColourValue::Black);
        Ogre::SceneNode* node = light->getParentSceneNode();
        if (node == nullptr) {
            node = manager.getRootSceneNode()->createChildSceneNode();
            node->attachObject(light);
        }
        node->setPosition(position);
        node->setDirection(direction, Ogre::Node::TS_WORLD);
        light->setCustomShadowCameraSetup(XPSMShadowCameraSetup::create());
        lights.push_back(light);
    };
    add(&stage.light(), Ogre::Vector3::ZERO, Ogre::Vector3(-1, -1, 0));
    Ogre::Light* const second = manager.createLight("second");
    second->setType(Ogre::Light::LT_DIRECTIONAL);
    add(second, Ogre::Vector3::ZERO, Ogre::Vector3(1, -1, 0.3F));
    Ogre::Light* const spot = manager.createLight("spot");
    spot->setType(Ogre::Light::LT_SPOTLIGHT);
    spot->setSpotlightRange(Ogre::Degree(50), Ogre::Degree(60));
    spot->setAttenuation(100, 1, 0, 0);
    add(spot, Ogre::Vector3(0, 7, -6), Ogre::Vector3(0, -1, 1));
}

void MaterialScene::wear(const std::string& material) {
    for (Ogre::SceneNode* node : {ground, box})
        static_cast<Ogre::Entity*>(node->getAttachedObject(0))->setMaterialName(material);
}

std::vector<int> MaterialScene::draw() {
    stage.drawFrame();
    const std::vector<std::uint8_t> rgb = stage.picture();
    std::vector<int> red(rgb.size() / 3);
    for (std::size_t i = 0; i < red.size(); ++i)
        red[i] = rgb[3 * i];
    return red;
}

void MaterialScene::keepPicture(const std::string& name) {
    if (const char* folder = std::getenv("LIXEL_PICTURES"))
        stage.window().writeContentsToFile(std::string(folder) + "/" + name + ".png");
}

double differing(const std::vector<int>& a, const std::vector<int>& b, int tolerance) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        count += std::abs(a[i] - b.at(i)) > tolerance ? 1 : 0;
    return 100.0 * static_cast<double>(count) / static_cast<double>(a.size());
}

} // namespace Lixel::Tests

// Lixel's folders in the group General: what applications in each kind of resource group find
// there.

#include "MaterialScene.h"

#include <Lixel/material/ShadowMaterials.h>

namespace Lixel::Tests {
namespace {

const char* const Game = "Game";

/// The recipes of materials/README.md and a textured surface, as files of an application.
void addGame(const char* group) {
    Ogre::ResourceGroupManager& groups = Ogre::ResourceGroupManager::getSingleton();
    groups.addResourceLocation(LIXEL_TEST_MEDIA "/game", "FileSystem", group);
    if (std::string(group) == Ogre::RGN_DEFAULT) groups.clearResourceGroup(group);
    groups.initialiseResourceGroup(group);
}

void expectRecipesWork(MaterialScene& scene, const char* group) {
    LogCollector log;
    auto& materials = Ogre::MaterialManager::getSingleton();
    const Ogre::MaterialPtr wall = materials.getByName("My/Wall", group);
    ASSERT_TRUE(wall);
    static_cast<Ogre::Entity*>(scene.ground->getAttachedObject(0))->setMaterial(wall);
    static_cast<Ogre::Entity*>(scene.box->getAttachedObject(0))->setMaterial(wall);
    const Ogre::Vector3 inShadow(-2, 0, 0);
    const std::vector<int> picture = scene.draw();
    scene.keepPicture(std::string("group-") + group);
    Ogre::TextureUnitState& unit =
        *wall->getTechnique(0)->getPass("Light")->getTextureUnitState("DiffuseMap");
    ASSERT_TRUE(unit._getTexturePtr());
    EXPECT_EQ(unit._getTexturePtr()->getWidth(), 4U) << "the texture was not found";
    EXPECT_GT(picture[scene.pixelOf(Ogre::Vector3(4, 0, 4))], 20);

    // The recipe of a receiver of the surface's own: it quantizes light, and shadows it.
    const Ogre::MaterialPtr toon = materials.getByName("My/Toon", group);
    ASSERT_TRUE(toon);
    static_cast<Ogre::Entity*>(scene.ground->getAttachedObject(0))->setMaterial(toon);
    for (Ogre::Light* light : scene.lights)
        light->setVisible(light == scene.lights.front());
    const std::vector<int> banded = scene.draw();
    EXPECT_GT(banded[scene.pixelOf(Ogre::Vector3(4, 0, 4))], 20);
    EXPECT_EQ(banded[scene.pixelOf(inShadow)], 0);
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
}

TEST(Groups, GeneralHoldsTheApplicationsMaterials) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver/Bilinear");
    addGame(Ogre::RGN_DEFAULT);
    Ogre::MaterialManager& materials = Ogre::MaterialManager::getSingleton();
    setShadowMaterials(scene.stage.sceneManager(), "Lixel/Receiver/Bilinear");
    ASSERT_TRUE(materials.getByName("Lixel/Surface"));
    expectRecipesWork(scene, Ogre::RGN_DEFAULT);
}

TEST(Groups, GroupsInTheGlobalPoolFindLixel) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver/Bilinear");
    Ogre::ResourceGroupManager::getSingleton().createResourceGroup(Game, true);
    addGame(Game);
    expectRecipesWork(scene, Game);
}

} // namespace
} // namespace Lixel::Tests

// Lixel's folders in the group General: what applications in each kind of resource group find
// there.

#include "MaterialScene.h"

#include <Lixel/material/ShadowMaterials.h>
#include <Lixel/setup/ShadowCameraSetups.h>

#include <algorithm>
#include <fstream>
#include <sstream>

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

/// The recipe of a surface that reads several maps.
TEST(Groups, HoldProgramsForSeveralMaps) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, "");
    addGame(Ogre::RGN_DEFAULT);
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    manager.setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL, 3);
    Ogre::Light& sun = *scene.lights.front();
    for (Ogre::Light* light : scene.lights)
        light->setVisible(light == &sun);
    setShadowMaterials(manager, "");
    sun.setCustomShadowCameraSetup(CascadesShadowCameraSetup::create());
    LogCollector log;
    scene.wear("My/Cascades");
    const std::vector<int> banded = scene.draw();
    scene.keepPicture("recipe-cascades");
    EXPECT_GT(banded[scene.pixelOf(Ogre::Vector3(4, 0, 4))], 20);
    EXPECT_EQ(banded[scene.pixelOf(Ogre::Vector3(-2, 0, 0))], 0);
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
}

/// The recipe of a vertex program: the surface, its light and its shadow are bent alike.
TEST(Groups, HoldVertexProgramsOfTheApplications) {
    for (const bool isIntegrated : {false, true}) {
        MaterialScene scene(isIntegrated ? Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED
                                         : Ogre::SHADOWTYPE_TEXTURE_ADDITIVE,
                            isIntegrated ? "" : "Lixel/Receiver/Bilinear");
        addGame(Ogre::RGN_DEFAULT);
        Ogre::SceneManager& manager = scene.stage.sceneManager();
        setShadowMaterials(manager, isIntegrated ? "" : "Lixel/Receiver/Bilinear");
        Ogre::Light& sun = *scene.lights.front();
        for (Ogre::Light* light : scene.lights)
            light->setVisible(light == &sun);
        if (isIntegrated) {
            manager.setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL, 3);
            sun.setCustomShadowCameraSetup(CascadesShadowCameraSetup::create());
            scene.wear("Lixel/Surface/Integrated/Maps3");
        }
        const std::vector<int> straight = scene.draw();
        auto& box = *static_cast<Ogre::Entity*>(scene.box->getAttachedObject(0));
        LogCollector log;
        box.setMaterialName(isIntegrated ? "My/GrassOfSeveralMaps" : "My/Grass");
        scene.draw();
        const std::vector<int> bent = scene.draw();
        scene.keepPicture(isIntegrated ? "recipe-grass-integrated" : "recipe-grass");
        EXPECT_NE(bent, straight);
        EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
    }
}

std::string contentOf(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// As the README has it: without the marks and indents that make it a block of code.
std::string withoutIndents(const std::string& text) {
    std::istringstream lines(text);
    std::string plain;
    for (std::string line; std::getline(lines, line);)
        plain += line.substr(std::min(line.find_first_not_of(' '), line.size())) + '\n';
    return plain;
}

TEST(Recipes, AreTheReadmes) {
    const std::string readme = withoutIndents(contentOf(LIXEL_MATERIALS_DIR "/README.md"));
    for (const char* name : {"MyReceiver.frag", "My.program", "MyCascades.frag",
                             "MyCascades.program", "MyCascades.material", "MyGrass.vert",
                             "MyGrassCaster.vert", "MyGrass.program", "MyGrass.material"}) {
        const std::string recipe = contentOf(LIXEL_TEST_MEDIA "/game/" + std::string(name));
        ASSERT_FALSE(recipe.empty());
        EXPECT_NE(readme.find(withoutIndents(recipe)), std::string::npos) << name;
    }
    // The README shows the wall, and then the receiver and what wears it.
    const std::string materials = withoutIndents(contentOf(LIXEL_TEST_MEDIA "/game/My.material"));
    const std::size_t wall = materials.find("material My/Wall");
    const std::size_t receiver = materials.find("material My/Receiver");
    ASSERT_LT(wall, receiver);
    EXPECT_NE(readme.find(materials.substr(wall, receiver - wall)), std::string::npos);
    EXPECT_NE(readme.find(materials.substr(receiver)), std::string::npos);
}

} // namespace
} // namespace Lixel::Tests

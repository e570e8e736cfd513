#include "ShaderSystemScene.h"

#include <Lixel/setup/ShadowCameraSetups.h>

#include <cmath>
#include <cstdlib>
#include <ostream>

namespace Lixel::Tests {

Difference differenceOf(const Picture& a, const Picture& b) {
    constexpr int Tolerance = 4;
    Difference difference;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const int apart = std::abs(a[i] - b.at(i));
        difference.greatest = std::max(difference.greatest, apart);
        count += apart > Tolerance ? 1 : 0;
    }
    difference.percent = 100.0 * static_cast<double>(count) / static_cast<double>(a.size());
    return difference;
}

std::ostream& operator<<(std::ostream& out, const Difference& difference) {
    return out << "at most " << difference.greatest << " of 255 apart, " << difference.percent
               << " % by more than 4";
}

testing::AssertionResult isSame(const Picture& a, const Picture& b) {
    const Difference difference = differenceOf(a, b);
    if (std::getenv("LIXEL_PICTURES") != nullptr) std::cout << difference << '\n';
    if (difference.greatest <= 8 && difference.percent <= 0.002)
        return testing::AssertionSuccess() << difference;
    return testing::AssertionFailure() << difference;
}

testing::AssertionResult isOther(const Picture& a, const Picture& b) {
    const Difference difference = differenceOf(a, b);
    if (difference.percent >= 0.5) return testing::AssertionSuccess() << difference;
    return testing::AssertionFailure() << difference;
}

ShaderSystemScene::ShaderSystemScene() {
    manager().setAmbientLight(Ogre::ColourValue::Black);
    manager().setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
    stage.light().setVisible(false);
    addCube(Ogre::Vector3(5, 1.5F, -3), Ogre::Vector3(2, 3, 2));
    addCube(Ogre::Vector3(-4, 0.5F, 2), Ogre::Vector3(1, 1, 3));
    Ogre::MaterialManager::getSingleton().create(Plain, Ogre::RGN_DEFAULT);
    shaderSystem.generator.addSceneManager(&manager());
    wear(Plain);
}

ShaderSystemScene::~ShaderSystemScene() {
    if (shutsDown) Lixel::ShaderSystem::shutdown();
}

Ogre::Light& ShaderSystemScene::add(const std::string& name, Ogre::Light::LightTypes type,
                                    const Ogre::Vector3& position, const Ogre::Vector3& direction) {
    Ogre::Light* const light = manager().createLight(name);
    light->setType(type);
    light->setDiffuseColour(0.3F, 0.3F, 0.3F);
    light->setSpecularColour(0.3F, 0.3F, 0.3F);
    light->setAttenuation(100, 1, 0, 0);
    Ogre::SceneNode* const node = manager().getRootSceneNode()->createChildSceneNode(position);
    node->attachObject(light);
    node->setDirection(direction, Ogre::Node::TS_WORLD);
    return *light;
}

Ogre::Light& ShaderSystemScene::addSun() {
    Ogre::Light& sun =
        add("sun", Ogre::Light::LT_DIRECTIONAL, Ogre::Vector3::ZERO, Ogre::Vector3(-1, -1, 0.2F));
    sun.setCustomShadowCameraSetup(CascadesShadowCameraSetup::create(
        XPSMShadowCameraSetup::create(), {.followReceivers = false}));
    return sun;
}

Ogre::Light& ShaderSystemScene::addSpot() {
    Ogre::Light& spot =
        add("spot", Ogre::Light::LT_SPOTLIGHT, Ogre::Vector3(0, 7, -6), Ogre::Vector3(0, -1, 1));
    spot.setSpotlightRange(Ogre::Degree(50), Ogre::Degree(60));
    spot.setCustomShadowCameraSetup(LiSPSMShadowCameraSetup::create());
    return spot;
}

Ogre::Light& ShaderSystemScene::addLamp() {
    Ogre::Light& lamp =
        add("lamp", Ogre::Light::LT_POINT, Ogre::Vector3(2, 1.5F, 2), Ogre::Vector3(0, 0, -1));
    lamp.setDiffuseColour(0.4F, 0.3F, 0.1F);
    lamp.setCustomShadowCameraSetup(UniformShadowCameraSetup::create());
    return lamp;
}

void ShaderSystemScene::setMaps(std::size_t sun, std::size_t spot, std::size_t lamp) {
    manager().setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL, sun);
    manager().setShadowTextureCountPerLightType(Ogre::Light::LT_SPOTLIGHT, spot);
    manager().setShadowTextureCountPerLightType(Ogre::Light::LT_POINT, lamp);
    manager().setShadowTextureSettings(512, static_cast<unsigned short>(sun + spot + lamp),
                                       Ogre::PF_FLOAT32_R);
}

void ShaderSystemScene::wear(const std::string& material) {
    for (const auto& [name, object] : manager().getMovableObjects("Entity"))
        static_cast<Ogre::Entity*>(object)->setMaterialName(material);
}

Picture ShaderSystemScene::drawAsItIs() {
    stage.drawFrame();
    return stage.picture();
}

Picture ShaderSystemScene::draw() {
    stage.viewport().setMaterialScheme(StartedShaderSystem::Scheme);
    return drawAsItIs();
}

Picture ShaderSystemScene::drawLixels() {
    stage.viewport().setMaterialScheme(mOwnScheme);
    std::map<Ogre::Entity*, Ogre::MaterialPtr> worn;
    for (const auto& [name, object] : manager().getMovableObjects("Entity")) {
        auto* const entity = static_cast<Ogre::Entity*>(object);
        worn[entity] = entity->getSubEntity(0)->getMaterial();
        entity->setMaterialName("Lixel/Surface/Integrated/Maps6");
    }
    const Picture picture = drawAsItIs();
    for (const auto& [entity, material] : worn)
        entity->setMaterial(material);
    return picture;
}

void ShaderSystemScene::parse(std::string script) {
    Ogre::DataStreamPtr stream(new Ogre::MemoryDataStream(script.data(), script.size()));
    Ogre::MaterialManager::getSingleton().parseScript(stream, Ogre::RGN_DEFAULT);
}

void ShaderSystemScene::addMaterial(const std::string& name, const std::string& pass) {
    parse("material " + name + "\n{\ntechnique\n{\npass\n{\n" + pass + "\n}\n}\n}\n");
}

void ShaderSystemScene::addTexture(const std::string& name, std::vector<std::uint8_t> texels) {
    const auto side =
        static_cast<Ogre::uint32>(std::lround(std::sqrt(static_cast<double>(texels.size()) / 4)));
    Ogre::TexturePtr texture = Ogre::TextureManager::getSingleton().createManual(
        name, Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, side, side, 0, Ogre::PF_BYTE_RGBA);
    texture->getBuffer()->blitFromMemory(
        Ogre::PixelBox(side, side, 1, Ogre::PF_BYTE_RGBA, texels.data()));
}

void ShaderSystemScene::keepPicture(const std::string& name) {
    if (const char* folder = std::getenv("LIXEL_PICTURES"))
        stage.window().writeContentsToFile(std::string(folder) + "/rtss-" + name + ".png");
}

} // namespace Lixel::Tests

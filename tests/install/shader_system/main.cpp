// The same ball, with materials that have no programs: OGRE's shader system draws them, and Lixel
// shadows them. Two lines, marked with "Lixel:", are all that shadows take.
#include <Lixel/headless/Headless.h>
#include <Lixel/rtss/ShaderSystem.h>
#include <Lixel/script/ShadowCameraSetupManager.h>
#include <Ogre.h>
#include <RTShaderSystem/OgreRTShaderSystem.h>
#include <iostream>

using Ogre::RTShader::ShaderGenerator;

// As every application of the shader system has it: materials get their programs when they are drawn.
struct ProgramMaker : Ogre::MaterialManager::Listener {
    Ogre::Technique* handleSchemeNotFound(unsigned short, const Ogre::String& scheme,
                                          Ogre::Material* material, unsigned short,
                                          const Ogre::Renderable*) override {
        auto& generator = ShaderGenerator::getSingleton();
        if (scheme != ShaderGenerator::DEFAULT_SCHEME_NAME ||
            !generator.createShaderBasedTechnique(
                *material, Ogre::MaterialManager::DEFAULT_SCHEME_NAME, scheme))
            return nullptr;
        generator.validateMaterial(scheme, material->getName(), material->getGroup());
        return material->getTechniques().back();
    }
};

int main() {
    if (const std::string why = Lixel::Headless::enable(); !why.empty())
        return std::cerr << why << '\n', 1;
    Ogre::Root root("plugins.cfg", "", "shader_system.log");
    root.setRenderSystem(root.getAvailableRenderers().at(0));
    root.initialise(false);
    const auto headless = Lixel::Headless::windowParameters(); // leave out for a real window
    auto* window = root.createRenderWindow("Lixel", 640, 480, false, &headless);
    auto* scene = root.createSceneManager();
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    Ogre::ConfigFile config;
    config.load("resources.cfg");
    for (const auto& [group, locations] : config.getSettingsBySection())
        for (const auto& [type, path] : locations)
            groups.addResourceLocation(path, type, group);
    // OGRE's functions for shaders; 14 has them in the folder above.
    for (const char* folder : {"/RTShaderLib", "/RTShaderLib/GLSL"})
        groups.addResourceLocation(std::string(OGRE_MEDIA_DIR) + folder, "FileSystem",
                                   Ogre::RGN_INTERNAL);

    ShaderGenerator::initialize();
    ShaderGenerator::getSingleton().addSceneManager(scene);
    Lixel::ShaderSystem::enable(ShaderGenerator::getSingleton()); // Lixel: 1
    groups.initialiseAllResourceGroups();
    ProgramMaker maker;
    Ogre::MaterialManager::getSingleton().addListener(&maker);

    const auto place = [&](Ogre::MovableObject* object, const Ogre::Vector3& position) {
        auto* node = scene->getRootSceneNode()->createChildSceneNode(position);
        node->attachObject(object);
        return node;
    };
    auto* ground = scene->createEntity(Ogre::SceneManager::PT_PLANE); // 200 by 200
    auto* ball = scene->createEntity(Ogre::SceneManager::PT_SPHERE);  // radius 50
    const auto white = Ogre::MaterialManager::getSingleton().create("White", Ogre::RGN_DEFAULT);
    for (auto* body : {ground, ball})
        body->setMaterial(white);
    place(ground, {0, 0, 0})->pitch(Ogre::Degree(-90));
    place(ball, {0, 40, 0})->setScale(0.4f, 0.4f, 0.4f);
    auto* sun = scene->createLight();
    sun->setType(Ogre::Light::LT_DIRECTIONAL);
    place(sun, {0, 0, 0})->setDirection(1, -1, 0, Ogre::Node::TS_WORLD);
    auto* camera = scene->createCamera("viewer");
    place(camera, {40, 120, 160})->lookAt({40, 0, 0}, Ogre::Node::TS_WORLD); // at the shadow
    window->addViewport(camera)->setMaterialScheme(ShaderGenerator::DEFAULT_SCHEME_NAME);

    Lixel::ShadowCameraSetupManager::getByName("Lixel/Sun")->applyTo(*sun); // Lixel: 2

    Ogre::Image lit(Ogre::PF_BYTE_RGB, 640, 480), shadowed(lit);
    for (auto* picture : {&lit, &shadowed}) {
        sun->setCastShadows(picture == &shadowed);
        root.renderOneFrame();
        window->copyContentsToMemory({0, 0, 640, 480}, picture->getPixelBox());
    }
    shadowed.save("shadow.png");
    int darker = 0;
    for (int i = 0; i < 640 * 480; ++i)
        darker += shadowed.getData()[3 * i] < lit.getData()[3 * i];
    std::cout << darker << " pixels in shadow; the centre from " << +lit.getData(320, 240)[0]
              << " to " << +shadowed.getData(320, 240)[0] << '\n';
    Ogre::MaterialManager::getSingleton().removeListener(&maker);
    ShaderGenerator::destroy();
}

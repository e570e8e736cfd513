// A ball above the ground, and the shadow that Lixel gives it: application [SCENE_MANAGER_TYPE]
#include <Lixel/headless/Headless.h>
#include <Lixel/material/ShadowMaterials.h>
#include <Lixel/setup/ShadowCameraSetups.h>
#include <Ogre.h>
#include <iostream>

int main(int argc, char** argv) {
    if (const std::string why = Lixel::Headless::enable(); !why.empty())
        return std::cerr << why << '\n', 1;
    Ogre::Root root("plugins.cfg", "", "application.log");
    root.setRenderSystem(root.getAvailableRenderers().at(0));
    root.initialise(false);
    const auto headless = Lixel::Headless::windowParameters(); // leave out for a real window
    auto* window = root.createRenderWindow("Lixel", 640, 480, false, &headless);
    auto* scene = root.createSceneManager(argc > 1 ? argv[1] : "DefaultSceneManager");
    Ogre::ConfigFile config;
    config.load("resources.cfg");
    for (const auto& [group, locations] : config.getSettingsBySection())
        for (const auto& [type, path] : locations)
            Ogre::ResourceGroupManager::getSingleton().addResourceLocation(path, type, group);
    Ogre::ResourceGroupManager::getSingleton().initialiseAllResourceGroups();
    const auto place = [&](Ogre::MovableObject* object, const Ogre::Vector3& position) {
        auto* node = scene->getRootSceneNode()->createChildSceneNode(position);
        node->attachObject(object);
        return node;
    };
    auto* ground = scene->createEntity(Ogre::SceneManager::PT_PLANE); // 200 by 200
    auto* ball = scene->createEntity(Ogre::SceneManager::PT_SPHERE);  // radius 50
    for (auto* body : {ground, ball})
        body->setMaterialName("Lixel/Surface");
    place(ground, {0, 0, 0})->pitch(Ogre::Degree(-90));
    place(ball, {0, 40, 0})->setScale(0.4f, 0.4f, 0.4f);
    auto* sun = scene->createLight();
    sun->setType(Ogre::Light::LT_DIRECTIONAL);
    place(sun, {0, 0, 0})->setDirection(1, -1, 0, Ogre::Node::TS_WORLD);
    auto* camera = scene->createCamera("viewer");
    place(camera, {40, 120, 160})->lookAt({40, 0, 0}, Ogre::Node::TS_WORLD); // at the shadow
    window->addViewport(camera);

    scene->setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE);
    scene->setShadowTextureSettings(1024, 1, Ogre::PF_FLOAT32_R);
    Lixel::setShadowMaterials(*scene, "Lixel/Receiver/Bilinear");
    scene->setShadowTextureSelfShadow(true);
    sun->setCustomShadowCameraSetup(Lixel::XPSMShadowCameraSetup::create());

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
}

#include "TestStage.h"

#include "common/Surface.h"

namespace Lixel::Tests {

LogCollector::LogCollector(std::string only) : mOnly(std::move(only)) {
    Ogre::LogManager::getSingleton().getDefaultLog()->addListener(this);
}

LogCollector::~LogCollector() {
    if (Ogre::LogManager::getSingletonPtr() != nullptr)
        Ogre::LogManager::getSingleton().getDefaultLog()->removeListener(this);
}

void LogCollector::messageLogged(const Ogre::String& message, Ogre::LogMessageLevel, bool,
                                 const Ogre::String&, bool&) {
    if (message.find(mOnly) != std::string::npos) mMessages.push_back(message);
}

std::size_t LogCollector::count(const std::string& text) const {
    std::size_t n = 0;
    for (const std::string& message : mMessages)
        if (message.find(text) != std::string::npos) ++n;
    return n;
}

std::string LogCollector::all() const {
    std::string lines;
    for (const std::string& message : mMessages)
        lines += message + '\n';
    return lines;
}

BoxOnGround::BoxOnGround(const std::string& sceneManagerType, const std::string& setup)
    : stage({.headless = true,
             .width = 320,
             .height = 240,
             .title = "Lixel test",
             .logFile = "",
             .sceneManagerType = sceneManagerType}) {
    Ogre::SceneManager& manager = stage.sceneManager();
    manager.setAmbientLight(Ogre::ColourValue(0.2F, 0.2F, 0.2F));
    manager.setShadowFarDistance(100);

    ground = addCube(Ogre::Vector3(0, -0.5F, 0), Ogre::Vector3(200, 1, 200));
    ground->getAttachedObject(0)->setCastShadows(false);
    box = addCube(Ogre::Vector3(0, 1, 0), Ogre::Vector3(2, 2, 2));

    Ogre::SceneNode* const viewer = stage.camera().getParentSceneNode();
    stage.camera().setNearClipDistance(0.1F);
    stage.camera().setFarClipDistance(1000);
    viewer->setPosition(0, 8, 16);
    viewer->lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);

    stage.light().setType(Ogre::Light::LT_DIRECTIONAL);
    stage.light().getParentSceneNode()->setDirection(Ogre::Vector3(-1, -1, 0.0F),
                                                     Ogre::Node::TS_WORLD);
    stage.setShadowSetup(Samples::findShadowSetup(setup)->create());
}

Ogre::SceneNode* BoxOnGround::addCube(const Ogre::Vector3& position, const Ogre::Vector3& size) {
    Ogre::SceneManager& manager = stage.sceneManager();
    const std::string name = "Cube" + std::to_string(mCubes++);
    // OGRE's prefab cube has sides of 100.
    Ogre::Entity* const entity = manager.createEntity(name, Ogre::SceneManager::PT_CUBE);
    entity->setMaterial(Samples::makeSurface(name, Ogre::ColourValue(0.8F, 0.8F, 0.8F)));
    Ogre::SceneNode* const node = manager.getRootSceneNode()->createChildSceneNode(position);
    node->setScale(size / 100);
    node->attachObject(entity);
    return node;
}

Samples::ClassificationError BoxOnGround::nextFrameError() {
    const Samples::ShadowOracle oracle(Samples::collectTriangles(stage.sceneManager()));
    return Samples::measureError(stage, oracle,
                                 static_cast<double>(stage.sceneManager().getShadowFarDistance()));
}

Ogre::Vector2 BoxOnGround::pictureOf(const Ogre::Vector3& ws) {
    const Ogre::Vector3 ndc =
        stage.camera().getProjectionMatrix() * (stage.camera().getViewMatrix() * ws);
    return {(ndc.x + 1) / 2 * static_cast<float>(stage.window().getWidth()),
            (1 - ndc.y) / 2 * static_cast<float>(stage.window().getHeight())};
}

std::size_t BoxOnGround::pixelOf(const Ogre::Vector3& ws) {
    const Ogre::Vector2 place = pictureOf(ws);
    return static_cast<std::size_t>(place.y) * stage.window().getWidth() +
           static_cast<std::size_t>(place.x);
}

int BoxOnGround::visibilityAt(const Ogre::Vector3& world) {
    const std::vector<std::uint8_t> visibility = stage.drawVisibility();
    const Ogre::Vector2 place = pictureOf(world);
    const int column = static_cast<int>(place.x);
    const int row = static_cast<int>(place.y);
    const int width = static_cast<int>(stage.window().getWidth());
    const int height = static_cast<int>(stage.window().getHeight());
    if (column < 0 || column >= width || row < 0 || row >= height) return -1;
    return visibility[static_cast<std::size_t>(row * width + column)];
}

} // namespace Lixel::Tests

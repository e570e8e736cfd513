#include "DrawingOgre.h"

#include <Lixel/headless/Headless.h>

#include <OgreCamera.h>
#include <OgreLogManager.h>
#include <OgreManualObject.h>
#include <OgreResourceGroupManager.h>
#include <OgreSceneNode.h>
#include <OgreViewport.h>

#include <unistd.h>

#include <fstream>
#include <stdexcept>

namespace Lixel::Tests {

DrawingOgre::DrawingOgre(const RenderPath& path)
    : mFolder(std::filesystem::temp_directory_path() / ("lixel-cg-" + std::to_string(getpid()))) {
    std::filesystem::remove_all(mFolder);
    std::filesystem::create_directories(mFolder);
    unsetenv("DISPLAY");
    if (const std::string error = Headless::enable(); !error.empty())
        throw std::runtime_error(error);
    // Made before Root, which would else write Ogre.log.
    mLogs = std::make_unique<Ogre::LogManager>();
    mLogs->createLog("", true, false, true)->addListener(this);
    mRoot = std::make_unique<Ogre::Root>("", "", "");
    mRoot->loadPlugin(OGRE_PLUGIN_DIR "/" + std::string(path.plugin));
    mRoot->loadPlugin(LIXEL_PLUGIN_DIR "/Plugin_LixelCg.so");
    Ogre::RenderSystem& system = *mRoot->getAvailableRenderers().front();
    mRoot->setRenderSystem(&system);
    if (system.getConfigOptions().count("Separate Shader Objects") != 0)
        system.setConfigOption("Separate Shader Objects", path.separateShaders ? "Yes" : "No");
    mRoot->initialise(false);
    Ogre::NameValuePairList parameters;
    for (const auto& [name, value] : Headless::windowParameters())
        parameters[name] = value;
    mWindow = mRoot->createRenderWindow("window", Side, Side, false, &parameters);
    makeScene();
}

DrawingOgre::~DrawingOgre() {
    mRoot.reset();
    mLogs->getDefaultLog()->removeListener(this);
    std::filesystem::remove_all(mFolder);
}

void DrawingOgre::makeScene() {
    mScene = mRoot->createSceneManager();
    Ogre::Camera* camera = mScene->createCamera("camera");
    mScene->getRootSceneNode()->attachObject(camera);
    mWindow->addViewport(camera)->setBackgroundColour(Ogre::ColourValue::Black);
    mRectangle = makeRectangle("BaseWhite");
    mScene->getRootSceneNode()->attachObject(mRectangle);
}

Ogre::ManualObject* DrawingOgre::makeRectangle(const std::string& material) {
    Ogre::ManualObject* rectangle = mScene->createManualObject();
    rectangle->begin(material, Ogre::RenderOperation::OT_TRIANGLE_STRIP);
    for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, std::pair{1.0F, -1.0F},
                               std::pair{-1.0F, 1.0F}, std::pair{1.0F, 1.0F}}) {
        rectangle->position(x, y, 0.5F);
        rectangle->normal(0, 0, 1);
        rectangle->colour(0.2F, 0.4F, 0.6F);
        rectangle->textureCoord((x + 1) / 2, (y + 1) / 2);
    }
    rectangle->end();
    rectangle->setUseIdentityProjection(true);
    rectangle->setUseIdentityView(true);
    rectangle->setBoundingBox(Ogre::AxisAlignedBox::BOX_INFINITE);
    return rectangle;
}

Ogre::SceneNode& DrawingOgre::addRectangle(const std::string& material) {
    Ogre::SceneNode* node = mScene->getRootSceneNode()->createChildSceneNode();
    node->attachObject(makeRectangle(material));
    return *node;
}

void DrawingOgre::write(const std::string& file, const std::string& text) const {
    std::ofstream(mFolder / file) << text;
}

void DrawingOgre::readScripts() const {
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    groups.addResourceLocation(mFolder.string(), "FileSystem");
    groups.initialiseAllResourceGroups();
}

const std::vector<std::uint8_t>& DrawingOgre::picture(const std::string& material) {
    mRectangle->setMaterialName(0, material);
    mRoot->renderOneFrame();
    mPicture.resize(std::size_t{3} * Side * Side);
    mWindow->copyContentsToMemory(
        Ogre::Box(0, 0, Side, Side),
        Ogre::PixelBox(Side, Side, 1, Ogre::PF_BYTE_RGB, mPicture.data()));
    return mPicture;
}

Pixel DrawingOgre::draw(const std::string& material) {
    picture(material);
    return pixel(Side / 2, Side / 2);
}

Pixel DrawingOgre::pixel(unsigned column, unsigned row) const {
    const std::uint8_t* rgb = &mPicture[std::size_t{3} * (row * Side + column)];
    return {rgb[0], rgb[1], rgb[2]};
}

void DrawingOgre::clearLog() {
    const std::lock_guard lock(mLogging);
    mLines.clear();
}

std::string DrawingOgre::logged(const std::string& text) const {
    const std::lock_guard lock(mLogging);
    std::string lines;
    for (const std::string& line : mLines)
        if (line.find(text) != std::string::npos) lines += line + '\n';
    return lines;
}

void DrawingOgre::messageLogged(const Ogre::String& message, Ogre::LogMessageLevel, bool,
                                const Ogre::String&, bool&) {
    const std::lock_guard lock(mLogging);
    mLines.push_back(message);
}

} // namespace Lixel::Tests

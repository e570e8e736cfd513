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
    mRectangle = mScene->createManualObject("rectangle");
    mRectangle->begin("BaseWhite", Ogre::RenderOperation::OT_TRIANGLE_STRIP);
    for (const auto& [x, y] :
         {std::pair{-1, -1}, std::pair{1, -1}, std::pair{-1, 1}, std::pair{1, 1}}) {
        mRectangle->position(static_cast<float>(x), static_cast<float>(y), 0.5F);
        mRectangle->normal(0, 0, 1);
        mRectangle->colour(0.2F, 0.4F, 0.6F);
        mRectangle->textureCoord(static_cast<float>(x + 1) / 2, static_cast<float>(y + 1) / 2);
    }
    mRectangle->end();
    mRectangle->setUseIdentityProjection(true);
    mRectangle->setUseIdentityView(true);
    mRectangle->setBoundingBox(Ogre::AxisAlignedBox::BOX_INFINITE);
    mScene->getRootSceneNode()->attachObject(mRectangle);
}

void DrawingOgre::write(const std::string& file, const std::string& text) const {
    std::ofstream(mFolder / file) << text;
}

void DrawingOgre::readScripts() const {
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    groups.addResourceLocation(mFolder.string(), "FileSystem");
    groups.initialiseAllResourceGroups();
}

std::vector<std::uint8_t> DrawingOgre::picture(const std::string& material) {
    mRectangle->setMaterialName(0, material);
    mRoot->renderOneFrame();
    std::vector<std::uint8_t> rgb(std::size_t{3} * Side * Side);
    mWindow->copyContentsToMemory(Ogre::Box(0, 0, Side, Side),
                                  Ogre::PixelBox(Side, Side, 1, Ogre::PF_BYTE_RGB, rgb.data()));
    return rgb;
}

Pixel DrawingOgre::draw(const std::string& material) {
    const auto rgb = picture(material);
    const std::uint8_t* middle = &rgb[std::size_t{3} * (Side / 2 * Side + Side / 2)];
    return {middle[0], middle[1], middle[2]};
}

std::string DrawingOgre::logged(const std::string& text) const {
    std::string lines;
    for (const std::string& line : mLines)
        if (line.find(text) != std::string::npos) lines += line + '\n';
    return lines;
}

void DrawingOgre::messageLogged(const Ogre::String& message, Ogre::LogMessageLevel, bool,
                                const Ogre::String&, bool&) {
    mLines.push_back(message);
}

} // namespace Lixel::Tests

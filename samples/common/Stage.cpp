#include "common/Stage.h"

#include <Lixel/headless/Headless.h>
#include <Lixel/material/ShadowMaterials.h>
#include <Lixel/setup/MeshPreparation.h>

#include <OgreConfigFile.h>
#include <OgreLogManager.h>

#define GLFW_INCLUDE_NONE
#define GLFW_EXPOSE_NATIVE_X11
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>

#include <filesystem>
#include <stdexcept>

// Answered by libGL with a window, by OSMesa when headless.
extern "C" void (*glXGetProcAddressARB(const unsigned char*))();

namespace Lixel::Samples {
namespace {

const char* const ShownReceiver = "Lixel/Receiver/Bilinear";

constexpr unsigned GlRenderer = 0x1F01; // GL_RENDERER

template <typename Function>
Function* glFunction(const char* name) {
    return reinterpret_cast<Function*>(
        glXGetProcAddressARB(reinterpret_cast<const unsigned char*>(name)));
}

/// Adds what resources.cfg lists: "[group]" sections of "type=path".
void addResources(const std::string& file) {
    Ogre::ConfigFile config;
    config.load(file);
    for (const auto& [group, settings] : config.getSettingsBySection())
        for (const auto& [type, path] : settings)
            Ogre::ResourceGroupManager::getSingleton().addResourceLocation(
                path, type, group.empty() ? "General" : group);
}

} // namespace

std::string programFolder() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path().string();
}

Stage::Stage(const StageOptions& options) {
    const std::string error = options.headless ? Headless::enable() : "";
    if (!error.empty()) throw std::runtime_error(error);

    try {
        open(options);
    } catch (const Ogre::Exception& exception) {
        // Its type may live in a plugin, which Root takes away while this object is unwound.
        throw std::runtime_error(exception.getDescription());
    }
}

void Stage::open(const StageOptions& options) {
    mLogManager = std::make_unique<Ogre::LogManager>();
    mLogManager->createLog(options.logFile, true, false, options.logFile.empty());
    mRoot = std::make_unique<Ogre::Root>(programFolder() + "/plugins.cfg", "", "");
    if (mRoot->getAvailableRenderers().empty())
        throw std::runtime_error("plugins.cfg names no render system that can be loaded");
    mRoot->setRenderSystem(mRoot->getAvailableRenderers().front());
    mRoot->initialise(false);
    openWindow(options);

    addResources(programFolder() + "/resources.cfg");
    // Before scripts are parsed: shadows need OGRE's own programs from RGN_INTERNAL.
    mSceneManager = options.sceneManagerType.empty()
                        ? mRoot->createSceneManager()
                        : mRoot->createSceneManager(options.sceneManagerType);
    Ogre::ResourceGroupManager::getSingleton().initialiseAllResourceGroups();
    furnish();
}

void Stage::clear() {
    const Ogre::String type = mSceneManager->getTypeName();
    mWindow->removeAllViewports();
    mRoot->destroySceneManager(mSceneManager);
    // All but OGRE's prefabs, which it never makes again.
    auto& meshes = Ogre::MeshManager::getSingleton();
    std::vector<Ogre::String> names;
    for (const auto& [handle, mesh] : meshes.getResourceIterator())
        if (!mesh->getName().starts_with("Prefab_")) names.push_back(mesh->getName());
    for (const Ogre::String& name : names)
        meshes.remove(name, Ogre::RGN_AUTODETECT);
    mSceneManager = mRoot->createSceneManager(type);
    furnish();
}

void Stage::furnish() {
    mCamera = mSceneManager->createCamera("Viewer");
    mSceneManager->getRootSceneNode()->createChildSceneNode()->attachObject(mCamera);
    mViewport = mWindow->addViewport(mCamera);
    mCamera->setAspectRatio(Ogre::Real(mViewport->getActualWidth()) /
                            Ogre::Real(mViewport->getActualHeight()));
    mLight = mSceneManager->createLight("Light");
    mSceneManager->getRootSceneNode()->createChildSceneNode()->attachObject(mLight);

    mSceneManager->setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE);
    setShadowMaterials(*mSceneManager, ShownReceiver);
    mSceneManager->setShadowTextureSelfShadow(true);
    setShadowMapSize(1024);
}

Stage::~Stage() = default;

void Stage::CloseGlfwWindow::operator()(GLFWwindow* window) const {
    glfwDestroyWindow(window);
    glfwTerminate();
}

void Stage::openWindow(const StageOptions& options) {
    Ogre::NameValuePairList parameters;
    if (options.headless) {
        for (const auto& [name, value] : Headless::windowParameters())
            parameters[name] = value;
    } else {
        if (glfwInit() == GLFW_FALSE)
            throw std::runtime_error("no window can be opened: is DISPLAY set to an X server?");
        // OGRE makes its own context in our window.
        glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
        mGlfwWindow.reset(glfwCreateWindow(options.width, options.height, options.title.c_str(),
                                           nullptr, nullptr));
        if (!mGlfwWindow) {
            glfwTerminate();
            throw std::runtime_error("GLFW could not open a window");
        }
        parameters["parentWindowHandle"] = std::to_string(glfwGetX11Window(mGlfwWindow.get()));
    }
    mWindow = mRoot->createRenderWindow(options.title, static_cast<unsigned>(options.width),
                                        static_cast<unsigned>(options.height), false, &parameters);
}

void Stage::show(const SampleScene& scene) {
    scene.build(*mSceneManager);
    // Read mesh shapes now, so early frames are fitted as well as later ones.
    for (const auto& [name, object] : mSceneManager->getMovableObjects("Entity"))
        Lixel::prepareMesh(static_cast<Ogre::Entity*>(object)->getMesh());
    mSceneManager->setAmbientLight(scene.ambient);
    mSceneManager->setShadowFarDistance(scene.shadowDistance);
    mViewport->setBackgroundColour(scene.background);
    setView(scene.views.front());
    setLight(defaultLight(scene, scene.views.front()));
}

void Stage::setView(const SampleView& view) {
    applyView(view, *mCamera);
}

void Stage::setLight(const SampleLight& light) {
    applyLight(light, *mLight);
}

void Stage::setShadowSetup(const Ogre::ShadowCameraSetupPtr& setup) {
    mLight->setCustomShadowCameraSetup(setup);
}

void Stage::setShadowMapSize(int texels) {
    mSceneManager->setShadowTextureSettings(static_cast<unsigned short>(texels), 1,
                                            Ogre::PF_FLOAT32_R);
}

void Stage::drawFrame() {
    mRoot->renderOneFrame();
}

std::vector<std::uint8_t> Stage::picture() {
    std::vector<std::uint8_t> bytes(std::size_t{3} * mWindow->getWidth() * mWindow->getHeight());
    const Ogre::Box box(0, 0, mWindow->getWidth(), mWindow->getHeight());
    mWindow->copyContentsToMemory(box, Ogre::PixelBox(box, Ogre::PF_BYTE_RGB, bytes.data()));
    return bytes;
}

std::vector<std::uint8_t> Stage::drawVisibility() {
    const Ogre::ColourValue ambient = mSceneManager->getAmbientLight();
    mSceneManager->setAmbientLight(Ogre::ColourValue::Black);
    auto& materials = Ogre::MaterialManager::getSingleton();
    mSceneManager->setShadowTextureReceiverMaterial(
        materials.getByName("Lixel/Receiver/Visibility"));
    drawFrame();
    const std::vector<std::uint8_t> rgb = picture();
    mSceneManager->setShadowTextureReceiverMaterial(materials.getByName(ShownReceiver));
    mSceneManager->setAmbientLight(ambient);

    std::vector<std::uint8_t> visibility(rgb.size() / 3);
    for (std::size_t i = 0; i < visibility.size(); ++i)
        visibility[i] = rgb[3 * i];
    return visibility;
}

void Stage::finish() {
    glFunction<void()>("glFinish")();
}

std::string Stage::glRenderer() {
    const unsigned char* name =
        glFunction<const unsigned char*(unsigned)>("glGetString")(GlRenderer);
    return name != nullptr ? reinterpret_cast<const char*>(name) : "unknown";
}

} // namespace Lixel::Samples

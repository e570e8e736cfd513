#include "common/Stage.h"

#include "common/ResourceFile.h"
#include "common/VisibilitySurfaces.h"
#ifdef LIXEL_SAMPLES_RTSS
#include "common/ShaderSystemStage.h"
#endif

#include <Lixel/headless/Headless.h>
#include <Lixel/material/ShadowMaterials.h>
#include <Lixel/script/ShadowCameraSetupManager.h>
#include <Lixel/setup/FittedShadowCameraSetup.h>
#include <Lixel/setup/MeshPreparation.h>

#include <OgreLogManager.h>

#define GLFW_INCLUDE_NONE
#define GLFW_EXPOSE_NATIVE_X11
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>

#include <algorithm>
#include <filesystem>
#include <optional>
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

/** What a light adds to each pixel, as a part of what it adds without shadows: 0 to 255, and 0
    where that is nothing. It is that of the channel to which the light adds most.
    @param shadowed, lit, dark RGB bytes: with shadows, without shadows, and without the light
    @param[out] isLit if not null, which pixels the light adds enough to for a part to be told
*/
std::vector<std::uint8_t> shareOfLight(const std::vector<std::uint8_t>& shadowed,
                                       const std::vector<std::uint8_t>& lit,
                                       const std::vector<std::uint8_t>& dark,
                                       std::vector<bool>* isLit) {
    constexpr int LeastLight = 8; // of 255: a half is then told to a sixteenth
    std::vector<std::uint8_t> shares(lit.size() / 3);
    if (isLit != nullptr) isLit->assign(shares.size(), false);
    for (std::size_t pixel = 0; pixel < shares.size(); ++pixel) {
        int most = 0;
        for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
            const int added = lit[i] - dark[i];
            if (added <= most) continue;
            most = added;
            const int there = std::clamp(shadowed[i] - dark[i], 0, added);
            shares[pixel] = static_cast<std::uint8_t>((255 * there + added / 2) / added);
        }
        if (isLit != nullptr) (*isLit)[pixel] = most >= LeastLight;
    }
    return shares;
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

    addResources(programFolder() + "/resources.cfg",
                 [](const std::string& group) { return group != MediaGroup; });
    // Before scripts are parsed: shadows need OGRE's own programs from RGN_INTERNAL.
    mSceneManager = options.sceneManagerType.empty()
                        ? mRoot->createSceneManager()
                        : mRoot->createSceneManager(options.sceneManagerType);
    Ogre::ResourceGroupManager::getSingleton().initialiseAllResourceGroups();
    furnish();
}

void Stage::clear() {
    const Ogre::String type = mSceneManager->getTypeName();
    mShaderSystem.reset();
    mUsesPresets = false;
    mSunMaps = mLampMaps = 1;
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
    if (scene.shaderSystem) startShaderSystem();
    mUsesPresets = scene.shaderSystem;
    scene.build(*mSceneManager);
    // Read mesh shapes now, so early frames are fitted as well as later ones.
    for (const auto& [name, object] : mSceneManager->getMovableObjects("Entity"))
        Lixel::prepareMesh(static_cast<Ogre::Entity*>(object)->getMesh());
    mSky = scene.sky;
    mSceneManager->setShadowFarDistance(scene.shadowDistance);
    setView(scene.views.front());
    setLight(defaultLight(scene, scene.views.front()));
}

void Stage::startShaderSystem() {
#ifdef LIXEL_SAMPLES_RTSS
    mSceneManager->setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
    mShaderSystem.reset(); // there is one shader system
    mShaderSystem = std::make_shared<ShaderSystemStage>(programFolder() + "/resources.cfg",
                                                        MediaGroup, *mSceneManager, *mViewport);
#else
    throw std::runtime_error("this program was built without OGRE's shader system");
#endif
}

void Stage::setView(const SampleView& view) {
    const SampleSky& sky = view.sky ? *view.sky : mSky;
    mSceneManager->setAmbientLight(sky.ambient);
    mViewport->setBackgroundColour(sky.background);
    applyView(view, *mCamera);
}

void Stage::setLight(const SampleLight& light) {
    applyLight(light, *mLight);
    mLightPreset = light.shadowPreset;
    updateMaps();
}

void Stage::setShadowSetup(const Ogre::ShadowCameraSetupPtr& setup, std::size_t sunMaps) {
    mUsesPresets = false;
    mSunMaps = sunMaps;
    // One for each side; OGRE's own setups would make the same six times.
    mLampMaps = dynamic_cast<const FittedShadowCameraSetup*>(setup.get()) != nullptr ? 6 : 1;
    mLight->setCustomShadowCameraSetup(setup);
    updateMaps();
}

void Stage::usePresets() {
    mUsesPresets = mShaderSystem != nullptr;
    updateMaps();
}

void Stage::setShadowMapSize(int texels) {
    mMapSize = texels;
    std::size_t maps = 1;
    if (mShaderSystem) maps = mSceneManager->getShadowTextureCountPerLightType(mLight->getType());
    mSceneManager->setShadowTextureSettings(static_cast<unsigned short>(texels),
                                            static_cast<unsigned short>(maps), Ogre::PF_FLOAT32_R);
}

void Stage::updateMaps() {
    if (!mShaderSystem) return;
    mSceneManager->setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL, mSunMaps);
    mSceneManager->setShadowTextureCountPerLightType(Ogre::Light::LT_POINT, mLampMaps);
    if (mUsesPresets && !mLightPreset.empty())
        ShadowCameraSetupManager::getByName(mLightPreset)->applyTo(*mLight);
    setShadowMapSize(mMapSize);
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

std::vector<std::uint8_t> Stage::drawVisibility(std::vector<bool>* isLit) {
    if (mShaderSystem) return visibilityOfBrightness(isLit);
    const Ogre::ColourValue ambient = mSceneManager->getAmbientLight();
    mSceneManager->setAmbientLight(Ogre::ColourValue::Black);
    auto& materials = Ogre::MaterialManager::getSingleton();
    mSceneManager->setShadowTextureReceiverMaterial(
        materials.getByName("Lixel/Receiver/Visibility"));
    std::optional<VisibilitySurfaces> surfaces;
    if (mSceneManager->isShadowTechniqueIntegrated()) surfaces.emplace(*mSceneManager);
    drawFrame();
    const std::vector<std::uint8_t> rgb = picture();
    mSceneManager->setShadowTextureReceiverMaterial(materials.getByName(ShownReceiver));
    mSceneManager->setAmbientLight(ambient);

    std::vector<std::uint8_t> visibility(rgb.size() / 3);
    for (std::size_t i = 0; i < visibility.size(); ++i)
        visibility[i] = rgb[3 * i];
    if (isLit != nullptr) isLit->assign(visibility.size(), true);
    return visibility;
}

std::vector<std::uint8_t> Stage::visibilityOfBrightness(std::vector<bool>* isLit) {
    const Ogre::ColourValue ambient = mSceneManager->getAmbientLight();
    const Ogre::ColourValue diffuse = mLight->getDiffuseColour();
    const Ogre::ColourValue specular = mLight->getSpecularColour();
    const auto draw = [&] {
        drawFrame();
        return picture();
    };
    mSceneManager->setAmbientLight(Ogre::ColourValue::Black);
    const std::vector<std::uint8_t> shadowed = draw();
    mLight->setCastShadows(false);
    const std::vector<std::uint8_t> lit = draw();
    // Not hidden: the shader system would make all programs anew for another number of lights.
    mLight->setDiffuseColour(Ogre::ColourValue::Black);
    mLight->setSpecularColour(Ogre::ColourValue::Black);
    const std::vector<std::uint8_t> dark = draw();
    mLight->setDiffuseColour(diffuse);
    mLight->setSpecularColour(specular);
    mLight->setCastShadows(true);
    mSceneManager->setAmbientLight(ambient);
    return shareOfLight(shadowed, lit, dark, isLit);
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

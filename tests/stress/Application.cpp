#include "Application.h"

#include "common/MeshBuilder.h"

#include <Lixel/scene/OgreVersions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace Lixel::Tests {
namespace {

constexpr int Width = 192;
constexpr int Height = 96;
const char* const MeshGroup = "Stress";
const char* const Receives = "Stress/Receives";
const char* const Ignores = "Stress/Ignores";

/// Which of Lixel's surfaces a technique wants.
const char* surfaceOf(Ogre::ShadowTechnique technique) {
    return technique == Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED
               ? "Lixel/Surface/Integrated/Maps6"
               : "Lixel/Surface";
}

std::string suffixOf(Ogre::ShadowTechnique technique) {
    if (technique == Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED) return "/Integrated";
    return (technique & Ogre::SHADOWDETAILTYPE_MODULATIVE) != 0 ? "/White" : "";
}

/// White where the light shines, or white everywhere where shadows darken what is there.
Ogre::MaterialPtr surface(const std::string& base, Ogre::ShadowTechnique technique) {
    Ogre::MaterialManager& materials = Ogre::MaterialManager::getSingleton();
    const std::string suffix = suffixOf(technique);
    const Ogre::MaterialPtr known = materials.getByName(base + suffix);
    if (known) return known;
    Ogre::MaterialPtr made = materials.create(base + suffix, "General");
    materials.getByName(surfaceOf(technique), "General")->copyDetailsTo(made);
    const bool white = suffix == "/White";
    for (Ogre::Pass* pass : made->getTechnique(0)->getPasses()) {
        const bool ambient = pass->getName() == "Ambient";
        pass->setAmbient(Ogre::ColourValue::Black);
        pass->setDiffuse(white ? Ogre::ColourValue::Black : Ogre::ColourValue::White);
        pass->setSelfIllumination(white && ambient ? Ogre::ColourValue::White
                                                   : Ogre::ColourValue::Black);
    }
    made->setReceiveShadows(base == Receives);
    return made;
}

/// Closed solids, since what OGRE draws of casters is their backs, and with flat sides, whose
/// shading goes with the truth's geometric normals.
void writeMeshes(const std::string& folder) {
    Samples::MeshBuilder rod;
    rod.transform = Ogre::Affine3(
        Ogre::Vector3::ZERO,
        Ogre::Quaternion(Ogre::Degree(40), Ogre::Vector3(1, 0.3F, 0.5F).normalisedCopy()));
    rod.box({-3, -0.25F, -0.25F}, {3, 0.25F, 0.25F});
    Samples::MeshBuilder table;
    table.box({-1.5F, 1, -1}, {1.5F, 1.2F, 1});
    for (const float x : {-1.4F, 1.0F})
        table.boxOn({x + 0.2F, -1, 0}, 0.4F, 2, 0.4F);
    Samples::MeshBuilder box;
    box.box({-1, -1, -1}, {1, 1, 1});
    Ogre::MeshSerializer serializer;
    for (const auto& [name, builder] :
         {std::pair{"rod.mesh", &rod}, std::pair{"table.mesh", &table},
          std::pair{"box.mesh", &box}}) {
        const Ogre::MeshPtr mesh = builder->build("Temporary");
        mesh->getSubMesh(0)->setMaterialName("BaseWhite");
        serializer.exportMesh(mesh.get(), folder + "/" + name);
        Ogre::MeshManager::getSingleton().remove(mesh);
    }
}

} // namespace

const std::vector<std::string>& Application::meshes() {
    static const std::vector<std::string> names{"rod.mesh", "table.mesh", "box.mesh",
                                                "Prefab_Cube"};
    return names;
}

Ogre::Vector3 Application::unitScale(const Ogre::Entity& body) {
    return Ogre::Vector3(body.getMesh()->getName() == "Prefab_Cube" ? 0.02F : 1.0F);
}

Application::Application() {
    std::string pattern = (std::filesystem::temp_directory_path() / "lixel-stress-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    mFolder = pattern;
    begin();
}

Application::~Application() {
    end();
    std::filesystem::remove_all(mFolder);
}

void Application::begin() {
    mStage = std::make_unique<Samples::Stage>(Samples::StageOptions{
        .headless = true, .width = Width, .height = Height, .title = newName("Window")});
    stage().window().removeAllViewports();
    writeMeshes(mFolder);
    auto& resources = Ogre::ResourceGroupManager::getSingleton();
    resources.addResourceLocation(mFolder, "FileSystem", MeshGroup);
    resources.initialiseResourceGroup(MeshGroup);
    // What OGRE adds to modulative receivers of its own setups' spots; part of its samples' media.
    Ogre::Image white;
    std::array<Ogre::uchar, 3> pixel{255, 255, 255};
    white.loadDynamicImage(pixel.data(), 1, 1, Ogre::PF_BYTE_RGB);
    Ogre::TextureManager::getSingleton().loadImage("spot_shadow_fade.dds", "General", white);
    pluginLoaded = true;
    screens.push_back({&stage().window(), {}});
    addShadowMapObserver(*this);
    for (const auto technique :
         {Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, Ogre::SHADOWTYPE_TEXTURE_MODULATIVE,
          Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED})
        for (const char* const base : {Receives, Ignores})
            surface(base, technique);
    World& world = addWorld("");
    for (const std::string& mesh : meshes())
        addBody(world, mesh);
    Lamp* const lamp = addLamp(world, newName("Light"));
    const auto recipe = std::make_shared<SetupRecipe>(SetupRecipe{1, 1});
    setups.push_back({recipe->make(), recipe});
    setUp(*lamp, setups.back());
    show(screens.front(), {&addCamera(world)});
}

void Application::end() {
    removeShadowMapObserver(*this);
    while (screens.size() > 1)
        removeTexture(1);
    stage().window().removeAllViewports();
    screens.clear();
    while (!worlds.empty())
        removeWorld(0);
    setups.clear();
    mTold.clear();
    mStage.reset();
}

void Application::restart() {
    end();
    begin();
}

World& Application::addWorld(const std::string& type) {
    const std::string name = newName("World");
    worlds.push_back(std::make_unique<World>());
    World& world = *worlds.back();
    world.manager =
        type.empty() ? root().createSceneManager() : root().createSceneManager(type, name);
    world.manager->setAmbientLight(Ogre::ColourValue::Black);
    world.manager->setShadowColour(Ogre::ColourValue::Black);
    world.manager->setShadowTextureSelfShadow(true);
    world.manager->setShadowFarDistance(60);
    world.manager->setShadowTextureSettings(512, 1, Ogre::PF_FLOAT32_R);
    setTechnique(world, Ogre::SHADOWTYPE_TEXTURE_ADDITIVE);
    Ogre::Entity& ground = addBody(world, "Prefab_Cube");
    ground.setCastShadows(false);
    ground.getParentSceneNode()->setPosition(0, -0.5F, 0);
    ground.getParentSceneNode()->setScale(0.4F, 0.01F, 0.4F);
    // The first body stays where it is: the ground.
    return world;
}

void Application::removeWorld(std::size_t index) {
    World& world = *worlds[index];
    for (Ogre::Camera* const camera : std::vector(world.cameras))
        removeCamera(world, camera);
    root().destroySceneManager(world.manager);
    worlds.erase(worlds.begin() + static_cast<std::ptrdiff_t>(index));
}

Ogre::Entity& Application::addBody(World& world, const std::string& mesh) {
    const bool prefab = mesh == "Prefab_Cube";
    Ogre::Entity* const entity =
        prefab ? world.manager->createEntity(newName("Body"), Ogre::SceneManager::PT_CUBE)
               : world.manager->createEntity(newName("Body"), mesh, MeshGroup);
    Ogre::SceneNode* const node = world.manager->getRootSceneNode()->createChildSceneNode();
    node->setScale(unitScale(*entity));
    const float step = static_cast<float>(world.bodies.size());
    node->setPosition(std::fmod(step * 3.7F, 12.0F) - 6, 1.5F, std::fmod(step * 2.3F, 10.0F) - 5);
    node->attachObject(entity);
    entity->setMaterial(surface(Receives, world.technique));
    world.bodies.push_back(entity);
    return *entity;
}

Lamp* Application::addLamp(World& world, const std::string& name) {
    if (world.lamps.size() == World::MostLamps) return nullptr;
    std::size_t channel = 0;
    const auto taken = [&] {
        return std::any_of(world.lamps.begin(), world.lamps.end(),
                           [&](const Lamp& lamp) { return lamp.channel == channel; });
    };
    while (taken())
        ++channel;
    Ogre::Light* const light = world.manager->createLight(name);
    Ogre::ColourValue colour = Ogre::ColourValue::Black;
    colour[channel] = 1;
    light->setDiffuseColour(colour);
    light->setSpecularColour(Ogre::ColourValue::Black);
    light->setType(Ogre::Light::LT_DIRECTIONAL);
    light->setAttenuation(1000, 1, 0, 0);
    light->setShadowNearClipDistance(0.05F);
    Ogre::SceneNode* const node = world.manager->getRootSceneNode()->createChildSceneNode();
    node->attachObject(light);
    node->setPosition(3, 9, 2);
    node->setDirection(Ogre::Vector3(-1, -2, 0.5F), Ogre::Node::TS_WORLD);
    world.lamps.push_back({light, channel, {}});
    return &world.lamps.back();
}

Ogre::Camera& Application::addCamera(World& world) {
    Ogre::Camera* const camera = world.manager->createCamera(newName("Camera"));
    camera->setNearClipDistance(0.1F);
    camera->setFarClipDistance(200);
    Ogre::SceneNode* const node = world.manager->getRootSceneNode()->createChildSceneNode();
    node->attachObject(camera);
    node->setPosition(0, 8, 14);
    node->lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);
    world.cameras.push_back(camera);
    return *camera;
}

void Application::removeCamera(World& world, Ogre::Camera* camera) {
    for (Screen& screen : screens) {
        std::vector<Ogre::Camera*> left;
        for (unsigned short i = 0; i < screen.target->getNumViewports(); ++i)
            if (Ogre::Camera* const shown = screen.target->getViewport(i)->getCamera();
                shown != camera)
                left.push_back(shown);
        if (left.size() != screen.target->getNumViewports()) show(screen, left);
    }
    std::erase(world.cameras, camera);
    world.manager->destroyCamera(camera);
}

void Application::addTexture() {
    const Ogre::TexturePtr texture = Ogre::TextureManager::getSingleton().createManual(
        newName("Picture"), "General", Ogre::TEX_TYPE_2D, Width, Height, 0, Ogre::PF_BYTE_RGB,
        Ogre::TU_RENDERTARGET);
    Ogre::RenderTarget* const target = texture->getBuffer()->getRenderTarget();
    screens.push_back({target, texture});
}

void Application::removeTexture(std::size_t index) {
    screens[index].target->removeAllViewports();
    Ogre::TextureManager::getSingleton().remove(screens[index].texture);
    screens.erase(screens.begin() + static_cast<std::ptrdiff_t>(index));
}

void Application::show(Screen& screen, const std::vector<Ogre::Camera*>& cameras) {
    screen.target->removeAllViewports();
    const float share = 1.0F / static_cast<float>(std::max<std::size_t>(cameras.size(), 1));
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        Ogre::Viewport* const viewport = screen.target->addViewport(
            cameras[i], static_cast<int>(i), share * static_cast<float>(i), 0, share, 1);
        viewport->setOverlaysEnabled(false);
        cameras[i]->setAspectRatio(static_cast<float>(viewport->getActualWidth()) /
                                   static_cast<float>(viewport->getActualHeight()));
    }
}

void Application::setTechnique(World& world, Ogre::ShadowTechnique technique) {
    Ogre::MaterialManager& materials = Ogre::MaterialManager::getSingleton();
    world.technique = technique;
    world.manager->setShadowTechnique(technique);
    world.manager->setShadowTextureCasterMaterial(materials.getByName("Lixel/Caster", "General"));
    const bool modulative = (technique & Ogre::SHADOWDETAILTYPE_MODULATIVE) != 0;
    world.manager->setShadowTextureReceiverMaterial(
        technique == Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED
            ? Ogre::MaterialPtr()
            : materials.getByName(modulative ? "Lixel/Receiver/Modulative" : "Lixel/Receiver",
                                  "General"));
    dress(world);
}

void Application::setUp(Lamp& lamp, const UsedSetup& used) {
    lamp.own = used;
    lamp.light->setCustomShadowCameraSetup(used.setup);
}

void Application::setUp(World& world, const UsedSetup& used) {
    world.sceneSetup = used;
    world.manager->setShadowCameraSetup(used.setup ? used.setup
                                                   : Ogre::DefaultShadowCameraSetup::create());
}

void Application::dress(World& world) {
    for (Ogre::Entity* const body : world.bodies) {
        const Ogre::MaterialPtr& old = body->getSubEntity(0)->getMaterial();
        const bool ignores = old && Ogre::StringUtil::startsWith(old->getName(), Ignores, false);
        body->setMaterial(surface(ignores ? Ignores : Receives, world.technique));
    }
}

void Application::followMeshes() {
    for (const auto& world : worlds) {
        for (Ogre::Entity* const body : world->bodies)
            body->_initialise(true);
        dress(*world);
    }
}

void Application::mendLights() {
    for (const auto& world : worlds)
        for (const Lamp& lamp : world->lamps) {
            if (!isPlaced(*lamp.light)) continue;
            // It may be relative to a camera that has gone.
            lamp.light->_setCameraRelative(nullptr);
            if (lamp.light->getDerivedDirection().isNaN())
                setOwnDirection(*lamp.light, Ogre::Vector3::NEGATIVE_UNIT_Z);
        }
}

void Application::loadPlugin(bool load) {
    if (load == pluginLoaded) return;
    std::ifstream list(Samples::programFolder() + "/plugins.cfg");
    std::string line;
    std::string folder;
    while (std::getline(list, line)) {
        if (line.rfind("PluginFolder=", 0) == 0) folder = line.substr(13);
        if (line.rfind("Plugin=", 0) != 0 || line.find("Plugin_Lixel") == std::string::npos)
            continue;
        const std::string name = folder + line.substr(7);
        if (load) {
            root().loadPlugin(name);
        } else {
            mendLights();
            root().unloadPlugin(name);
        }
        pluginLoaded = load;
    }
}

void Application::drawFrame() {
    mTold.clear();
    root().renderOneFrame();
}

const ToldMaps* Application::told(const Ogre::Camera& viewer, const Ogre::Light& light) const {
    const auto found = mTold.find({&viewer, &light});
    return found != mTold.end() ? &found->second : nullptr;
}

void Application::shadowMapFitted(const ShadowMap& map) {
    ToldMaps& told = mTold[{&map.viewer, &map.light}];
    // A camera shown twice is told twice.
    if (map.iteration == 0) told = {};
    ++told.maps;
    told.drawn += map.fit.hasMap() ? 1U : 0U;
    told.last = map.fit.reason;
}

} // namespace Lixel::Tests

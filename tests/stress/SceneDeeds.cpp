// What happens to scene managers, their shadows, and to resources and plugins.

#include "SceneDeeds.h"

namespace Lixel::Tests {
namespace {

constexpr std::size_t MostWorlds = 3;
constexpr const char* FlatManager = "LixelSceneManager";
constexpr auto LightTypes = {Ogre::Light::LT_DIRECTIONAL, Ogre::Light::LT_SPOTLIGHT,
                             Ogre::Light::LT_POINT};

std::string createSceneManager(Application& application, World&, Random& random) {
    if (application.worlds.size() == MostWorlds) return {};
    // Lixel's own is there while the plugin is.
    const char* const flat = application.pluginLoaded ? FlatManager : "";
    World& world = application.addWorld(random.of({"", "OctreeSceneManager", flat, flat}));
    for (const std::string& mesh : Application::meshes())
        application.addBody(world, mesh);
    Lamp* const lamp = application.addLamp(world, application.newName("Light"));
    if (UsedSetup* const used = anyOf(application.setups, random)) application.setUp(*lamp, *used);
    Ogre::Camera& camera = application.addCamera(world);
    if (random.oneIn(2)) application.show(application.screens.front(), {&camera});
    return world.manager->getName();
}

std::string destroySceneManager(Application& application, World& world, Random& random) {
    if (application.worlds.size() < 2 || !random.oneIn(2)) return {};
    std::string name = world.manager->getName();
    for (std::size_t i = 0; i < application.worlds.size(); ++i)
        if (application.worlds[i].get() == &world) {
            application.removeWorld(i);
            break;
        }
    return name;
}

std::string setTechnique(Application& application, World& world, Random& random) {
    const auto technique =
        random.of({Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, Ogre::SHADOWTYPE_TEXTURE_ADDITIVE,
                   Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED,
                   Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED,
                   Ogre::SHADOWTYPE_TEXTURE_MODULATIVE, Ogre::SHADOWTYPE_NONE});
    // Stencil techniques come and go undrawn: OGRE's GL3+ throws on their buffers of length 0.
    for (const auto stencil :
         {Ogre::SHADOWTYPE_STENCIL_ADDITIVE, Ogre::SHADOWTYPE_STENCIL_MODULATIVE})
        if (random.oneIn(3)) application.setTechnique(world, stencil);
    application.setTechnique(world, technique);
    return world.manager->getName() + " to " + std::to_string(technique);
}

std::string setTextures(Application&, World& world, Random& random) {
    Ogre::SceneManager& manager = *world.manager;
    switch (random.below(4)) {
    case 0:
        manager.setShadowTextureSize(random.of<Ogre::ushort>({1, 16, 256, 512, 512, 1024}));
        return "size";
    case 1: {
        const std::size_t count = random.of<std::size_t>({0, 1, 1, 2, 3, 6, 8});
        manager.setShadowTextureCount(count);
        return "count " + std::to_string(count);
    }
    case 2: {
        const std::size_t count = manager.getShadowTextureConfigList().size();
        if (count == 0) return {};
        manager.setShadowTextureConfig(random.below(count), random.of<Ogre::ushort>({300, 512}),
                                       random.of<Ogre::ushort>({200, 512}),
                                       manager.getShadowTextureConfigList().front().format);
        return "one of another size";
    }
    default: {
        // What can be read of these is not checked; they must not break anything.
        const Ogre::PixelFormat format =
            random.of({Ogre::PF_FLOAT32_R, Ogre::PF_FLOAT32_R, Ogre::PF_FLOAT32_R,
                       Ogre::PF_FLOAT16_R, Ogre::PF_BYTE_RGBA, Ogre::PF_DEPTH16});
        const Ogre::ushort count = random.of<Ogre::ushort>({1, 2, 3, 6});
        manager.setShadowTextureSettings(512, count, format);
        world.readableFormat = format == Ogre::PF_FLOAT32_R;
        return "format " + Ogre::PixelUtil::getFormatName(format) + ", count " +
               std::to_string(count);
    }
    }
}

std::string setCountPerType(Application&, World& world, Random& random) {
    const std::size_t count = random.of<std::size_t>({1, 1, 1, 2, 3, 4, 6});
    if (random.oneIn(2)) {
        for (const auto type : LightTypes)
            world.manager->setShadowTextureCountPerLightType(type, count);
        world.manager->setShadowTextureCount(count * random.of<std::size_t>({1, 1, 2}));
    } else {
        world.manager->setShadowTextureCountPerLightType(random.of(LightTypes), count);
    }
    return world.manager->getName() + " " + std::to_string(count);
}

/// Without materials of its own OGRE needs the fixed function, which GL3+ has not: they come back
/// before a frame is drawn.
std::string setMaterials(Application& application, World& world, Random&) {
    world.manager->setShadowTextureCasterMaterial(Ogre::MaterialPtr());
    world.manager->setShadowTextureReceiverMaterial(Ogre::MaterialPtr());
    application.setTechnique(world, world.technique);
    return "none, and Lixel's again";
}

std::string setShadows(Application&, World& world, Random& random) {
    Ogre::SceneManager& manager = *world.manager;
    switch (random.below(5)) {
    case 0:
        manager.setShadowTextureSelfShadow(!random.oneIn(4));
        return "casters receive or not";
    case 1:
        manager.setShadowFarDistance(random.of({0.0F, 15.0F, 60.0F, 60.0F, 60.0F, 1e6F}));
        return "far distance " + std::to_string(manager.getShadowFarDistance());
    case 2:
        manager.setShadowCasterRenderBackFaces(!manager.getShadowCasterRenderBackFaces());
        return "back faces or not";
    case 3:
        manager.setVisibilityMask(random.of({1U, 3U, 0xFFFFFFFFU, 0xFFFFFFFFU}));
        return "visibility mask";
    default:
        manager.setCameraRelativeRendering(!manager.getCameraRelativeRendering());
        return "camera-relative or not";
    }
}

std::string reload(Application& application, World&, Random& random) {
    auto& resources = Ogre::ResourceGroupManager::getSingleton();
    switch (random.below(5)) {
    case 0:
        resources.unloadResourceGroup("Stress");
        application.followMeshes();
        return "meshes unloaded";
    case 1: {
        const std::string& name = Application::meshes()[random.below(Application::meshes().size())];
        const Ogre::ResourcePtr mesh = Ogre::MeshManager::getSingleton().getResourceByName(name);
        if (mesh) mesh->reload();
        application.followMeshes();
        return name;
    }
    case 2:
        // OGRE draws white where programs were unloaded under a loaded material.
        resources.unloadResourceGroup("General");
        resources.loadResourceGroup("General");
        return "Lixel's materials unloaded and loaded";
    case 3:
        Ogre::MaterialManager::getSingleton().reloadAll();
        return "all materials";
    default:
        Ogre::HighLevelGpuProgramManager::getSingleton().reloadAll();
        return "all programs";
    }
}

/// Who looks on and keeps nothing.
class Onlooker : public ShadowMapObserver {
public:
    void shadowMapFitted(const ShadowMap&) override {}
};

std::string observe(Application&, World&, Random& random) {
    static std::array<std::unique_ptr<Onlooker>, 3> onlookers;
    std::unique_ptr<Onlooker>& one = onlookers[random.below(onlookers.size())];
    if (one) {
        one.reset();
        return "one less";
    }
    one = std::make_unique<Onlooker>();
    addShadowMapObserver(*one);
    return "one more";
}

std::string loadPlugin(Application& application, World&, Random& random) {
    // Its scene managers would go with it.
    for (const auto& world : application.worlds)
        if (world->manager->getTypeName() == FlatManager) return {};
    application.loadPlugin(!random.oneIn(4));
    return application.pluginLoaded ? "loaded" : "unloaded";
}

std::string restart(Application& application, World&, Random& random) {
    if (!random.oneIn(4)) return {};
    application.restart();
    return "all of it";
}

} // namespace

const std::vector<Deed>& sceneDeeds() {
    static const std::vector<Deed> deeds{
        {"create scene manager", 2, createSceneManager},
        {"destroy scene manager", 2, destroySceneManager},
        {"shadow technique", 5, setTechnique},
        {"shadow textures", 6, setTextures},
        {"textures per light", 4, setCountPerType},
        {"caster and receiver", 4, setMaterials},
        {"shadows", 6, setShadows},
        {"reload", 3, reload},
        {"observers", 2, observe},
        {"plugin", 2, loadPlugin},
        {"restart", 1, restart},
    };
    return deeds;
}

} // namespace Lixel::Tests

#pragma once

// OgreRenderQueueSortingGrouping.h of 14 needs it and does not include it.
#include <OgreIteratorWrapper.h>

#include <OgreCamera.h>
#include <OgreGpuProgramManager.h>
#include <OgreGpuProgramParams.h>
#include <OgreHardwarePixelBuffer.h>
#include <OgreHighLevelGpuProgram.h>
#include <OgreHighLevelGpuProgramManager.h>
#include <OgreLight.h>
#include <OgreMaterialManager.h>
#include <OgreMeshManager.h>
#include <OgrePass.h>
#include <OgreRenderQueueSortingGrouping.h>
#include <OgreRenderSystem.h>
#include <OgreRenderTexture.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreStringInterface.h>
#include <OgreSubEntity.h>
#include <OgreTexture.h>
#include <OgreViewport.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <typeinfo>
#include <vector>

/** What differs between OGRE 1.12 and 14, under one name each.

    Whatever else Lixel calls is the same in all of these versions. For CMake it is in
    cmake/LixelOgre.cmake.
*/
namespace Lixel {

/// MovableObject::getMovableType of lights.
inline constexpr const char* LightTypeName = "Light";

#if OGRE_VERSION_MAJOR >= 13

/// Listens to a scene manager and to its shadow textures, which have a listener of their own
/// since 13.
class SceneManagerListener : public Ogre::SceneManager::Listener,
                             public Ogre::ShadowTextureListener {};

inline void addSceneManagerListener(Ogre::SceneManager& manager, SceneManagerListener& listener) {
    manager.addListener(&listener);
    manager.addShadowTextureListener(&listener);
}

inline void removeSceneManagerListener(Ogre::SceneManager& manager,
                                       SceneManagerListener& listener) {
    manager.removeListener(&listener);
    manager.removeShadowTextureListener(&listener);
}

#else

class SceneManagerListener : public Ogre::SceneManager::Listener {};

inline void addSceneManagerListener(Ogre::SceneManager& manager, SceneManagerListener& listener) {
    manager.addListener(&listener);
}

inline void removeSceneManagerListener(Ogre::SceneManager& manager,
                                       SceneManagerListener& listener) {
    manager.removeListener(&listener);
}

#endif

#if OGRE_VERSION_MAJOR >= 13

/// What has all programs in languages such as GLSL: since 13 it is the one for all programs.
inline Ogre::ResourceManager& programManager() {
    return Ogre::GpuProgramManager::getSingleton();
}

/// @throws Ogre::Exception where there is one of that name
inline Ogre::GpuProgramPtr createProgram(const Ogre::String& name, const Ogre::String& group,
                                         const Ogre::String& language, Ogre::GpuProgramType type) {
    return Ogre::GpuProgramManager::getSingleton().createProgram(name, group, language, type);
}

#else

inline Ogre::ResourceManager& programManager() {
    return Ogre::HighLevelGpuProgramManager::getSingleton();
}

inline Ogre::GpuProgramPtr createProgram(const Ogre::String& name, const Ogre::String& group,
                                         const Ogre::String& language, Ogre::GpuProgramType type) {
    return Ogre::HighLevelGpuProgramManager::getSingleton().createProgram(name, group, language,
                                                                          type);
}

#endif

/// Whether a GLSL program's text alone tells its uniforms and how they are laid out. Since 13, GL3+
/// links each program by itself unless told otherwise ("Separate Shader Objects"), and OpenGL has to
/// be asked.
#if OGRE_VERSION_MAJOR >= 13
#define LIXEL_UNIFORMS_BY_TEXT 0
#else
#define LIXEL_UNIFORMS_BY_TEXT 1
#endif

/// The name of what StringInterface::getParameters() lists: since 14 it lists names alone.
inline const Ogre::String& settingName(const Ogre::ParameterDef& setting) {
    return setting.name;
}
inline const Ogre::String& settingName(const Ogre::String& name) {
    return name;
}

/// A factory of scene managers that knows the name of their type; since 14 it has no other metadata.
class NamedSceneManagerFactory : public Ogre::SceneManagerFactory {
public:
    explicit NamedSceneManagerFactory(const Ogre::String& typeName) : mTypeName(typeName) {}
#if OGRE_VERSION_MAJOR >= 14
    const Ogre::String& getTypeName() const override {
        return mTypeName;
    }
#else
private:
    void initMetaData() const override {
        mMetaData.typeName = mTypeName;
        mMetaData.worldGeometrySupported = false;
    }
#endif

private:
    Ogre::String mTypeName;
};

#ifdef OGRE_NODELESS_POSITIONING // which is off since 13 unless OGRE is built with it

/// Whether a light may have a direction of its own, apart from its node's. Only such a direction
/// can be NaN: for a NaN in a node, OGRE itself asserts that attached objects have valid bounds.
inline constexpr bool LightsHaveDirections = true;

// It is all deprecated.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

/// A light's own direction, in its node's space.
inline Ogre::Vector3 ownDirection(const Ogre::Light& light) {
    return light.getDirection();
}

inline void setOwnDirection(Ogre::Light& light, const Ogre::Vector3& direction) {
    light.setDirection(direction);
}

#pragma GCC diagnostic pop

/// Whether a light has a position and a direction: OGRE crashes on the others as soon as it asks.
inline bool isPlaced(const Ogre::Light&) {
    return true;
}

#else

inline constexpr bool LightsHaveDirections = false;

inline bool isPlaced(const Ogre::Light& light) {
    return light.getParentNode() != nullptr;
}

/// The direction of a light's node, in the space of that node's parent.
inline Ogre::Vector3 ownDirection(const Ogre::Light& light) {
    return -light.getParentSceneNode()->getOrientation().zAxis();
}

inline void setOwnDirection(Ogre::Light& light, const Ogre::Vector3& direction) {
    light.getParentSceneNode()->setOrientation(
        Ogre::Vector3::NEGATIVE_UNIT_Z.getRotationTo(direction.normalisedCopy()));
}

#endif

/// Whether a scene manager is OGRE's default one, and of no class derived from it, which may draw
/// by other rules. Asked by name, because the class is in no public header since 14.
inline bool isDefaultSceneManager(const Ogre::SceneManager& manager) {
    return std::string_view(typeid(manager).name()) == "N4Ogre19DefaultSceneManagerE";
}

/// Clears all of a viewport at once. Viewport::clear is deprecated since 13.
inline void clearViewport(Ogre::Viewport& viewport, unsigned int buffers,
                          const Ogre::ColourValue& colour) {
    Ogre::RenderSystem& system = *Ogre::Root::getSingleton().getRenderSystem();
    Ogre::Viewport* const current = system._getViewport();
    system._setViewport(&viewport);
    system.clearFrameBuffer(buffers, colour);
    if (current != nullptr && current != &viewport) system._setViewport(current);
}

/// Whether OGRE itself clamps casters' depths, instead of clipping casters, in this light's maps.
inline bool ogreClampsDepth([[maybe_unused]] const Ogre::Light& light) {
#if OGRE_MIN_VERSION(13, 6, 0)
    return light.getType() == Ogre::Light::LT_DIRECTIONAL;
#else
    return false;
#endif
}

/// Has each object lit by the lights that its own light mask allows, for all scene managers. Since
/// 14.3 OGRE does that only on demand: by default all objects share the lights of the frame.
inline void useLightMasksOfObjects([[maybe_unused]] bool use) {
#if OGRE_MIN_VERSION(14, 3, 0)
    Ogre::SceneManager::usePerRenderableLights(use);
#endif
}

/// Whether OGRE can draw a light's shadows, if it casts any. Since 13.6 it sets a camera of its own
/// up from the light, to cull with, and asserts on what is not finite, and on a negative distance,
/// whatever setup the light has.
inline bool canDrawShadowsOf([[maybe_unused]] const Ogre::Light& light) {
#if OGRE_MIN_VERSION(13, 6, 0)
    const bool hasAngle =
        light.getType() != Ogre::Light::LT_DIRECTIONAL && light.getType() != Ogre::Light::LT_POINT;
    return !light.getCastShadows() ||
           (std::isfinite(light.getShadowFarDistance()) && light.getShadowFarDistance() >= 0 &&
            std::isfinite(light.getShadowNearClipDistance()) &&
            std::isfinite(light._deriveShadowFarClipDistance()) &&
            (!hasAngle || std::isfinite(light.getSpotlightOuterAngle().valueRadians())));
#else
    return true;
#endif
}

/// Whether programs are given a skeleton's bones in the object's space; otherwise in the world's.
/// There is a choice since 13.5, and the object's is the default since 14.
inline bool bonesAreInObject() {
#if OGRE_MIN_VERSION(13, 5, 0)
    return Ogre::MeshManager::getBonesUseObjectSpace();
#else
    return false;
#endif
}

/// The texture unit that a sampler is set to. Since 13 samplers are apart from other constants.
inline int textureUnitOf(const Ogre::GpuProgramParameters& parameters,
                         const Ogre::GpuConstantDefinition& sampler) {
#if OGRE_VERSION_MAJOR >= 13
    return *parameters.getRegPointer(sampler.physicalIndex);
#else
    return *parameters.getIntPointer(sampler.physicalIndex);
#endif
}

/// Calls `visit` with each priority's renderables of a queue group.
template <typename Visit>
void forPriorityGroups(const Ogre::RenderQueueGroup& group, const Visit& visit) {
#if OGRE_VERSION_MAJOR >= 13
    for (const auto& [priority, renderables] : group.getPriorityGroups())
        visit(*renderables);
#else
    for (auto groups = group.getIterator(); groups.hasMoreElements();)
        visit(*groups.getNext());
#endif
}

/// A shadow map's texture, and the target that its camera draws into.
struct ShadowTarget {
    Ogre::TexturePtr texture;
    const Ogre::RenderTarget* target;
};

/// A scene manager's shadow maps in the order in which OGRE deals them out to lights. Since 14 one
/// texture may hold several, as layers or faces.
inline std::vector<ShadowTarget> shadowTargetsOf(Ogre::SceneManager& manager) {
    std::vector<ShadowTarget> targets;
    const std::size_t textures = manager.getShadowTextureConfigList().size();
    for (std::size_t i = 0; i < textures; ++i) {
        const Ogre::TexturePtr& texture = manager.getShadowTexture(i);
#if OGRE_VERSION_MAJOR >= 14
        for (std::uint32_t layer = 0; layer < texture->getNumLayers(); ++layer)
            targets.push_back({texture, texture->getRenderTarget(layer)});
#else
        targets.push_back({texture, texture->getBuffer()->getRenderTarget()});
#endif
    }
    return targets;
}

/// Whether OGRE draws all maps of a texture in one pass, which one camera culls.
inline bool drawsMapsTogether([[maybe_unused]] const Ogre::Texture& texture) {
#if OGRE_MIN_VERSION(14, 4, 0)
    return (texture.getUsage() & Ogre::TU_TARGET_ALL_LAYERS) != 0 && texture.getNumLayers() > 1;
#else
    return false;
#endif
}

/** A scene manager's own record of its shadow materials. OGRE returns it nowhere, and it is private
    since 14; but an explicit instantiation may name private members.
*/
template <auto ShadowRenderer>
struct ShadowRendererAccess {
    friend auto& shadowRendererOf(Ogre::SceneManager& manager) { return manager.*ShadowRenderer; }
};
auto& shadowRendererOf(Ogre::SceneManager& manager);
#if OGRE_MIN_VERSION(14, 4, 0)
template struct ShadowRendererAccess<&Ogre::SceneManager::mTextureShadowRenderer>;
#else
template struct ShadowRendererAccess<&Ogre::SceneManager::mShadowRenderer>;
#endif

/// The pass of the shadow caster material that a scene manager was given. Null where it has none
/// that can be drawn.
inline const Ogre::Pass* shadowCasterPassOf(Ogre::SceneManager& manager) {
    return shadowRendererOf(manager).mShadowTextureCustomCasterPass;
}

/// The pass of the shadow receiver material that a scene manager was given. Null where it has none
/// that can be drawn.
inline const Ogre::Pass* shadowReceiverPassOf(Ogre::SceneManager& manager) {
    return shadowRendererOf(manager).mShadowTextureCustomReceiverPass;
}

/// The programs that a scene manager's shadow caster material was given, empty where it has none.
/// Until 12, OGRE lends its pass those of the surface that was drawn last.
struct CasterPrograms {
    const Ogre::String& vertex;
    const Ogre::String& fragment;
    Ogre::GpuProgramParametersSharedPtr fragmentParameters;
};
inline CasterPrograms casterProgramsOf(Ogre::SceneManager& manager) {
    const Ogre::Pass* const pass = shadowCasterPassOf(manager);
    static const Ogre::String none;
    if (pass == nullptr) return {none, none, {}};
#if OGRE_VERSION_MAJOR >= 13
    return {pass->hasVertexProgram() ? pass->getVertexProgramName() : none,
            pass->hasFragmentProgram() ? pass->getFragmentProgramName() : none,
            pass->hasFragmentProgram() ? pass->getFragmentProgramParameters()
                                       : Ogre::GpuProgramParametersSharedPtr()};
#else
    const auto& renderer = shadowRendererOf(manager);
    return {renderer.mShadowTextureCustomCasterVertexProgram,
            renderer.mShadowTextureCustomCasterFragmentProgram,
            renderer.mShadowTextureCustomCasterFPParams};
#endif
}

/// Has OGRE's current scene manager, which objects ask while they are drawn, be one that it was
/// before; until 12 there is a stack of them.
inline void resetCurrentSceneManager(Ogre::SceneManager* before) {
    Ogre::Root& root = Ogre::Root::getSingleton();
#if OGRE_VERSION_MAJOR >= 13
    root._setCurrentSceneManager(before);
#else
    while (Ogre::SceneManager* const current = root._getCurrentSceneManager()) {
        if (current == before) break;
        root._popCurrentSceneManager(current);
    }
#endif
}

/// A scene manager's visitors of render queues: the one in use, which applications may replace, and
/// OGRE's own; they are private since 14.
template <auto InUse, auto Own>
struct QueueVisitorAccess {
    friend bool hasOwnQueueVisitor(const Ogre::SceneManager& manager) {
        return manager.*InUse == &(manager.*Own);
    }
};
bool hasOwnQueueVisitor(const Ogre::SceneManager& manager);
template struct QueueVisitorAccess<&Ogre::SceneManager::mActiveQueuedRenderableVisitor,
                                   &Ogre::SceneManager::mDefaultQueuedRenderableVisitor>;

/// Whether render queues are drawn in their usual way: by groups, with state changes and shadows.
inline bool drawsQueuesAsUsual(const Ogre::SceneManager& manager,
                               [[maybe_unused]] Ogre::Viewport& viewport) {
    if (manager.isLateMaterialResolving() || !hasOwnQueueVisitor(manager)) return false;
#if OGRE_VERSION_MAJOR >= 13
    return true;
#else
    return viewport._getRenderQueueInvocationSequence() == nullptr &&
           !manager._areRenderStateChangesSuppressed() && !manager._areShadowsSuppressed();
#endif
}

/// Whether the render system draws every shadow caster several times, as instances of its own.
/// Since 14.4 there are such instances for each material scheme, and one scheme for shadow maps.
inline bool hasGlobalInstances(const Ogre::RenderSystem& system) {
#if OGRE_MIN_VERSION(14, 4, 0)
    return system.getSchemeInstancingData(Ogre::MSN_SHADOWCASTER).vertexDecl != nullptr;
#elif OGRE_VERSION_MAJOR >= 14
    return system.getGlobalInstanceCount() != 1;
#else
    return system.getGlobalNumberOfInstances() != 1 ||
           system.getGlobalInstanceVertexBuffer() != nullptr;
#endif
}

/// Whether a pass has programs of its own for its shadow casters, which there are until 12. (A
/// technique's shadow caster material is another matter.)
inline bool hasOwnCasterPrograms([[maybe_unused]] const Ogre::Pass& pass) {
#if OGRE_VERSION_MAJOR >= 13
    return false;
#else
    return !pass.getShadowCasterVertexProgramName().empty() ||
           !pass.getShadowCasterFragmentProgramName().empty();
#endif
}

// Deprecated since 14.3 and 14.4, and still there.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

/// Whether a camera's view is cut to a window of its viewport.
inline bool hasWindow(const Ogre::Camera& camera) {
    return camera.isWindowSet();
}

/// Of its mesh's indices those that a part of an entity draws; all where they are equal.
struct IndexRange {
    std::size_t start;
    std::size_t end;
};
inline IndexRange indexRangeOf(const Ogre::SubEntity& part) {
    return {part.getIndexDataStartIndex(), part.getIndexDataEndIndex()};
}
inline void setIndexRange(Ogre::SubEntity& part, Ogre::uint32 start, Ogre::uint32 end) {
    part.setIndexDataStartIndex(start);
    part.setIndexDataEndIndex(end);
}

#pragma GCC diagnostic pop

/// Whether a scene manager has listeners of levels of detail, which are private since 14.
template <auto LodListeners>
struct LodListenersAccess {
    friend auto& lodListenersOf(const Ogre::SceneManager& manager) { return manager.*LodListeners; }
};
auto& lodListenersOf(const Ogre::SceneManager& manager);
template struct LodListenersAccess<&Ogre::SceneManager::mLodListeners>;

/// A scene manager's listeners of its render queue and of what it draws; they are private since 14.
template <auto QueueListeners, auto ObjectListeners>
struct RenderListenersAccess {
    friend auto& queueListenersOf(const Ogre::SceneManager& manager) {
        return manager.*QueueListeners;
    }
    friend auto& objectListenersOf(const Ogre::SceneManager& manager) {
        return manager.*ObjectListeners;
    }
};
auto& queueListenersOf(const Ogre::SceneManager& manager);
auto& objectListenersOf(const Ogre::SceneManager& manager);
template struct RenderListenersAccess<&Ogre::SceneManager::mRenderQueueListeners,
                                      &Ogre::SceneManager::mRenderObjectListeners>;

/// The priority that an object was given within its render queue group; OGRE returns it nowhere.
template <auto RenderQueuePriority>
struct QueuePriorityAccess {
    friend Ogre::ushort queuePriorityOf(const Ogre::MovableObject& object) {
        return object.*RenderQueuePriority;
    }
};
Ogre::ushort queuePriorityOf(const Ogre::MovableObject& object);
template struct QueuePriorityAccess<&Ogre::MovableObject::mRenderQueuePriority>;

} // namespace Lixel

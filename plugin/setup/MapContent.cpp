#include "setup/MapContent.h"

#include "fit/problem/ShadowFit.h"
#include "scene/CasterPass.h"
#include "scene/OgreVersions.h"

#include <OgreCamera.h>
#include <OgrePixelFormat.h>
#include <OgreRenderObjectListener.h>
#include <OgreRenderQueueListener.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <typeinfo>

namespace Lixel {
namespace {

void addProgram(const Ogre::GpuProgramPtr& program, Fingerprint& fingerprint) {
    fingerprint.add(program.get());
    if (program) fingerprint.add(program->getStateCount());
}

void addPass(const Ogre::Pass* pass, Fingerprint& fingerprint) {
    fingerprint.add(pass);
    if (pass == nullptr) return;
    if (pass->hasVertexProgram()) addProgram(pass->getVertexProgram(), fingerprint);
    if (pass->hasFragmentProgram()) addProgram(pass->getFragmentProgram(), fingerprint);
    fingerprint.add(std::array{static_cast<float>(pass->getDepthBiasConstant()),
                               static_cast<float>(pass->getDepthBiasSlopeScale())});
    fingerprint.add(std::uint64_t{pass->getDepthCheckEnabled()});
    fingerprint.add(std::uint64_t{pass->getDepthWriteEnabled()});
    fingerprint.add(std::uint64_t{pass->getDepthFunction()});
    fingerprint.add(std::uint64_t{pass->getPolygonMode()});
}

/// Whether a listener's class is OGRE's or Lixel's, as far as its mangled name says.
template <typename Listener>
bool isForeign(const Listener& listener) {
    const std::string_view type = typeid(listener).name();
    return !type.starts_with("N4Ogre") && !type.starts_with("N5Lixel");
}

} // namespace

void addMatrices(const Ogre::Camera& camera, Fingerprint& fingerprint) {
    fingerprint.add(std::span<const float>(camera.getViewMatrix(true)[0], 12));
    fingerprint.add(std::span<const float>(camera.getProjectionMatrix()[0], 16));
}

Fingerprint matricesOf(const Ogre::Camera& shadowCamera, const ShadowFit& fit) {
    Fingerprint matrices;
    addMatrices(shadowCamera, matrices);
    matrices.add(
        std::array{static_cast<float>(fit.depthScale), static_cast<float>(fit.depthOffset)});
    // What culls casters: it may change while the map stands still, as a stable one does, when
    // something comes to where a caster shadowed nothing before.
    for (const Vec2& vertex : fit.liFocus.span()) {
        matrices.add(vertex.x());
        matrices.add(vertex.y());
    }
    matrices.add(fit.lsFar);
    return matrices;
}

Fingerprint settingsOf(Ogre::SceneManager& manager, const Ogre::Camera& shadowCamera,
                       const Ogre::Viewport& view) {
    Fingerprint settings;
    settings.add(&manager);
    settings.add(std::uint64_t{manager.getShadowTechnique()});
    settings.add(std::uint64_t{manager.getShadowTextureSelfShadow()});
    settings.add(std::uint64_t{manager.getShadowCasterRenderBackFaces()});
    settings.add(std::uint64_t{manager.getCameraRelativeRendering()});
    settings.add(std::uint64_t{manager.getFindVisibleObjects()});
    settings.add(std::uint64_t{manager.getVisibilityMask() & view.getVisibilityMask()});
    settings.add(std::string_view(view.getMaterialScheme()));
    const Ogre::ColourValue& colour = manager.getShadowColour();
    settings.add(std::array{colour.r, colour.g, colour.b, colour.a});
    settings.add(std::uint64_t{shadowCamera.getPolygonMode()});
    if (const Ogre::Viewport* const map = shadowCamera.getViewport()) {
        settings.add(static_cast<std::uint64_t>(map->getActualWidth()));
        settings.add(static_cast<std::uint64_t>(map->getActualHeight()));
    }
    constexpr std::size_t Word = 64;
    std::array<std::uint64_t, Ogre::RENDER_QUEUE_MAX / Word + 1> queues{};
    for (std::size_t group = 0; group <= Ogre::RENDER_QUEUE_MAX; ++group) {
        const bool isDrawn = manager.isRenderQueueToBeProcessed(static_cast<Ogre::uint8>(group));
        queues[group / Word] |= std::uint64_t{isDrawn} << (group % Word);
    }
    for (const std::uint64_t word : queues)
        settings.add(word);
    addPass(shadowCasterPassOf(manager), settings);
    return settings;
}

bool hasKnownCasterMaterial(Ogre::SceneManager& manager) {
    const Ogre::Pass* const pass = shadowCasterPassOf(manager);
    return pass == nullptr ||
           ((!pass->hasVertexProgram() || isOwnProgram(pass->getVertexProgramName())) &&
            (!pass->hasFragmentProgram() || isOwnProgram(pass->getFragmentProgramName())));
}

bool storesDepthAsColour(Ogre::SceneManager& manager, const Ogre::RenderTarget& target) {
    const Ogre::PixelFormat format = target.suggestPixelFormat();
    return !Ogre::PixelUtil::isDepth(format) && !Ogre::PixelUtil::isInteger(format) &&
           isOwnProgram(casterProgramsOf(manager).fragment);
}

bool hasForeignListener(const Ogre::SceneManager& manager) {
    const auto foreign = [](const auto* listener) { return isForeign(*listener); };
    return std::ranges::any_of(queueListenersOf(manager), foreign) ||
           std::ranges::any_of(objectListenersOf(manager), foreign);
}

} // namespace Lixel

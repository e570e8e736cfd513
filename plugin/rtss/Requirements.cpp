#include "rtss/Requirements.h"

#include "rtss/ReceiverCode.h"
#include "rtss/TransformedCasters.h"

#include <OgreRenderSystem.h>
#include <OgreRenderSystemCapabilities.h>
#include <OgreResourceGroupManager.h>
#include <OgreRoot.h>
#include <RTShaderSystem/OgreShaderGenerator.h>

#include <algorithm>
#include <cstdint>

namespace Lixel {

std::string whatKeepsFromShadowing() {
    constexpr std::uint16_t LeastVersion = 330;
    const Ogre::RenderSystem& system = *Ogre::Root::getSingleton().getRenderSystem();
    if (Ogre::RTShader::ShaderGenerator::getSingleton().getTargetLanguage() != "glsl" ||
        system.getNativeShadingLanguageVersion() < LeastVersion)
        return "its programs are not GLSL " + std::to_string(LeastVersion) +
               " or newer; take the GL3Plus render system";
    const std::string file = std::string(ReceiverSource) + ".glsl";
    if (!Ogre::ResourceGroupManager::getSingleton().resourceExistsInAnyGroup(file))
        return "there is no " + file +
               "; add Lixel's folder materials/programs/glsl to the resource group General";
    // The plugin that makes this set also sets the lights' parameters.
    if (!pluginIsLoaded())
        return "Plugin_Lixel was not loaded before resource groups were initialised";
    return {};
}

std::size_t greatestUnits() {
    const std::size_t units =
        Ogre::Root::getSingleton().getRenderSystem()->getCapabilities()->getNumTextureUnits();
    return std::min<std::size_t>(units, OGRE_MAX_TEXTURE_LAYERS);
}

} // namespace Lixel

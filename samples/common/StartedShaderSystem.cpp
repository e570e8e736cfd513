#include "common/StartedShaderSystem.h"

#include <stdexcept>
#include <string>

namespace Lixel::Samples {

using Ogre::RTShader::ShaderGenerator;

namespace {

/// Where OGRE's library of functions is, and with OGRE 14 its samplers.
void addLibrary() {
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    // OGRE 14 refuses to make its samplers twice.
    if (groups.resourceLocationExists(OGRE_MEDIA_DIR "/RTShaderLib", Ogre::RGN_INTERNAL)) return;
    for (const char* folder : {"/GLSL", "/HLSL_Cg", ""})
        groups.addResourceLocation(std::string(OGRE_MEDIA_DIR "/RTShaderLib") + folder,
                                   "FileSystem", Ogre::RGN_INTERNAL);
    const Ogre::StringVectorPtr scripts =
        groups.findResourceNames(Ogre::RGN_INTERNAL, "RTSSamplers.material");
    for (const Ogre::String& script : *scripts) {
        Ogre::DataStreamPtr stream = groups.openResource(script, Ogre::RGN_INTERNAL);
        Ogre::MaterialManager::getSingleton().parseScript(stream, Ogre::RGN_INTERNAL);
    }
}

ShaderGenerator& initialised() {
    addLibrary();
    if (!ShaderGenerator::initialize()) throw std::runtime_error("no shader generator");
    return ShaderGenerator::getSingleton();
}

} // namespace

StartedShaderSystem::StartedShaderSystem() : generator(initialised()) {
    Ogre::MaterialManager::getSingleton().addListener(this);
}

StartedShaderSystem::~StartedShaderSystem() {
    if (auto* const materials = Ogre::MaterialManager::getSingletonPtr())
        materials->removeListener(this);
    // Which may be another by now, or gone.
    ShaderGenerator* const current = ShaderGenerator::getSingletonPtr();
    if (current == nullptr) return;
    // OGRE 14 insists that no material uses it any more.
    current->removeAllShaderBasedTechniques();
    ShaderGenerator::destroy();
}

Ogre::Technique* StartedShaderSystem::handleSchemeNotFound(unsigned short,
                                                           const Ogre::String& scheme,
                                                           Ogre::Material* material, unsigned short,
                                                           const Ogre::Renderable*) {
    // Which may be another by now.
    ShaderGenerator* const current = ShaderGenerator::getSingletonPtr();
    if (current == nullptr || !current->hasRenderState(scheme) ||
        !current->createShaderBasedTechnique(*material, Ogre::MaterialManager::DEFAULT_SCHEME_NAME,
                                             scheme))
        return nullptr;
    current->validateMaterial(scheme, material->getName(), material->getGroup());
    for (Ogre::Technique* technique : material->getTechniques())
        if (technique->getSchemeName() == scheme) return technique;
    return nullptr;
}

} // namespace Lixel::Samples

#pragma once

#include <Ogre.h>
#include <RTShaderSystem/OgreRTShaderSystem.h>

namespace Lixel::Samples {

/// OGRE's shader system for one scheme, which draws materials that have none for it, as an
/// application runs it.
class StartedShaderSystem : public Ogre::MaterialManager::Listener {
public:
    StartedShaderSystem();
    ~StartedShaderSystem() override;
    StartedShaderSystem(const StartedShaderSystem&) = delete;
    StartedShaderSystem& operator=(const StartedShaderSystem&) = delete;

    Ogre::RTShader::ShaderGenerator& generator;

    Ogre::Technique* handleSchemeNotFound(unsigned short index, const Ogre::String& scheme,
                                          Ogre::Material* material, unsigned short lod,
                                          const Ogre::Renderable* renderable) override;

    static constexpr const char* Scheme = "ShaderGeneratorDefaultScheme";
};

} // namespace Lixel::Samples

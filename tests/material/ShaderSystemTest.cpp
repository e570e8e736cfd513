// Lixel's setups under the programs that OGRE's shader system makes for fixed-function materials.

#include "MaterialScene.h"

#include <Lixel/setup/CascadesShadowCameraSetup.h>

#include <RTShaderSystem/OgreRTShaderSystem.h>

namespace Lixel::Tests {
namespace {

using Ogre::RTShader::ShaderGenerator;

/// OGRE's shader system, for the scene's viewport; it has to go before Root.
class ShaderSystem : public Ogre::MaterialManager::Listener {
public:
    explicit ShaderSystem(MaterialScene& scene) {
        auto& groups = Ogre::ResourceGroupManager::getSingleton();
        for (const char* folder : {"/GLSL", "/HLSL_Cg", ""})
            groups.addResourceLocation(std::string(OGRE_MEDIA_DIR "/RTShaderLib") + folder,
                                       "FileSystem", Ogre::RGN_INTERNAL);
        // Since 14 its samplers are in a script, and the group is initialised already.
        const Ogre::StringVectorPtr scripts =
            groups.findResourceNames(Ogre::RGN_INTERNAL, "RTSSamplers.material");
        for (const Ogre::String& script : *scripts) {
            Ogre::DataStreamPtr stream = groups.openResource(script, Ogre::RGN_INTERNAL);
            Ogre::MaterialManager::getSingleton().parseScript(stream, Ogre::RGN_INTERNAL);
        }
        if (!ShaderGenerator::initialize()) throw std::runtime_error("no shader generator");
        ShaderGenerator& generator = ShaderGenerator::getSingleton();
        generator.addSceneManager(&scene.stage.sceneManager());
        scene.stage.viewport().setMaterialScheme(Scheme);
        Ogre::MaterialManager::getSingleton().addListener(this);
    }
    ~ShaderSystem() override {
        Ogre::MaterialManager::getSingleton().removeListener(this);
        // OGRE 14 insists that no material uses it any more.
        ShaderGenerator::getSingleton().removeAllShaderBasedTechniques();
        ShaderGenerator::destroy();
    }
    ShaderSystem(const ShaderSystem&) = delete;
    ShaderSystem& operator=(const ShaderSystem&) = delete;

    Ogre::Technique* handleSchemeNotFound(unsigned short, const Ogre::String& scheme,
                                          Ogre::Material* material, unsigned short,
                                          const Ogre::Renderable*) override {
        ShaderGenerator& generator = ShaderGenerator::getSingleton();
        if (scheme != Scheme ||
            !generator.createShaderBasedTechnique(material->getTechnique(0), scheme))
            return nullptr;
        generator.validateMaterial(scheme, material->getName(), material->getGroup());
        for (Ogre::Technique* technique : material->getTechniques())
            if (technique->getSchemeName() == scheme) return technique;
        return nullptr;
    }

    /// OGRE's own sub-render state for three slices of a sun.
    static void usePssm(const std::vector<Ogre::Real>& splits) {
        ShaderGenerator& generator = ShaderGenerator::getSingleton();
        Ogre::RTShader::SubRenderState* const pssm =
            generator.createSubRenderState("SGX_IntegratedPSSM3");
#if __has_include(<RTShaderSystem/OgreShaderExIntegratedPSSM3.h>)
        static_cast<Ogre::RTShader::IntegratedPSSM3*>(pssm)->setSplitPoints(splits);
#else // Since 14 its class is in no public header.
        pssm->setParameter("split_points", splits);
#endif
        generator.getRenderState(Scheme)->addTemplateSubRenderState(pssm);
    }

    static constexpr const char* Scheme = "ShaderGeneratorDefaultScheme";
};

/// Where it is dark: less than half as bright as the sunlit ground.
std::vector<int> darkness(MaterialScene& scene) {
    std::vector<int> mask = scene.draw();
    const int sunlit = mask[scene.pixelOf(Ogre::Vector3(4, 0, 4))];
    EXPECT_GT(sunlit, 30);
    for (int& value : mask)
        value = value < sunlit / 2 ? 255 : 0;
    return mask;
}

TEST(ForeignMaterials, OfTheShaderSystemReadCascades) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, "");
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    Ogre::Light& sun = *scene.lights.front();
    for (Ogre::Light* light : scene.lights)
        light->setVisible(light == &sun);
    const std::vector<Ogre::Real> splits{15, 25};
    auto setup =
        std::make_shared<CascadesShadowCameraSetup>(Samples::findShadowSetup("Uniform")->create());
    setup->setSplitDepths(splits);
    sun.setCustomShadowCameraSetup(setup);
    manager.setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL, 3);
    scene.wear("Lixel/Surface/Integrated/Maps3");
    const std::vector<int> own = darkness(scene);
    ASSERT_GT(std::count(own.begin(), own.end(), 255), 1000) << "the box and its shadow";

    ShaderSystem system(scene);
    LogCollector log;
    manager.setShadowTextureCasterMaterial(nullptr);
    manager.setShadowTextureSettings(512, 3, Ogre::PF_DEPTH16);
    ShaderSystem::usePssm({scene.stage.camera().getNearClipDistance(), splits[0], splits[1], 100});
    auto& materials = Ogre::MaterialManager::getSingleton();
    materials.create("Test/Plain", Ogre::RGN_DEFAULT)
        ->getTechnique(0)
        ->getPass(0)
        ->setDiffuse(0.8F, 0.8F, 0.8F, 1);
    scene.wear("Test/Plain");
    const std::vector<int> theirs = darkness(scene);
    scene.keepPicture("foreign-shader-system-pssm");
    EXPECT_LT(differing(own, theirs), 0.3);
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
}

} // namespace
} // namespace Lixel::Tests

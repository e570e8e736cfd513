// Lixel's setups under the programs that OGRE's shader system makes for fixed-function materials.

#include "MaterialScene.h"
#include "common/StartedShaderSystem.h"

#include <Lixel/setup/ShadowCameraSetups.h>

#include <OgreShadowCameraSetupPSSM.h>

#include <memory>
#include <optional>

namespace Lixel::Tests {
namespace {

using Ogre::RTShader::ShaderGenerator;

/// OGRE's shader system, for the scene's viewport; it has to go before Root.
class ShaderSystem : public Samples::StartedShaderSystem {
public:
    explicit ShaderSystem(MaterialScene& scene) {
        generator.addSceneManager(&scene.stage.sceneManager());
        scene.stage.viewport().setMaterialScheme(Scheme);
    }

    /// Passes that OGRE splits for additive shadows, which have to be given programs too.
    bool afterIlluminationPassesCreated(Ogre::Technique* technique) override {
        if (technique->getSchemeName() != Scheme) return false;
        const Ogre::Material* const material = technique->getParent();
        return ShaderGenerator::getSingleton().validateMaterialIlluminationPasses(
            Scheme, material->getName(), material->getGroup());
    }
    bool beforeIlluminationPassesCleared(Ogre::Technique* technique) override {
        if (technique->getSchemeName() != Scheme) return false;
        const Ogre::Material* const material = technique->getParent();
        ShaderGenerator::getSingleton().invalidateMaterialIlluminationPasses(
            Scheme, material->getName(), material->getGroup());
        return true;
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

/// Pixels that are not dark though they are in a picture, they and all around them: no edge of a
/// shadow, which every map draws a bit elsewhere.
std::size_t missingWithin(const std::vector<int>& shadows, const std::vector<int>& drawn,
                          std::size_t width) {
    std::size_t missing = 0;
    for (std::size_t at = width + 1; at + width + 1 < shadows.size(); ++at) {
        bool within = drawn[at] == 0;
        for (const std::size_t row : {at - width, at, at + width})
            for (const std::size_t pixel : {row - 1, row, row + 1})
                within = within && shadows[pixel] != 0;
        missing += within ? 1 : 0;
    }
    return missing;
}

/// Gives ground and box a material without programs, a bit darker than white.
void wearPlain(MaterialScene& scene) {
    const char* const name = "Test/Plain";
    Ogre::MaterialManager::getSingleton()
        .create(name, Ogre::RGN_DEFAULT)
        ->getTechnique(0)
        ->getPass(0)
        ->setDiffuse(0.8F, 0.8F, 0.8F, 1);
    scene.wear(name);
}

/// A sun with three cascades, shown by Lixel's materials and then by the shader system's.
class ShaderSystemCascades {
public:
    /// @param wall whether a wall beside the box casts a shadow at all depths
    ShaderSystemCascades(float nearDistance, const std::vector<Ogre::Real>& splits,
                         bool wall = false) {
        if (wall) scene.addCube(Ogre::Vector3(-3, 2, -20), Ogre::Vector3(0.5F, 4, 56));
        scene.stage.camera().setNearClipDistance(nearDistance);
        for (Ogre::Light* light : scene.lights)
            light->setVisible(light == scene.lights.front());
        cascades->setSplitDepths(splits);
        scene.lights.front()->setCustomShadowCameraSetup(cascades);
        scene.stage.sceneManager().setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL,
                                                                     3);
        scene.wear("Lixel/Surface/Integrated/Maps3");
        own = darkness(scene);
        mSystem.emplace(scene);
        Ogre::SceneManager& manager = scene.stage.sceneManager();
        manager.setShadowTextureCasterMaterial(nullptr);
        manager.setShadowTextureSettings(512, 3, Ogre::PF_DEPTH16);
        ShaderSystem::usePssm({nearDistance, splits[0], splits[1], 100});
        wearPlain(scene);
    }

    MaterialScene scene{Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, ""};
    std::shared_ptr<CascadesShadowCameraSetup> cascades =
        CascadesShadowCameraSetup::create(Samples::findShadowSetup("Uniform")->create());
    /// What is dark in Lixel's materials.
    std::vector<int> own;

private:
    std::optional<ShaderSystem> mSystem;
};

TEST(ForeignMaterials, OfTheShaderSystemReadCascades) {
    ShaderSystemCascades stage(0.1F, {15, 25});
    LogCollector log;
    ASSERT_GT(std::count(stage.own.begin(), stage.own.end(), 255), 1000)
        << "the box and its shadow";
    const std::vector<int> theirs = darkness(stage.scene);
    stage.scene.keepPicture("foreign-shader-system-pssm");
    EXPECT_LT(differing(stage.own, theirs), 0.3);
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
}

/// They compare clip z, which is less than the depth by twice the near distance, and so go on to the
/// next map that much later.
TEST(ForeignMaterials, OfTheShaderSystemTakePaddedCascades) {
    // The first slice ends in the box's shadow.
    ShaderSystemCascades stage(1.5F, {17, 30});
    const std::vector<int> without = darkness(stage.scene);
    stage.scene.keepPicture("foreign-shader-system-not-padded");
#if OGRE_VERSION_MAJOR < 14 // which shows all of it here, padded or not
    EXPECT_GT(differing(stage.own, without), 0.2) << "half of the shadow is missing";
#endif
    CascadeOptions options = stage.cascades->getOptions();
    options.splitPadding = 3.0;
    stage.cascades->setOptions(options);
    const std::vector<int> padded = darkness(stage.scene);
    stage.scene.keepPicture("foreign-shader-system-padded");
    EXPECT_LT(differing(stage.own, padded), 0.1);
}

/// Where OGRE's PSSM served them before, with the points that they have. Slices end in the wall's
/// shadow, and one in the box's.
TEST(ForeignMaterials, OfTheShaderSystemReadCascadesInPlaceOfPssm) {
    struct Case {
        const char* name;
        std::vector<Ogre::Real> points;
        float padding;
    };
    constexpr float Near = 1.5F;
    for (const Case& tested :
         {Case{"as in OGRE's sample", {Near, 17, 30, 100}, 2 * Near},
          Case{"padded too little", {Near, 17, 30, 100}, 0},
          Case{"the near plane is behind the first slice", {0.5F, 1.2F, 17, 100}, 0}}) {
        SCOPED_TRACE(tested.name);
        ShaderSystemCascades stage(Near, {tested.points[1], tested.points[2]}, true);
        Ogre::Light& sun = *stage.scene.lights.front();
        const auto pssm = std::make_shared<Ogre::PSSMShadowCameraSetup>();
        pssm->setSplitPoints(tested.points);
        pssm->setSplitPadding(tested.padding);
        sun.setCustomShadowCameraSetup(pssm);
        const double before = differing(stage.own, darkness(stage.scene));
        stage.scene.keepPicture("foreign-shader-system-ogres-pssm");
        for (const char* const technique : {"", "Uniform"}) {
            sun.setCustomShadowCameraSetup(
                *technique == '\0' ? CascadesShadowCameraSetup::create(pssm)
                                   : CascadesShadowCameraSetup::create(
                                         pssm, Samples::findShadowSetup(technique)->create()));
            LogCollector log;
            const std::vector<int> drawn = darkness(stage.scene);
            stage.scene.keepPicture(std::string("foreign-shader-system-in-place-of-pssm") +
                                    technique);
            EXPECT_EQ(
                missingWithin(stage.own, drawn, stage.scene.stage.viewport().getActualWidth()), 0U)
                << technique;
            EXPECT_LT(differing(stage.own, drawn), 0.15) << technique << "; PSSM: " << before;
            EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
        }
    }
}

/// OGRE takes the ambient light out of its receiver before it first draws with it, and the shader
/// system copies the receiver as it is at its first sight of it.
TEST(ForeignMaterials, OfOgreItselfReceiveAdditiveShadowsUnderAmbientLight) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "");
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    Ogre::Light& sun = *scene.lights.front();
    for (Ogre::Light* light : scene.lights)
        light->setVisible(light == &sun);
    ShaderSystem system(scene);
    LogCollector log;
    manager.setShadowTextureCasterMaterial(nullptr);
    manager.setShadowTextureSettings(512, 1, Ogre::PF_BYTE_RGBA);
    constexpr int Ambient = 102;
    manager.setAmbientLight(Ogre::ColourValue(1, 1, 1) * (Ambient / 255.0F));
    constexpr int Sunlight = 43; // 0.3 of the light, 0.8 of the surface, at 45 degrees
    wearPlain(scene);
    for (int frame = 0; frame < 2; ++frame) {
        const std::vector<int> picture = scene.draw();
        EXPECT_NEAR(picture[scene.pixelOf(Ogre::Vector3(-2, 0, 0))], Ambient, 1) << "in shadow";
        EXPECT_NEAR(picture[scene.pixelOf(Ogre::Vector3(4, 0, 4))], Ambient + Sunlight, 2)
            << "in sunlight, ambient light but once";
    }
    scene.keepPicture("foreign-shader-system-additive");
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
}

} // namespace
} // namespace Lixel::Tests

// Lixel's setups under materials that know nothing of Lixel, such as OGRE's own.

#include "MaterialScene.h"

#include <Lixel/material/ShadowMaterials.h>
#include <Lixel/setup/ShadowCameraSetups.h>

namespace Lixel::Tests {
namespace {

struct ForeignCase {
    const char* name;
    Ogre::PixelFormat format;
    const char* setup; ///< one map each; or empty for three cascades
};

class ForeignMaterials : public testing::TestWithParam<ForeignCase> {};

/// The same shadows as in Lixel's materials, except what another bias makes of their edges.
TEST_P(ForeignMaterials, ShowTheSameShadows) {
    const ForeignCase& foreign = GetParam();
    constexpr std::size_t Cascades = 3;
    const bool several = foreign.setup[0] == '\0';
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, "");
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    Ogre::Light& sun = *scene.lights.front();
    for (Ogre::Light* light : scene.lights)
        light->setVisible(light == &sun);
    // Their casters write depth as it comes, so these are compared where it has 24 bits or more.
    const std::vector<Ogre::Real> splits{15, 25};
    if (several) {
        auto setup = std::make_shared<CascadesShadowCameraSetup>(
            Samples::findShadowSetup("Uniform")->create());
        setup->setSplitDepths(splits);
        sun.setCustomShadowCameraSetup(setup);
        manager.setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL, Cascades);
    } else {
        sun.setCustomShadowCameraSetup(Samples::findShadowSetup(foreign.setup)->create());
    }

    scene.wear("Lixel/Surface/Integrated/Maps3");
    const std::vector<int> own = scene.draw();
    sun.setCastShadows(false);
    ASSERT_GT(differing(own, scene.draw()), 0.5) << "there is no shadow to compare";
    sun.setCastShadows(true);

    auto& materials = Ogre::MaterialManager::getSingleton();
    LogCollector log;
    manager.setShadowTextureSettings(512, Cascades, foreign.format);
    setShadowMaterials(manager, "", "Test/DepthCaster");
    const Ogre::MaterialPtr pssm = materials.getByName("Test/Pssm");
    if (several)
        pssm->getTechnique(0)->getPass(0)->getFragmentProgramParameters()->setNamedConstant(
            "splitDepths", Ogre::Vector4(splits[0], splits[1], 1e30F, 1e30F));
    scene.wear("Test/Pssm");
    const std::vector<int> theirs = scene.draw();
    scene.keepPicture(std::string("foreign-") + foreign.name);
    EXPECT_LT(differing(own, theirs, 25), 0.5);
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
}

INSTANTIATE_TEST_SUITE_P(Cases, ForeignMaterials,
                         testing::Values(ForeignCase{"UniformDepth16", Ogre::PF_DEPTH16, "Uniform"},
                                         ForeignCase{"XpsmDepth16", Ogre::PF_DEPTH16, "XPSM"},
                                         ForeignCase{"XpsmDepth32", Ogre::PF_DEPTH32F, "XPSM"},
                                         ForeignCase{"OptimalDepth32", Ogre::PF_DEPTH32F,
                                                     "Optimal"},
                                         ForeignCase{"LiSPSMDepth16", Ogre::PF_DEPTH16, "LiSPSM"},
                                         ForeignCase{"PssmWithCascades", Ogre::PF_DEPTH16, ""}),
                         [](const auto& foreign) { return std::string(foreign.param.name); });

} // namespace
} // namespace Lixel::Tests

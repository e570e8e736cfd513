// The scene manager's fog over surfaces lit in several passes.

#include "MaterialScene.h"

#include <cmath>

namespace Lixel::Tests {
namespace {

struct FogCase {
    const char* name;
    Ogre::FogMode mode;
    float density, start, end;
};

class Fog : public testing::TestWithParam<FogCase> {
protected:
    /// How much of a surface is seen through the fog, by OGRE's definition of the modes.
    static double throughFog(double depth) {
        const FogCase& fog = GetParam();
        const double thickness = static_cast<double>(fog.density) * depth;
        switch (fog.mode) {
        case Ogre::FOG_EXP:
            return std::exp(-thickness);
        case Ogre::FOG_EXP2:
            return std::exp(-thickness * thickness);
        case Ogre::FOG_LINEAR:
            return std::clamp((static_cast<double>(fog.end) - depth) /
                                  static_cast<double>(fog.end - fog.start),
                              0.0, 1.0);
        default:
            return 1.0;
        }
    }

    static void expectFog(MaterialScene& scene, const std::string& name) {
        scene.stage.sceneManager().setAmbientLight(Ogre::ColourValue(0.2F, 0.2F, 0.2F));
        constexpr double Colour = 0.9;
        const std::vector<int> clear = scene.draw();
        const FogCase& fog = GetParam();
        scene.stage.sceneManager().setFog(fog.mode, Ogre::ColourValue(0.9F, 0.9F, 0.9F),
                                          fog.density, fog.start, fog.end);
        const std::vector<int> foggy = scene.draw();
        scene.keepPicture("fog-" + name + "-" + fog.name);
        // In the light, in each light's shadow, near and far.
        for (const Ogre::Vector3& ws :
             {Ogre::Vector3(4, 0, 2), Ogre::Vector3(-2, 0, 0), Ogre::Vector3(2, 0, 0),
              Ogre::Vector3(0, 0, 2.5F), Ogre::Vector3(0, 0, 9), Ogre::Vector3(-8, 0, -30)}) {
            const double depth =
                -static_cast<double>((scene.stage.camera().getViewMatrix() * ws).z);
            const double f = throughFog(depth);
            const std::size_t pixel = scene.pixelOf(ws);
            EXPECT_NEAR(foggy[pixel], f * clear[pixel] + (1.0 - f) * 255.0 * Colour, 3.0)
                << "at " << ws << ", " << depth << " units away, where " << f << " comes through";
        }
    }
};

TEST_P(Fog, CoversAdditiveReceiversOnce) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver/Bilinear");
    expectFog(scene, "additive");
}

TEST_P(Fog, CoversIntegratedReceiversOnce) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, "");
    scene.wear("Lixel/Surface/Integrated");
    expectFog(scene, "integrated");
}

TEST_P(Fog, CoversSurfacesWithoutShadows) {
    MaterialScene scene(Ogre::SHADOWTYPE_NONE, "");
    expectFog(scene, "none");
}

/// A modulative pass darkens the picture, fog and all; so it has to darken less in the fog.
TEST_P(Fog, LightensModulativeShadows) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_MODULATIVE, "Lixel/Receiver/Modulative");
    for (Ogre::Light* light : scene.lights)
        light->setVisible(light == scene.lights.front());
    const FogCase& fog = GetParam();
    scene.stage.sceneManager().setFog(fog.mode, Ogre::ColourValue(0.9F, 0.9F, 0.9F), fog.density,
                                      fog.start, fog.end);
    const Ogre::Vector3 inShadow(-2, 0, 0);
    const int shadowed = scene.draw()[scene.pixelOf(inShadow)];
    scene.lights.front()->setCastShadows(false);
    const int bare = scene.draw()[scene.pixelOf(inShadow)];
    const double f =
        throughFog(-static_cast<double>((scene.stage.camera().getViewMatrix() * inShadow).z));
    EXPECT_NEAR(shadowed, bare * (1.0 - 0.5 * f), 3.0);
}

INSTANTIATE_TEST_SUITE_P(Modes, Fog,
                         testing::Values(FogCase{"None", Ogre::FOG_NONE, 0.1F, 1, 2},
                                         FogCase{"Exp", Ogre::FOG_EXP, 0.03F, 0, 0},
                                         FogCase{"Exp2", Ogre::FOG_EXP2, 0.04F, 0, 0},
                                         FogCase{"Linear", Ogre::FOG_LINEAR, 0, 5, 45}),
                         [](const auto& fog) { return std::string(fog.param.name); });

} // namespace
} // namespace Lixel::Tests

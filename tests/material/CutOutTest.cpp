// Holes that a texture's alpha cuts into surfaces, and into their shadows.

#include "MaterialScene.h"

#include <Lixel/setup/ShadowCameraSetups.h>

#include <array>

namespace Lixel::Tests {
namespace {

enum class Cut { None, Tested, Blended };

/// Four columns: the second and the fourth are holes.
Ogre::TexturePtr bars() {
    const Ogre::TexturePtr texture = Ogre::TextureManager::getSingleton().createManual(
        "Bars", Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, 4, 1, 0, Ogre::PF_BYTE_RGBA);
    std::array<Ogre::uint8, 16> texels{};
    texels.fill(255);
    texels[4 + 3] = texels[12 + 3] = 0;
    texture->getBuffer()->blitFromMemory(
        Ogre::PixelBox(4, 1, 1, Ogre::PF_BYTE_RGBA, texels.data()));
    return texture;
}

/// A panel of 4 x 4 units that stands on the ground, across the sun's rays, with the texture on it.
class Panel : public MaterialScene {
public:
    Panel(Ogre::ShadowTechnique technique, Cut cut)
        : MaterialScene(technique,
                        technique == Ogre::SHADOWTYPE_TEXTURE_ADDITIVE ? "Lixel/Receiver" : ""),
          mBase(technique == Ogre::SHADOWTYPE_TEXTURE_ADDITIVE ? "Lixel/Surface"
                                                               : "Lixel/Surface/Integrated") {
        wear(mBase);
        box->setVisible(false);
        for (Ogre::Light* light : lights)
            light->setVisible(light == lights.front());
        Ogre::MeshManager::getSingleton().createPlane(
            "Panel", Ogre::RGN_DEFAULT, Ogre::Plane(Ogre::Vector3::UNIT_X, 0.0F), 4, 4, 1, 1, true,
            1, 1, 1, Ogre::Vector3::UNIT_Y);
        Ogre::Entity* const entity = stage.sceneManager().createEntity("Panel");
        entity->setMaterial(material(cut));
        panel =
            stage.sceneManager().getRootSceneNode()->createChildSceneNode(Ogre::Vector3(0, 2, 0));
        panel->attachObject(entity);
    }

    /// How bright the ground is behind each of the columns.
    std::array<int, 4> behind() {
        const std::vector<int> picture = draw();
        std::array<int, 4> found{};
        for (std::size_t i = 0; i < 4; ++i)
            found[i] = picture[pixelOf(Ogre::Vector3(-2, 0, -1.5F + static_cast<Ogre::Real>(i)))];
        return found;
    }

    Ogre::SceneNode* panel;

private:
    Ogre::MaterialPtr material(Cut cut) const {
        Ogre::MaterialPtr made =
            Ogre::MaterialManager::getSingleton().getByName(mBase)->clone("Barred");
        for (Ogre::Pass* pass : made->getTechnique(0)->getPasses()) {
            Ogre::TextureUnitState& unit = *pass->getTextureUnitState("DiffuseMap");
            unit.setTexture(mBars);
            unit.setTextureFiltering(Ogre::TFO_NONE);
            pass->setCullingMode(Ogre::CULL_NONE);
            if (cut == Cut::Tested) pass->setAlphaRejectSettings(Ogre::CMPF_GREATER_EQUAL, 128);
            if (cut == Cut::Blended) pass->setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
        }
        made->setTransparencyCastsShadows(true);
        return made;
    }

    std::string mBase;
    Ogre::TexturePtr mBars = bars();
};

class CutOut : public testing::TestWithParam<Ogre::ShadowTechnique> {};

INSTANTIATE_TEST_SUITE_P(Techniques, CutOut,
                         testing::Values(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE,
                                         Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED));

/// Every other one of four is dark.
void expectBars(const std::array<int, 4>& ground) {
    EXPECT_EQ(ground[0] == 0, ground[2] == 0);
    EXPECT_EQ(ground[1] == 0, ground[3] == 0);
    EXPECT_NE(ground[0] == 0, ground[1] == 0) << "the holes are not in the shadow";
}

TEST_P(CutOut, CastsNoShadowWhereItIsCut) {
    Panel tested(GetParam(), Cut::Tested);
    expectBars(tested.behind());
    tested.keepPicture("cut-out-" + std::to_string(GetParam()));
}

TEST_P(CutOut, IsSolidWithoutAlphaRejection) {
    Panel solid(GetParam(), Cut::None);
    EXPECT_EQ(solid.behind(), (std::array<int, 4>{0, 0, 0, 0}));
}

TEST_P(CutOut, OfABlendedSurfaceIsCutByHalf) {
    Panel blended(GetParam(), Cut::Blended);
    expectBars(blended.behind());
}

/// What follows a caster with holes is solid again.
TEST_P(CutOut, LeavesOtherCastersAlone) {
    Panel scene(GetParam(), Cut::Tested);
    scene.box->setVisible(true);
    scene.box->setPosition(6, 1, 0);
    const std::vector<int> picture = scene.draw();
    EXPECT_EQ(picture[scene.pixelOf(Ogre::Vector3(4.5F, 0, 0))], 0);
    expectBars(scene.behind());
}

/// One sees through the holes, to what is behind them.
TEST_P(CutOut, ShowsWhatIsBehind) {
    const auto seen = [&](Cut cut, bool isThere) {
        Panel scene(GetParam(), cut);
        scene.panel->setVisible(isThere);
        scene.panel->getAttachedObject(0)->setCastShadows(false);
        scene.panel->yaw(Ogre::Degree(-60)); // its front towards the viewer, and the sun
        return scene.draw();
    };
    const std::vector<int> none = seen(Cut::None, false);
    const double solid = differing(seen(Cut::None, true), none);
    const double cut = differing(seen(Cut::Tested, true), none);
    EXPECT_GT(solid, 1.0);
    EXPECT_NEAR(cut, solid / 2, 0.1 * solid);
}

} // namespace
} // namespace Lixel::Tests

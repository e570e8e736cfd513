// Pictures of a surface with holes and of its shadow, beside the truth.

#include "TestStage.h"

#include "common/Surface.h"

#include <array>

namespace Lixel::Samples {
namespace {

using Ogre::Vector3;

/// Columns of alpha: bars and holes, two of each.
Ogre::TexturePtr makeBars() {
    const auto texture = Ogre::TextureManager::getSingleton().createManual(
        "drawn-bars", Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, 4, 1, 0, Ogre::PF_BYTE_RGBA);
    std::array<Ogre::uchar, 16> texels{};
    texels.fill(255);
    texels[7] = texels[15] = 0;
    texture->getBuffer()->blitFromMemory(
        Ogre::PixelBox(4, 1, 1, Ogre::PF_BYTE_RGBA, texels.data()));
    return texture;
}

/// The ground and the sun of BoxOnGround, and in place of its box an upright panel of 8 x 8.
class DrawnPanel : public ::testing::Test {
protected:
    DrawnPanel() {
        scene.box->setVisible(false);
        Ogre::MeshManager::getSingleton().createPlane("panel", Ogre::RGN_DEFAULT,
                                                      Ogre::Plane(Vector3::UNIT_Z, 0), 4, 4, 1, 1,
                                                      true, 1, 1, 1, Vector3::UNIT_Y);
        Ogre::Entity* const entity = scene.stage.sceneManager().createEntity("panel");
        material = makeSurface("panel", Ogre::ColourValue::White);
        for (Ogre::Pass* pass : material->getTechnique(0)->getPasses()) {
            pass->setCullingMode(Ogre::CULL_NONE);
            pass->setAlphaRejectSettings(Ogre::CMPF_GREATER_EQUAL, 60);
            pass->getTextureUnitState(0)->setTexture(mBars);
            // The picture's smaller levels are blurred, and the truth has none.
            pass->getTextureUnitState(0)->setTextureFiltering(Ogre::FO_LINEAR, Ogre::FO_LINEAR,
                                                              Ogre::FO_NONE);
        }
        entity->setMaterial(material);
        panel =
            scene.stage.sceneManager().getRootSceneNode()->createChildSceneNode(Vector3(3, 4, 2));
        panel->setScale(2, 2, 2);
        panel->yaw(Ogre::Degree(60));
        panel->attachObject(entity);
        scene.stage.setShadowMapSize(2048);
    }

    /// Of the next frame, beside the truth with holes or without, in percent.
    double errorBeside(bool withHoles) {
        TriangleScene triangles = collectTriangles(scene.stage.sceneManager());
        if (!withHoles)
            for (Triangle& triangle : triangles.triangles)
                triangle.mask = NoMask;
        return measureError(scene.stage, ShadowOracle(std::move(triangles)), 100).error;
    }

    Tests::BoxOnGround scene;
    Ogre::MaterialPtr material;
    Ogre::SceneNode* panel = nullptr;

private:
    Ogre::TexturePtr mBars = makeBars();
};

TEST_F(DrawnPanel, HasTheTruthsHolesAndShadows) {
    EXPECT_GT(errorBeside(false), 1.5) << "the panel is too small to mean anything";
    EXPECT_LT(errorBeside(true), 0.1);
}

TEST_F(DrawnPanel, IsCutWhereItsTextureUnitHasTheTexture) {
    for (Ogre::Pass* pass : material->getTechnique(0)->getPasses()) {
        pass->getTextureUnitState(0)->setTextureScroll(0.1F, 0);
        pass->getTextureUnitState(0)->setTextureUScale(0.6F);
        pass->getTextureUnitState(0)->setTextureFiltering(Ogre::TFO_NONE);
        pass->getTextureUnitState(0)->setTextureAddressingMode(Ogre::TAM_CLAMP);
    }
    EXPECT_GT(errorBeside(false), 3.0);
    EXPECT_LT(errorBeside(true), 0.1);
}

} // namespace
} // namespace Lixel::Samples

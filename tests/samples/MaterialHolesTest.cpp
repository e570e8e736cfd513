// Holes in materials, and how triangles get them.

#include "OgreTest.h"

#include "common/MaterialHoles.h"
#include "common/MeshBuilder.h"
#include "common/ShadowOracle.h"
#include "common/Triangles.h"

#include <array>
#include <cmath>

namespace Lixel::Samples {
namespace {

using Wrap = AlphaMask::Wrap;

class MaterialHolesTest : public OgreTest {
protected:
    /// A texture of these bytes.
    static Ogre::TexturePtr makeTexture(const std::string& name, unsigned width, unsigned height,
                                        Ogre::PixelFormat format,
                                        const std::vector<std::uint8_t>& bytes) {
        const auto texture = Ogre::TextureManager::getSingleton().createManual(
            name, Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, width, height, 0, format);
        std::vector<std::uint8_t> copy = bytes;
        texture->getBuffer()->blitFromMemory(Ogre::PixelBox(width, height, 1, format, copy.data()));
        return texture;
    }

    /// Three columns and two rows of alpha: 0 to 250 in steps of 50.
    static Ogre::TexturePtr makeSteps() {
        std::vector<std::uint8_t> bytes(4 * 6, 77);
        for (std::size_t i = 0; i < 6; ++i)
            bytes[4 * i + 3] = static_cast<std::uint8_t>(50 * i);
        return makeTexture("steps", 3, 2, Ogre::PF_BYTE_RGBA, bytes);
    }

    /// An alpha-tested material that shows a texture.
    static Ogre::MaterialPtr makeTested(const Ogre::TexturePtr& texture,
                                        Ogre::CompareFunction comparison = Ogre::CMPF_GREATER_EQUAL,
                                        unsigned char least = 100) {
        const auto material =
            Ogre::MaterialManager::getSingleton().create("tested", Ogre::RGN_DEFAULT);
        Ogre::Pass& pass = passOf(material);
        pass.setAlphaRejectSettings(comparison, least);
        pass.createTextureUnitState()->setTexture(texture);
        return material;
    }

    static Ogre::Pass& passOf(const Ogre::MaterialPtr& material) {
        return *material->getTechnique(0)->getPass(0);
    }
};

TEST_F(MaterialHolesTest, AreThoseOfAlphaRejection) {
    for (const auto comparison : {Ogre::CMPF_GREATER_EQUAL, Ogre::CMPF_GREATER}) {
        const auto material =
            makeTested(comparison == Ogre::CMPF_GREATER
                           ? Ogre::TextureManager::getSingleton().getByName("steps")
                           : makeSteps(),
                       comparison);
        const auto holes = findHoles(*material);
        ASSERT_TRUE(holes);
        EXPECT_EQ(holes->mask.width, 3);
        EXPECT_EQ(holes->mask.height, 2);
        EXPECT_EQ(holes->mask.alpha, (std::vector<std::uint8_t>{0, 50, 100, 150, 200, 250}));
        EXPECT_EQ(holes->mask.least, 100.0);
        EXPECT_TRUE(holes->mask.bilinear);
        EXPECT_EQ(holes->mask.wrap, (std::array{Wrap::Repeat, Wrap::Repeat}));
        EXPECT_TRUE(holes->uvFromMesh.isApprox(Eigen::Affine3f::Identity()));
        EXPECT_EQ(holes->uvSet, 0U);
        Ogre::MaterialManager::getSingleton().remove(material);
    }
}

TEST_F(MaterialHolesTest, FollowTheTextureUnit) {
    const auto material = makeTested(makeSteps());
    Ogre::TextureUnitState& unit = *passOf(material).getTextureUnitState(0);
    unit.setTextureAddressingMode({Ogre::TAM_MIRROR, Ogre::TAM_BORDER, Ogre::TAM_CLAMP});
    unit.setTextureBorderColour(Ogre::ColourValue(1, 1, 1, 0.2F));
    unit.setTextureFiltering(Ogre::TFO_NONE);
    unit.setTextureCoordSet(1);
    unit.setTextureScroll(0.25F, -0.5F);
    auto holes = findHoles(*material);
    ASSERT_TRUE(holes);
    EXPECT_EQ(holes->mask.wrap, (std::array{Wrap::Mirror, Wrap::Border}));
    EXPECT_EQ(holes->mask.borderAlpha, 51);
    EXPECT_FALSE(holes->mask.bilinear);
    EXPECT_EQ(holes->uvSet, 1U);
    // As a vertex program multiplies it.
    const Ogre::Vector4 there = unit.getTextureTransform() * Ogre::Vector4(0.5F, 0.5F, 0, 1);
    const Eigen::Vector3f uv = holes->uvFromMesh * Eigen::Vector3f(0.5F, 0.5F, 0.0F);
    EXPECT_FLOAT_EQ(uv.x(), there.x);
    EXPECT_FLOAT_EQ(uv.y(), there.y);
    EXPECT_GT((uv - Eigen::Vector3f(0.5F, 0.5F, 0.0F)).norm(), 0.2F);
}

TEST_F(MaterialHolesTest, AreInTheFirstTextureOfMoreThanOneTexel) {
    const auto material =
        makeTested(makeTexture("dot", 1, 1, Ogre::PF_BYTE_RGBA, {255, 255, 255, 0}));
    EXPECT_FALSE(findHoles(*material));
    passOf(material).createTextureUnitState()->setTexture(makeSteps());
    const auto holes = findHoles(*material);
    ASSERT_TRUE(holes);
    EXPECT_EQ(holes->mask.width, 3);
}

TEST_F(MaterialHolesTest, AreNotInWhatShowsAllOfItself) {
    const Ogre::TexturePtr steps = makeSteps();
    const auto material = makeTested(steps, Ogre::CMPF_ALWAYS_PASS);
    EXPECT_FALSE(findHoles(*material)) << "it does not reject";
    passOf(material).setAlphaRejectSettings(Ogre::CMPF_GREATER_EQUAL, 0);
    EXPECT_FALSE(findHoles(*material)) << "nothing is less than 0";
    passOf(material).setAlphaRejectSettings(Ogre::CMPF_GREATER_EQUAL, 100);
    passOf(material).getTextureUnitState(0)->setTexture(
        makeTexture("opaque", 2, 1, Ogre::PF_BYTE_RGBA, {0, 0, 0, 200, 0, 0, 0, 100}));
    EXPECT_FALSE(findHoles(*material)) << "no texel is less";
    passOf(material).getTextureUnitState(0)->setTexture(
        makeTexture("plain", 2, 2, Ogre::PF_BYTE_RGB, std::vector<std::uint8_t>(12, 0)));
    EXPECT_FALSE(findHoles(*material)) << "the texture has no alpha";
    passOf(material).removeAllTextureUnitStates();
    EXPECT_FALSE(findHoles(*material)) << "there is no texture";
}

TEST_F(MaterialHolesTest, OfBlendedSurfacesThatCastAreCutByHalf) {
    const auto material = makeTested(makeSteps(), Ogre::CMPF_ALWAYS_PASS);
    material->setTransparencyCastsShadows(true);
    EXPECT_FALSE(findHoles(*material)) << "it is not blended";
    passOf(material).setSceneBlending(Ogre::SBT_ADD);
    EXPECT_FALSE(findHoles(*material)) << "its alpha does not matter";
    passOf(material).setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
    ASSERT_TRUE(findHoles(*material));
    EXPECT_EQ(findHoles(*material)->mask.least, 127.5);
    passOf(material).setAlphaRejectSettings(Ogre::CMPF_GREATER, 60);
    EXPECT_EQ(findHoles(*material)->mask.least, 60.0);
    passOf(material).setAlphaRejectFunction(Ogre::CMPF_ALWAYS_PASS);
    material->setTransparencyCastsShadows(false);
    EXPECT_FALSE(findHoles(*material));
}

TEST_F(MaterialHolesTest, OfOtherComparisonsAreRefused) {
    const auto material = makeTested(makeSteps(), Ogre::CMPF_LESS);
    EXPECT_THROW(findHoles(*material), Ogre::InvalidParametersException);
}

TEST_F(MaterialHolesTest, AreReadFromEveryKindOfAlpha) {
    EXPECT_EQ(
        findHoles(*makeTested(makeTexture("alpha", 2, 1, Ogre::PF_A8, {40, 200})))->mask.alpha,
        (std::vector<std::uint8_t>{40, 200}));
    passOf(Ogre::MaterialManager::getSingleton().getByName("tested"))
        .getTextureUnitState(0)
        ->setTexture(makeTexture("grey", 2, 1, Ogre::PF_BYTE_LA, {255, 40, 0, 200}));
    EXPECT_EQ(findHoles(*Ogre::MaterialManager::getSingleton().getByName("tested"))->mask.alpha,
              (std::vector<std::uint8_t>{40, 200}));
}

/// One block of 4 x 4 texels: alpha 255 on the left, 0 on the right.
TEST_F(MaterialHolesTest, AreReadFromCompressedTextures) {
    if (!Ogre::Root::getSingleton().getRenderSystem()->getCapabilities()->hasCapability(
            Ogre::RSC_TEXTURE_COMPRESSION_DXT))
        GTEST_SKIP() << "this driver takes no compressed textures";
    // Two bytes of alpha for each row, four bits a texel; then two colours, and which of them.
    std::vector<std::uint8_t> block(16, 0);
    for (std::size_t row = 0; row < 4; ++row)
        block[2 * row] = 255;
    const auto holes = findHoles(*makeTested(makeTexture("block", 4, 4, Ogre::PF_DXT3, block)));
    ASSERT_TRUE(holes);
    for (std::size_t i = 0; i < 16; ++i)
        EXPECT_EQ(holes->mask.alpha[i], i % 4 < 2 ? 255 : 0) << i;
}

// --- triangles ----------------------------------------------------------------------------------

/// A rectangle of 4 x 2 in x and y that shows the steps once, the first row on top.
class SteppedPanel : public MaterialHolesTest {
protected:
    SteppedPanel() {
        MeshBuilder mesh;
        const std::array corners{Ogre::Vector3(-2, 1, 0), Ogre::Vector3(-2, -1, 0),
                                 Ogre::Vector3(2, -1, 0), Ogre::Vector3(2, 1, 0)};
        const std::array uvs{Ogre::Vector2(0, 0), Ogre::Vector2(0, 1), Ogre::Vector2(1, 1),
                             Ogre::Vector2(1, 0)};
        const std::array<Ogre::uint32, 6> indices{0, 1, 2, 0, 2, 3};
        mesh.triangles(corners, {}, uvs, indices);
        panel = mesh.build("panel");
        material = makeTested(makeSteps());
        passOf(material).getTextureUnitState(0)->setTextureFiltering(Ogre::TFO_NONE);
    }

    Ogre::Entity* addPanel(Ogre::SceneNode& node) {
        Ogre::Entity* const entity = scene->createEntity(panel);
        entity->setMaterial(material);
        node.attachObject(entity);
        return entity;
    }

    /// The alpha at a place in the plane of the panels, where a triangle of the scene is.
    static double alphaAt(const TriangleScene& triangles, double x, double y) {
        for (const Triangle& triangle : triangles.triangles) {
            Eigen::Matrix3d corners;
            for (int k = 0; k < 3; ++k)
                corners.col(k) = triangles.positions[triangle.vertices[static_cast<std::size_t>(k)]]
                                     .head<2>()
                                     .homogeneous();
            const Eigen::Vector3d weights = corners.inverse() * Eigen::Vector3d(x, y, 1.0);
            if (weights.minCoeff() < 0.0 || triangle.mask == NoMask) continue;
            Eigen::Vector2d uv = Eigen::Vector2d::Zero();
            for (int k = 0; k < 3; ++k)
                uv += weights[k] *
                      triangles.uvs[triangle.vertices[static_cast<std::size_t>(k)]].cast<double>();
            return triangles.masks[triangle.mask].alphaAt(uv);
        }
        return -1.0;
    }

    Ogre::MeshPtr panel;
    Ogre::MaterialPtr material;
};

TEST_F(SteppedPanel, HasItsTextureWhereItIsDrawn) {
    addPanel(child({10, 0, 0}));
    Ogre::SceneNode& mirrored = child({-10, 0, 0});
    mirrored.setScale(-1, 1, 1);
    addPanel(mirrored);
    const TriangleScene triangles = collectTriangles(*scene);
    ASSERT_EQ(triangles.masks.size(), 1U) << "one for all that wear the material";
    ASSERT_EQ(triangles.triangles.size(), 4U);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 2; ++row) {
            const double x = (column - 1) * 4.0 / 3.0 + 0.1;
            const double y = 0.5 - row;
            EXPECT_EQ(alphaAt(triangles, 10.0 + x, y), 50.0 * (3 * row + column));
            EXPECT_EQ(alphaAt(triangles, -10.0 - x, y), 50.0 * (3 * row + column));
        }
}

TEST_F(SteppedPanel, IsScrolledWithItsUnit) {
    addPanel(child());
    passOf(material).getTextureUnitState(0)->setTextureScroll(1.0F / 3.0F, 0.0F);
    const TriangleScene triangles = collectTriangles(*scene);
    const Ogre::Vector4 there = passOf(material).getTextureUnitState(0)->getTextureTransform() *
                                Ogre::Vector4(0.5F, 0.25F, 0, 1);
    const int column = static_cast<int>(std::floor(3.0 * (static_cast<double>(there.x) + 1.0))) % 3;
    EXPECT_NE(column, 1);
    EXPECT_EQ(alphaAt(triangles, 0.0, 0.5), 50.0 * column);
}

TEST_F(SteppedPanel, CostsOthersNothing) {
    MeshBuilder mesh;
    mesh.boxOn(Ogre::Vector3::ZERO, 1, 1, 1);
    child({0, 0, -5}).attachObject(scene->createEntity(mesh.build("box")));
    EXPECT_TRUE(collectTriangles(*scene).masks.empty());
    EXPECT_TRUE(collectTriangles(*scene).uvs.empty());
    addPanel(child());
    const TriangleScene triangles = collectTriangles(*scene);
    ASSERT_EQ(triangles.triangles.size(), 14U);
    for (std::size_t i = 0; i < 14; ++i)
        EXPECT_EQ(triangles.triangles[i].mask, i < 12 ? NoMask : 0U);
    EXPECT_NO_THROW(ShadowOracle{triangles});
}

TEST_F(SteppedPanel, WithoutTextureCoordinatesShowsOneTexel) {
    Ogre::ManualObject* const object = scene->createManualObject();
    object->begin("tested", Ogre::RenderOperation::OT_TRIANGLE_LIST);
    for (const auto& [x, y] : {std::pair{0.0F, 0.0F}, std::pair{1.0F, 0.0F}, std::pair{0.0F, 1.0F}})
        object->position(x, y, 0);
    object->end();
    child().attachObject(object);
    EXPECT_EQ(alphaAt(collectTriangles(*scene), 0.2, 0.2), 0.0);
}

} // namespace
} // namespace Lixel::Samples

// Lixel's own programs in each of their languages: one scene, the same picture.
#include "LanguageScene.h"

#include <gtest/gtest.h>

namespace Lixel::Tests {
namespace {

/// Of the pictures' pixels: what rounding in another order may move across a shadow's edge.
constexpr double GreatestShare = 1e-4;

const Way Ways[] = {
    {"Additive", Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver/Bilinear", "Lixel/Surface", 1},
    {"Integrated", Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, nullptr,
     "Lixel/Surface/Integrated", 1},
    {"Cascades", Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, nullptr,
     "Lixel/Surface/Integrated/Maps3", 3},
    {"Modulative", Ogre::SHADOWTYPE_TEXTURE_MODULATIVE, "Lixel/Receiver/Modulative/Bilinear",
     "Lixel/Surface", 1}};

class Languages : public testing::TestWithParam<Way> {};

TEST_P(Languages, DrawTheSamePicture) {
    const Way& way = GetParam();
    const auto glsl = pictureIn("glsl", GL3Plus, way);
    EXPECT_LE(share(glsl, pictureIn("hlsl", GL3Plus, way)), GreatestShare);
    EXPECT_LE(share(glsl, pictureIn("cg", GL3PlusSeparate, way)), GreatestShare);
    EXPECT_LE(share(glsl, pictureIn("cg", LegacyGL, way)), GreatestShare);
    EXPECT_LE(share(glsl, pictureIn("glsl", LegacyGL, way)), GreatestShare);
}

TEST(LanguagesScene, HasShadows) {
    Way lit = Ways[0];
    lit.technique = Ogre::SHADOWTYPE_NONE;
    EXPECT_GT(share(pictureIn("glsl", GL3Plus, Ways[0]), pictureIn("glsl", GL3Plus, lit)), 0.02);
}

// A modulative receiver darkens holes too: it gets no texture.
TEST(LanguagesScene, HolesHideNoShadowsBehindThem) {
    Way way = Ways[3];
    const auto last = pictureIn("glsl", GL3Plus, way);
    way.fenceFirst = true;
    EXPECT_EQ(share(last, pictureIn("glsl", GL3Plus, way)), 0.0);
}

INSTANTIATE_TEST_SUITE_P(ShadowTechniques, Languages, testing::ValuesIn(Ways),
                         [](const auto& way) { return std::string(way.param.name); });

} // namespace
} // namespace Lixel::Tests

// The scripts of "Shadow Mapping in Ogre" (Chong 2006, §4), which name programs in GLSL, HLSL and Cg.
#include "LanguageScene.h"

#include <gtest/gtest.h>

namespace Lixel::Tests {
namespace {

/// The article's materials in one of their languages.
///
/// Its GLSL is not drawn: it is for objects without programs of their own, which GL3+ does not have,
/// and there it is taken for supported and gets no vertices, with this plugin or without.
Way articles(const char* language) {
    return {.name = language,
            .technique = Ogre::SHADOWTYPE_TEXTURE_ADDITIVE,
            .receiver = "CustomShadows/ShadowReceiver",
            .surface = "Lixel/Surface",
            .maps = 1,
            .folder = LIXEL_ARTICLE,
            .caster = "CustomShadows/ShadowCaster",
            .kept = language,
            .unit = 20, // it pushes depths back by 1
            .hasFence = false};
}

TEST(ArticlesScripts, DrawShadows) {
    const auto cg = pictureIn("cg", GL3Plus, articles("cg"));
    EXPECT_LE(share(cg, pictureIn("cg", LegacyGL, articles("cg"))), 1e-4);
    EXPECT_LE(share(cg, pictureIn("cg", GL3Plus, articles("hlsl"))), 1e-4);
    EXPECT_LE(share(cg, pictureIn("cg", LegacyGL, articles("hlsl"))), 1e-4);

    Way lit = articles("cg");
    lit.name = "ArticleLit";
    lit.technique = Ogre::SHADOWTYPE_NONE;
    EXPECT_GT(share(cg, pictureIn("cg", GL3Plus, lit)), 0.02);
}

} // namespace
} // namespace Lixel::Tests

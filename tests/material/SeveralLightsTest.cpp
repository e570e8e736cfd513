// Several lights in one picture: each shadow where it is when its light is alone.

#include "MaterialScene.h"

namespace Lixel::Tests {
namespace {

std::string fileName(std::string name) {
    for (char& c : name)
        if (c == '/') c = '-';
    return name;
}

std::string testName(const testing::TestParamInfo<const char*>& info) {
    std::string name;
    for (const char* c = info.param; *c != '\0'; ++c)
        if (*c != '/') name += *c;
    return name;
}

/// How many pixels may differ, in percent: those at edges, by rounding.
constexpr double Rounding = 0.05;

class Additive : public testing::TestWithParam<const char*> {};

TEST_P(Additive, IsTheSumOfItsLights) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver/Bilinear");
    scene.wear(GetParam());
    std::vector<int> sum(scene.draw().size(), 0);
    const std::vector<int> all = scene.draw();
    scene.keepPicture("additive-" + fileName(GetParam()));
    double shadowed = 0.0;
    for (Ogre::Light* light : scene.lights) {
        for (Ogre::Light* other : scene.lights)
            other->setVisible(other == light);
        const std::vector<int> alone = scene.draw();
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += alone[i];
        light->setCastShadows(false);
        shadowed = std::max(shadowed, differing(alone, scene.draw()));
        light->setCastShadows(true);
    }
    EXPECT_GT(shadowed, 1.0) << "no light has a shadow: nothing was compared";
    EXPECT_LT(differing(all, sum), Rounding);
}

INSTANTIATE_TEST_SUITE_P(Materials, Additive,
                         testing::Values("Lixel/Surface", "Test/NotOncePerLight",
                                         "Test/OwnReceiver", "Test/OwnReceiver/NotOncePerLight",
                                         "Test/OwnContentTypeReceiver", "Test/Foreign"),
                         testName);

class Integrated : public testing::TestWithParam<const char*> {};

TEST_P(Integrated, IsTheSumOfItsLights) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, "");
    scene.wear(GetParam());
    std::vector<int> sum(scene.draw().size(), 0);
    const std::vector<int> all = scene.draw();
    scene.keepPicture("integrated-" + fileName(GetParam()));
    for (Ogre::Light* light : scene.lights) {
        for (Ogre::Light* other : scene.lights)
            other->setVisible(other == light);
        const std::vector<int> alone = scene.draw();
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += alone[i];
    }
    EXPECT_LT(differing(all, sum), Rounding);
}

INSTANTIATE_TEST_SUITE_P(Materials, Integrated,
                         testing::Values("Lixel/Surface/Integrated",
                                         "Lixel/Surface/Integrated/Maps2"),
                         testName);

class Modulative : public testing::TestWithParam<const char*> {};

/// Each light's shadow multiplies the picture, by what it does alone.
TEST_P(Modulative, IsTheProductOfItsShadows) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_MODULATIVE, "Lixel/Receiver/Modulative/Bilinear");
    scene.wear(GetParam());
    const std::vector<int> all = scene.draw();
    scene.keepPicture("modulative-" + fileName(GetParam()));
    const auto drawWith = [&](const Ogre::Light* caster) {
        for (Ogre::Light* light : scene.lights)
            light->setCastShadows(light == caster);
        return scene.draw();
    };
    const std::vector<int> bare = drawWith(nullptr);
    std::vector<double> product(bare.begin(), bare.end());
    double shadowed = 0.0;
    for (const Ogre::Light* light : scene.lights) {
        const std::vector<int> alone = drawWith(light);
        shadowed = std::max(shadowed, differing(alone, bare));
        for (std::size_t i = 0; i < product.size(); ++i)
            product[i] *= bare[i] > 0 ? static_cast<double>(alone[i]) / bare[i] : 0.0;
    }
    std::vector<int> rounded(product.size());
    for (std::size_t i = 0; i < product.size(); ++i)
        rounded[i] = static_cast<int>(std::lround(product[i]));
    EXPECT_GT(shadowed, 1.0) << "no light has a shadow: nothing was compared";
    EXPECT_LT(differing(all, rounded), Rounding);
}

INSTANTIATE_TEST_SUITE_P(Materials, Modulative,
                         testing::Values("Lixel/Surface", "Test/OwnModulativeReceiver",
                                         "Test/Unlit"),
                         testName);

} // namespace
} // namespace Lixel::Tests

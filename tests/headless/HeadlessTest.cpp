// OGRE's own render systems, as they are installed, with no display server. Each test wants a
// process of its own, as CTest gives it: headless rendering cannot be switched off again.

#include "OgreScene.h"

#include <Lixel/headless/Headless.h>

#include <OgreHardwarePixelBuffer.h>
#include <OgreRenderTexture.h>
#include <OgreTextureManager.h>

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace Lixel::Tests {
namespace {

using Ogre::ColourValue;

bool isInstalled(const std::string& renderSystem) {
    return std::filesystem::exists(OGRE_PLUGIN_DIR "/" + renderSystem + ".so");
}

constexpr unsigned red = 0xFF0000, green = 0x00FF00, blue = 0x0000FF, white = 0xFFFFFF;

class Headless : public testing::Test {
protected:
    void SetUp() override {
        unsetenv("DISPLAY");
        ASSERT_EQ(Lixel::Headless::enable(), "");
        ASSERT_TRUE(Lixel::Headless::isEnabled());
    }
};

// A red rectangle over the left half of the picture. In its lower part a green one behind its left
// half, and another in front of its right half.
void addRectangles(OgreScene& scene) {
    scene.addRectangle(-1, -1, 0, 1, 0.0f, ColourValue::Red);
    scene.addRectangle(-1, -1, -0.5f, 0, 0.5f, ColourValue::Green);
    scene.addRectangle(-0.5f, -1, 0, 0, -0.5f, ColourValue::Green);
}

void expectRectangles(const Picture& picture, unsigned background) {
    const unsigned quarter = picture.width() / 4, half = picture.height() / 2;
    // Upper row, then lower row, from left to right.
    EXPECT_EQ(picture.at(quarter / 2, half / 2), red);
    EXPECT_EQ(picture.at(quarter * 3 / 2, half / 2), red);
    EXPECT_EQ(picture.at(quarter * 3, half / 2), background);
    EXPECT_EQ(picture.at(quarter / 2, half * 3 / 2), red) << "hidden by depth";
    EXPECT_EQ(picture.at(quarter * 3 / 2, half * 3 / 2), green);
    EXPECT_EQ(picture.at(quarter * 3, half * 3 / 2), background);
    // To the pixel, up to the borders.
    EXPECT_EQ(picture.count(red), 3 * quarter * half);
    EXPECT_EQ(picture.count(green), quarter * half);
    EXPECT_EQ(picture.count(background), 4 * quarter * half);
}

TEST_F(Headless, DrawsInAWindow) {
    OgreScene scene("RenderSystem_GL3Plus");
    auto* window = scene.createWindow("window", 320, 200, Lixel::Headless::windowParameters());
    EXPECT_EQ(window->getWidth(), 320u);
    EXPECT_EQ(window->getHeight(), 200u);
    addRectangles(scene);
    scene.show(window, ColourValue::Blue);
    scene.root().renderOneFrame();
    expectRectangles(Picture(*window), blue);
}

TEST_F(Headless, DrawsInATexture) {
    OgreScene scene("RenderSystem_GL3Plus");
    scene.createWindow("window", 16, 16, Lixel::Headless::windowParameters());
    auto texture = Ogre::TextureManager::getSingleton().createManual(
        "texture", Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, 512, 256, 0, Ogre::PF_BYTE_RGBA,
        Ogre::TU_RENDERTARGET);
    Ogre::RenderTarget* target = texture->getBuffer()->getRenderTarget();
    addRectangles(scene);
    scene.show(target, ColourValue::White);
    target->update();
    expectRectangles(Picture(*target), white);
}

void drawWithTheLegacyRenderSystem() {
    if (!isInstalled("RenderSystem_GL")) GTEST_SKIP() << "this OGRE has no RenderSystem_GL";
    OgreScene scene("RenderSystem_GL");
    auto* window = scene.createWindow("window", 320, 200, Lixel::Headless::windowParameters());
    addRectangles(scene);
    scene.show(window, ColourValue::Blue);
    scene.root().renderOneFrame();
    expectRectangles(Picture(*window), blue);
}

void expectNoWindowUnder(Lixel::Headless::Profile profile, const std::string& renderSystem,
                         const std::string& reason) {
    if (usesEgl) GTEST_SKIP() << onlyWithGlx;
    if (!isInstalled(renderSystem)) GTEST_SKIP() << "this OGRE has no " << renderSystem;
    ASSERT_EQ(Lixel::Headless::enable({.profile = profile}), "");
    // Kept loaded, so that a leak report can tell that OGRE leaks the window.
    ASSERT_TRUE(
        dlopen((OGRE_PLUGIN_DIR "/" + renderSystem + ".so").c_str(), RTLD_NOW | RTLD_NODELETE));
    OgreScene scene(renderSystem);
    testing::internal::CaptureStderr();
    EXPECT_THROW(scene.createWindow("window", 64, 48, Lixel::Headless::windowParameters()),
                 Ogre::RenderingAPIException);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find(reason), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

// The legacy render system calls some functions of OpenGL directly and needs the other profile.
TEST_F(Headless, DrawsWithTheLegacyRenderSystem) {
    drawWithTheLegacyRenderSystem();
}

TEST_F(Headless, DrawsWithTheLegacyRenderSystemAskedFor) {
    ASSERT_EQ(Lixel::Headless::enable({.profile = Lixel::Headless::Profile::Compatibility}), "");
    drawWithTheLegacyRenderSystem();
}

TEST_F(Headless, TheLegacyRenderSystemHasNoWindowUnderCore) {
    expectNoWindowUnder(Lixel::Headless::Profile::Core, "RenderSystem_GL",
                        "another OpenGL profile than RenderSystem_GL needs");
}

TEST_F(Headless, GL3PlusHasNoWindowUnderCompatibility) {
    expectNoWindowUnder(Lixel::Headless::Profile::Compatibility, "RenderSystem_GL3Plus",
                        "another OpenGL profile than RenderSystem_GL3Plus needs");
}

// OSMesa has desktop OpenGL alone.
TEST_F(Headless, GLES2HasNoWindow) {
    expectNoWindowUnder(Lixel::Headless::Profile::Auto, "RenderSystem_GLES2",
                        "RenderSystem_GLES2 cannot be used headless");
}

TEST_F(Headless, GLES2HasNoWindowUnderCompatibility) {
    expectNoWindowUnder(Lixel::Headless::Profile::Compatibility, "RenderSystem_GLES2",
                        "RenderSystem_GLES2 cannot be used headless");
}

TEST_F(Headless, RootCanBeMadeAgain) {
    for (const ColourValue& background :
         {ColourValue::Blue, ColourValue::White, ColourValue::Blue}) {
        SCOPED_TRACE(background);
        OgreScene scene("RenderSystem_GL3Plus");
        auto* window = scene.createWindow("window", 64, 64, Lixel::Headless::windowParameters());
        addRectangles(scene);
        scene.show(window, background);
        scene.root().renderOneFrame();
        expectRectangles(Picture(*window), background == ColourValue::Blue ? blue : white);
    }
}

TEST_F(Headless, WindowsKeepTheirOwnPictures) {
    OgreScene scene("RenderSystem_GL3Plus", 2);
    auto* first = scene.createWindow("first", 64, 48, Lixel::Headless::windowParameters());
    addRectangles(scene);
    scene.show(first, ColourValue::Blue);
    scene.root().renderOneFrame();
    auto* second = scene.createWindow("second", 640, 480, Lixel::Headless::windowParameters());
    scene.show(second, ColourValue::White);
    for (int frame = 0; frame < 2; ++frame) {
        scene.root().renderOneFrame();
        expectRectangles(Picture(*first), blue);
        expectRectangles(Picture(*second), white);
    }
}

// Documented: the third one shares the framebuffer of the window that was drawn last, the first.
TEST_F(Headless, AWindowWithUsedParametersSharesAFramebuffer) {
    if (usesEgl) GTEST_SKIP() << onlyWithGlx;
    OgreScene scene("RenderSystem_GL3Plus", 3);
    auto* first = scene.createWindow("first", 64, 48, Lixel::Headless::windowParameters());
    const Parameters used = Lixel::Headless::windowParameters();
    auto* second = scene.createWindow("second", 80, 60, used);
    addRectangles(scene);
    scene.show(first, ColourValue::Blue);
    scene.show(second, ColourValue::Blue);
    second->update();
    first->update();
    auto* third = scene.createWindow("third", 640, 480, used);
    scene.show(third, ColourValue::White);
    third->update();
    expectRectangles(Picture(*third), white);
    expectRectangles(Picture(*second), blue);
    first->update();
    expectRectangles(Picture(*first), blue);
}

TEST_F(Headless, AWindowCanBeResized) {
    OgreScene scene("RenderSystem_GL3Plus");
    auto* window = scene.createWindow("window", 64, 48, Lixel::Headless::windowParameters());
    addRectangles(scene);
    scene.show(window, ColourValue::Blue);
    scene.root().renderOneFrame();
    for (const auto& [width, height] : {std::pair{400u, 300u}, std::pair{40u, 20u}}) {
        if (usesEgl && width > 64) continue; // documented: it cannot grow
        window->resize(width, height);
        scene.root().renderOneFrame();
        EXPECT_EQ(window->getWidth(), width);
        EXPECT_EQ(window->getHeight(), height);
        expectRectangles(Picture(*window), blue);
    }
}

TEST_F(Headless, SizesAreKeptWithinWhatCanBeDrawn) {
    if (usesEgl) GTEST_SKIP() << onlyWithGlx;
    OgreScene scene("RenderSystem_GL3Plus", 2);
    auto* empty = scene.createWindow("empty", 0, 0, Lixel::Headless::windowParameters());
    EXPECT_EQ(empty->getWidth(), 1u);
    EXPECT_EQ(empty->getHeight(), 1u);
    auto* wide = scene.createWindow("wide", 100000, 4, Lixel::Headless::windowParameters());
    EXPECT_EQ(wide->getWidth(), 16384u);
    EXPECT_EQ(wide->getHeight(), 4u);
    addRectangles(scene);
    scene.show(empty, ColourValue::Blue);
    scene.show(wide, ColourValue::Blue);
    scene.root().renderOneFrame();
    expectRectangles(Picture(*wide), blue);
}

TEST_F(Headless, AWindowWithoutItsParametersIsAnError) {
    if (usesEgl) GTEST_SKIP() << onlyWithGlx;
    // Kept loaded, so that a leak report can tell that OGRE leaks the window.
    ASSERT_TRUE(dlopen(OGRE_PLUGIN_DIR "/RenderSystem_GL3Plus.so", RTLD_NOW | RTLD_NODELETE));
    OgreScene scene("RenderSystem_GL3Plus");
    testing::internal::CaptureStderr();
    EXPECT_THROW(scene.createWindow("window", 64, 48, {}), Ogre::RenderingAPIException);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("windowParameters()"), std::string::npos);
}

TEST_F(Headless, RootNeedsNoWindow) {
    OgreScene scene("RenderSystem_GL3Plus");
    EXPECT_EQ(scene.root().getRenderSystem()->getName(), "OpenGL 3+ Rendering Subsystem");
}

TEST(HeadlessByEgl, NeedsNoOSMesa) {
    if (!usesEgl) GTEST_SKIP() << "OGRE was built with GLX";
    unsetenv("DISPLAY");
    ASSERT_EQ(Lixel::Headless::enable({.library = "libNoSuchOSMesa.so.8"}), "");
    OgreScene scene("RenderSystem_GL3Plus");
    auto* window = scene.createWindow("window", 320, 200, Lixel::Headless::windowParameters());
    addRectangles(scene);
    scene.show(window, ColourValue::Blue);
    scene.root().renderOneFrame();
    expectRectangles(Picture(*window), blue);
}

} // namespace
} // namespace Lixel::Tests

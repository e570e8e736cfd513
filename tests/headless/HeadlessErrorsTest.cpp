// What does not need a render window: errors, and whether there is a display. Each test wants a
// process of its own, as HeadlessTest's.

#include "OgreScene.h"

#include <Lixel/headless/EglDevice.h>
#include <Lixel/headless/Headless.h>

#include <cstdlib>

namespace Lixel::Tests {
namespace {

TEST(HeadlessErrors, NoOSMesa) {
    if (usesEgl) GTEST_SKIP() << onlyWithGlx;
    ASSERT_FALSE(Lixel::Headless::isEnabled()) << "run this test in a process of its own";
    const std::string error = Lixel::Headless::enable({.library = "libNoSuchOSMesa.so.8"});
    EXPECT_NE(error.find("libNoSuchOSMesa.so.8"), std::string::npos) << error;
    EXPECT_NE(error.find("libosmesa6"), std::string::npos) << error;
    EXPECT_FALSE(Lixel::Headless::isEnabled());
    EXPECT_TRUE(Lixel::Headless::windowParameters().empty());
}

TEST(HeadlessErrors, NotOSMesa) {
    if (usesEgl) GTEST_SKIP() << onlyWithGlx;
    ASSERT_FALSE(Lixel::Headless::isEnabled()) << "run this test in a process of its own";
    const std::string error = Lixel::Headless::enable({.library = "libm.so.6"});
    EXPECT_NE(error.find("libm.so.6 is not"), std::string::npos) << error;
    EXPECT_FALSE(Lixel::Headless::isEnabled());
}

TEST(HeadlessErrors, CanBeEnabledAfterAFailure) {
    if (usesEgl) GTEST_SKIP() << onlyWithGlx;
    ASSERT_NE(Lixel::Headless::enable({.library = "libNoSuchOSMesa.so.8"}), "");
    EXPECT_EQ(Lixel::Headless::enable(), "");
    EXPECT_TRUE(Lixel::Headless::isEnabled());
}

// Without enable() the render system must reach the real libX11, which finds no server.
TEST(HeadlessErrors, NotEnabled) {
    if (usesEgl) GTEST_SKIP() << onlyWithGlx;
    ASSERT_FALSE(Lixel::Headless::isEnabled()) << "run this test in a process of its own";
    unsetenv("DISPLAY");
    Ogre::LogManager logs;
    logs.createLog("", true, false, true);
    // It outlives the exception, whose code is in the plugin that Root unloads.
    Ogre::Root root("", "", "");
    EXPECT_THROW(root.loadPlugin(OGRE_PLUGIN_DIR "/RenderSystem_GL3Plus"),
                 Ogre::RenderingAPIException);
}

TEST(EglDevice, WithoutEglNamesTheLibraryAndItsPackage) {
    std::string error;
    EXPECT_FALSE(Lixel::Headless::hasEglDevice(error, "libNoSuchEGL.so.1"));
    EXPECT_NE(error.find("libNoSuchEGL.so.1"), std::string::npos) << error;
    EXPECT_NE(error.find("libegl1"), std::string::npos) << error;
}

TEST(EglDevice, ThatCannotBeListedIsNotSaidToBeMissing) {
    std::string error;
    EXPECT_FALSE(Lixel::Headless::hasEglDevice(error, "libm.so.6"));
    EXPECT_NE(error.find("libm.so.6 cannot list devices"), std::string::npos) << error;
}

TEST(DisplayUsable, NotWithoutAName) {
    unsetenv("DISPLAY");
    EXPECT_FALSE(Lixel::Headless::isDisplayUsable());
    setenv("DISPLAY", "", 1);
    EXPECT_FALSE(Lixel::Headless::isDisplayUsable());
}

TEST(DisplayUsable, NotWithoutAServer) {
    setenv("DISPLAY", ":54321", 1);
    EXPECT_FALSE(Lixel::Headless::isDisplayUsable());
    ASSERT_EQ(Lixel::Headless::enable(), "");
    EXPECT_FALSE(Lixel::Headless::isDisplayUsable());
}

} // namespace
} // namespace Lixel::Tests

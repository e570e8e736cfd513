// One program that can draw in a GLFW window and headless. It is linked to libX11 by itself and by
// GLFW.

#include "OgreScene.h"

#include <Lixel/headless/Headless.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <X11/Xlib.h>

#include <cstdlib>

// <GLFW/glfw3native.h> declares it, but includes headers of Xrandr that nothing else here needs.
extern "C" unsigned long glfwGetX11Window(GLFWwindow* window);

namespace Lixel::Tests {
namespace {

constexpr unsigned red = 0xFF0000, blue = 0x0000FF;

void drawAndCheck(OgreScene& scene, Ogre::RenderWindow& window) {
    scene.addRectangle(-1, -1, 0, 1, 0, Ogre::ColourValue::Red);
    scene.show(&window, Ogre::ColourValue::Blue);
    scene.root().renderOneFrame();
    window.update(false); // swapping buffers leaves those of a real window undefined
    const Picture picture(window);
    EXPECT_EQ(picture.width(), 320u);
    EXPECT_EQ(picture.height(), 200u);
    EXPECT_EQ(picture.count(red), 160u * 200u);
    EXPECT_EQ(picture.count(blue), 160u * 200u);
}

struct GlfwWindow {
    GlfwWindow() {
        glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
        glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
        handle = glfwCreateWindow(320, 200, "Lixel", nullptr, nullptr);
    }
    ~GlfwWindow() { glfwDestroyWindow(handle); }
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    Parameters parameters() const {
        return {{"parentWindowHandle", std::to_string(glfwGetX11Window(handle))}};
    }

    GLFWwindow* handle;
};

void expectXWindow(Window window) {
    Display* display = XOpenDisplay(nullptr);
    ASSERT_NE(display, nullptr);
    XWindowAttributes attributes = {};
    EXPECT_TRUE(XGetWindowAttributes(display, window, &attributes));
    EXPECT_EQ(attributes.width, 320);
    EXPECT_EQ(attributes.height, 200);
    EXPECT_EQ(attributes.map_state, IsViewable);
    XCloseDisplay(display);
}

TEST(WindowOrHeadless, DrawsHeadless) {
    unsetenv("DISPLAY");
    ASSERT_EQ(Lixel::Headless::enable(), "");
    OgreScene scene("RenderSystem_GL3Plus");
    auto* window = scene.createWindow("window", 320, 200, Lixel::Headless::windowParameters());
    drawAndCheck(scene, *window);
}

// GLFW must find that there is no server, and not take the stand-in for one.
TEST(WindowOrHeadless, GlfwIsNotServedHeadless) {
    unsetenv("DISPLAY");
    ASSERT_EQ(Lixel::Headless::enable(), "");
    EXPECT_FALSE(glfwInit());
}

// The following tests are run under Xvfb.

TEST(WithDisplay, IsUsable) {
    const char* server = std::getenv("DISPLAY");
    ASSERT_NE(server, nullptr) << "run this test under xvfb-run -a";
    EXPECT_TRUE(Lixel::Headless::isDisplayUsable());
    ASSERT_EQ(Lixel::Headless::enable(), "");
    EXPECT_TRUE(Lixel::Headless::isDisplayUsable()) << "it asks the real server";
    // Xvfb resets itself whenever its last client leaves: isDisplayUsable must have stayed.
    for (int i = 0; i < 10; ++i) {
        for (const char* name : {static_cast<const char*>(nullptr), server}) {
            Display* display = XOpenDisplay(name);
            ASSERT_NE(display, nullptr);
            EXPECT_STREQ(DisplayString(display), server);
            XCloseDisplay(display);
        }
    }
}

TEST(WithDisplay, DrawsInAGlfwWindow) {
    ASSERT_FALSE(Lixel::Headless::isEnabled()) << "run this test in a process of its own";
    ASSERT_TRUE(Lixel::Headless::isDisplayUsable()) << "run this test under xvfb-run -a";
    ASSERT_TRUE(glfwInit());
    {
        const GlfwWindow glfwWindow;
        ASSERT_NE(glfwWindow.handle, nullptr);
        OgreScene scene("RenderSystem_GL3Plus");
        auto* window = scene.createWindow("window", 320, 200, glfwWindow.parameters());
        Window xWindow = 0;
        window->getCustomAttribute("WINDOW", &xWindow);
        expectXWindow(xWindow);
        drawAndCheck(scene, *window);
    }
    glfwTerminate();
}

// A display changes nothing for headless rendering, and headless rendering nothing for GLFW.
TEST(WithDisplay, DrawsHeadlessBesideAGlfwWindow) {
    ASSERT_EQ(Lixel::Headless::enable(), "");
    ASSERT_TRUE(Lixel::Headless::isDisplayUsable()) << "run this test under xvfb-run -a";
    ASSERT_TRUE(glfwInit());
    {
        const GlfwWindow glfwWindow;
        ASSERT_NE(glfwWindow.handle, nullptr);
        OgreScene scene("RenderSystem_GL3Plus");
        auto* window = scene.createWindow("window", 320, 200, Lixel::Headless::windowParameters());
        Window xWindow = 0;
        window->getCustomAttribute("WINDOW", &xWindow);
        EXPECT_EQ(xWindow, 0u);
        drawAndCheck(scene, *window);
    }
    glfwTerminate();
}

} // namespace
} // namespace Lixel::Tests

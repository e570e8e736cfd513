#pragma once

/** @file
    OGRE's OpenGL render systems without a display server.

    The GL3Plus and GL render systems can only draw where an X server runs. This library stands in
    for the server: it defines the few functions of libX11 and libGL through which the render
    systems reach it, ahead of those libraries, and answers them with OSMesa, Mesa's software
    OpenGL that draws into memory. OGRE itself is not changed. Until enable() is called every one
    of these functions does what the real library does, so that one program can draw in a window
    or without:

        std::map<std::string, std::string> window;
        if (Lixel::Headless::isDisplayUsable()) {
            window["parentWindowHandle"] = ...; // e.g. glfwGetX11Window
        } else {
            if (const std::string error = Lixel::Headless::enable(); !error.empty()) {
                std::cerr << error << '\n';
                return 1;
            }
            window = Lixel::Headless::windowParameters();
        }
        Ogre::Root root(...);
        root.loadPlugin(... "RenderSystem_GL3Plus");
        root.setRenderSystem(root.getAvailableRenderers().front());
        root.initialise(false);
        root.createRenderWindow("any name", 800, 600, false, &window);

    OGRE 13 and newer is usually built with EGL instead of GLX, and then draws without a server on
    the first EGL device: a GPU, or Mesa's software where there is none. With such an OGRE this
    library only hides the X display from render systems, and needs no OSMesa.

    The program itself, not a plugin that it loads, has to link the library, and before libX11 and
    libGL: the CMake target Lixel::Headless puts it first. If it is not, enable() says so.

    Not for several threads at once: call everything here from the thread that owns Ogre::Root.
*/

#include <map>
#include <string>

#if defined(__GNUC__)
#define LIXEL_HEADLESS_EXPORT __attribute__((visibility("default")))
#else
#define LIXEL_HEADLESS_EXPORT
#endif

namespace Lixel::Headless {
/// @addtogroup LixelHeadless
/// @{

/// The kind of OpenGL context that a render system expects.
enum class Profile {
    Core,          ///< for RenderSystem_GL3Plus
    Compatibility, ///< for RenderSystem_GL, the legacy one
    Auto,          ///< what the render system needs that asks; Core if it is linked statically
};

/// What enable() may be told.
struct Options {
    /// The profile of the windows made from then on. If the render system needs another profile,
    /// createRenderWindow throws, and stderr says why.
    Profile profile = Profile::Auto;
    /// The OSMesa library, a name or a path as dlopen() takes it. Neither this nor the profile is
    /// used where OGRE was built with EGL. It is loaded by enable() and not before, so that a
    /// program that links Lixel::Headless also starts where there is no OSMesa.
    std::string library = "libOSMesa.so.8";
};

/** Switch headless rendering on, for the rest of the process.

    Call it before Ogre::Root is made or, at the latest, before a render system's plugin is loaded.
    Libraries that load libGL themselves, such as GLFW, still reach the real server. Code linked to
    GLX gets ours.

    Once on, calling it again only changes the profile; the library stays the one that was loaded.
    @return empty if headless rendering is on as asked. Else what is wrong and what to do about it,
    and nothing has changed. */
[[nodiscard]] LIXEL_HEADLESS_EXPORT std::string enable(const Options& options = {});

/// Whether enable() has succeeded in this process.
[[nodiscard]] LIXEL_HEADLESS_EXPORT bool isEnabled();

/** The miscellaneous parameters for the next Ogre::Root::createRenderWindow.

    The window has the width and height that createRenderWindow is given, within 1 to 16384 pixels,
    and an OpenGL context and a framebuffer of its own. Other parameters can be added, but OSMesa's
    framebuffer has neither multisampling nor gamma correction: render to a texture for these.
    Ask right before each window is made. Otherwise the new window shares the most recently drawn
    window's framebuffer. RenderWindow::resize works. The memory is released when the render systems
    are, that is with Ogre::Root, not with the window.

    Without these parameters (or with `Root::initialise(true)`) createRenderWindow throws.

    Where OGRE was built with EGL it makes the window itself: of exactly the given size, which has
    to be what EGL can draw, and resize() can only make it smaller.

    Several windows: OGRE 13 and newer draws nothing but the background into all but the first,
    shown on a display or not. OGRE uses one program pipeline object for all windows, but pipelines
    are not shared between contexts. Disable them before Root::initialise:
    `renderSystem->setConfigOption("Separate Shader Objects", "No")`.
    @return the parameters, or an empty map while isEnabled() is false */
[[nodiscard]] LIXEL_HEADLESS_EXPORT std::map<std::string, std::string> windowParameters();

/** Whether a window could be opened: DISPLAY is set, and its X server accepts a connection.

    It asks the real server, whether headless rendering is on or not, and stays connected to it. It
    says nothing of that server's OpenGL. */
[[nodiscard]] LIXEL_HEADLESS_EXPORT bool isDisplayUsable();

/// @}
} // namespace Lixel::Headless

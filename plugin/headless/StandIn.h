#pragma once

// The stand-in for an X display, the surfaces that its windows draw to, and the library's state.

#include "Lixel/headless/OSMesa.h"

#include <GL/glx.h>
#include <X11/Xlib.h>

#include <cstdint>
#include <list>
#include <optional>
#include <string_view>
#include <vector>

namespace Lixel::Headless {

/// The largest side of a framebuffer that Mesa's software renderers draw to (OSMESA_MAX_WIDTH).
constexpr unsigned maxSide = 16384;

/// What one render window draws to. Its address serves as GLXContext and as GLXDrawable.
struct Surface {
    OSMesaContext context = nullptr;
    unsigned width = 1, height = 1;
    std::vector<std::uint32_t> pixels; ///< OSMesa reads and writes it while the context is current

    void growTo(unsigned newWidth, unsigned newHeight);
};

/// What the library remembers.
struct State {
    bool enabled = false;
    std::optional<OSMesa> mesa; ///< if headless rendering is on, and not by EGL
    Profile profile = Profile::Auto;

    int connections = 0; ///< how many XOpenDisplay of the stand-in have not been closed

    std::list<Surface> surfaces; ///< a list, because their addresses have been given away
    /// windowParameters() was called: the next window needs a surface.
    bool windowAnnounced = false;
    Surface* newSurface = nullptr; ///< made for a window that has not yet asked for its drawable
};

/// The one state of the process.
State& state();

/// Whether GLX is answered here: headless rendering is on, and by OSMesa.
bool isServed();

/// The stand-in's name. No real display has it.
constexpr std::string_view displayName = "lixel-headless";

/// The display that render systems are given. It has no server.
Display* standIn();

/// Make a surface's context current with a framebuffer of its size, or none if surface is nullptr.
bool makeCurrent(Surface* surface);

/// The surface whose context is current in this thread, or nullptr.
Surface* currentSurface();

} // namespace Lixel::Headless

// The functions of libX11 through which render systems reach a display.

#include "Lixel/headless/Caller.h"
#include "Lixel/headless/RealFunctions.h"
#include "Lixel/headless/StandIn.h"

#include <string_view>

using namespace Lixel::Headless;

LIXEL_ENTRY Display* XOpenDisplay(const char* name) {
    State& s = state();
    if (name && name == displayName) {
        ++s.connections;
        return standIn();
    }
    // With EGL, a render system that finds no display uses an EGL device. Other callers get
    // the user's display.
    if (s.enabled && !name && callerAt(__builtin_return_address(0)) != Caller::Other)
        return nullptr;
    return forward<&XOpenDisplay>(__func__, name);
}

LIXEL_ENTRY int XCloseDisplay(Display* display) {
    if (display != standIn()) return forward<&XCloseDisplay>(__func__, display);
    State& s = state();
    if (--s.connections > 0) return 0;
    // The last render system is gone, and everything of OpenGL with it. Destroying the contexts any
    // later, when the process exits, would be after OSMesa's own exit handler.
    makeCurrent(nullptr);
    for (const Surface& surface : s.surfaces)
        s.mesa->destroyContext(surface.context);
    s.surfaces.clear();
    s.newSurface = nullptr;
    return 0;
}

LIXEL_ENTRY Atom XInternAtom(Display* display, const char* name, Bool onlyIfExists) {
    if (display != standIn()) return forward<&XInternAtom>(__func__, display, name, onlyIfExists);
    return None;
}

LIXEL_ENTRY Bool XQueryExtension(Display* display, const char* name, int* opcode, int* event,
                                 int* error) {
    if (display != standIn())
        return forward<&XQueryExtension>(__func__, display, name, opcode, event, error);
    return False;
}

// OGRE's RenderWindow::resize. It has no X window to name, so all framebuffers grow: OGRE draws in
// the lower left corner of one that is larger than its window.
LIXEL_ENTRY int XResizeWindow(Display* display, Window window, unsigned width, unsigned height) {
    if (display != standIn())
        return forward<&XResizeWindow>(__func__, display, window, width, height);
    for (Surface& surface : state().surfaces)
        surface.growTo(width, height);
    if (Surface* surface = currentSurface()) makeCurrent(surface);
    return 1;
}

LIXEL_ENTRY int XFlush(Display* display) {
    return display == standIn() ? 1 : forward<&XFlush>(__func__, display);
}

// The public functions, and how the library works, against OGRE 1.12's GLXGLSupport and GLXWindow:
//
//  1. The render system's constructor asks glXGetCurrentDisplay for a display that the application
//     may have opened already, and we name the stand-in (StandIn.h). It then opens a second
//     connection to the same server by that display's name, which only the stand-in has. Calls with
//     a Display* are answered only for ours. Calls without one are answered here once OSMesa is
//     enabled. All others are forwarded to the real libraries (RealFunctions.h). The functions are
//     in X11Functions.cpp and GlxFunctions.cpp.
//  2. With "currentGLContext" the window takes over the application's context instead of making
//     one, and with "externalGLControl" it leaves swapping buffers to the application. So there is
//     no X window. Contexts are OSMesa's (OSMesa.h).
//  3. All OpenGL functions of GL3+ are looked up through glXGetProcAddressARB. The legacy render
//     system also calls some directly, which the dynamic linker finds in OSMesa if that was loaded
//     before libGL.
//
// OGRE 13 and newer, built with EGL instead of GLX, needs less: without an X display a render
// system draws into a buffer of the first EGL device (EglDevice.h). So XOpenDisplay finds none for
// it (Caller.h says who asks), and OSMesa and all functions of GLX stay out of it.

#include "Lixel/headless/Headless.h"

#include "Lixel/headless/EglDevice.h"
#include "Lixel/headless/RealFunctions.h"
#include "Lixel/headless/StandIn.h"

#include <dlfcn.h>

#include <cstdlib>
#include <optional>

namespace Lixel::Headless {
namespace {

/// How the OGRE that this was built with makes its OpenGL contexts.
constexpr bool UsesEgl = LIXEL_OGRE_USES_EGL != 0;

/// Whether the program finds @a function in this library, and not in the real one.
bool isFoundHere(const char* function) {
    Dl_info here = {}, found = {};
    // The program's handle stands for what everybody sees, render systems included. RTLD_DEFAULT
    // would also find what only this library sees.
    void* program = dlopen(nullptr, RTLD_LAZY);
    dladdr(reinterpret_cast<void*>(&isFoundHere), &here);
    if (void* address = dlsym(program, function)) dladdr(address, &found);
    dlclose(program);
    return here.dli_fbase == found.dli_fbase;
}

} // namespace

std::string enable(const Options& options) {
    State& s = state();
    // One function of libX11 and one of libGL.
    for (const char* function : {"XOpenDisplay", "glXGetCurrentDisplay"}) {
        if (isFoundHere(function)) continue;
        return std::string("Headless rendering cannot be enabled, because ") + function +
               " is found in another library first. Link the program itself to Lixel::Headless "
               "(libLixelHeadless.so), before libX11 and libGL.";
    }
    std::string error;
    if (UsesEgl) {
        s.enabled = s.enabled || hasEglDevice(error);
        return error;
    }
    std::optional<OSMesa> mesa = s.mesa ? s.mesa : loadOSMesa(options, error);
    if (!mesa) return error;
    // Under Auto, Core is what most ask for; Compatibility is tried when somebody does.
    const Profile likely = options.profile == Profile::Auto ? Profile::Core : options.profile;
    if (!canServe(*mesa, likely, error)) {
        if (!s.mesa) dlclose(mesa->handle);
        return error;
    }
    s.mesa = mesa;
    s.profile = options.profile;
    s.enabled = true;
    return {};
}

bool isEnabled() {
    return state().enabled;
}

std::map<std::string, std::string> windowParameters() {
    if (!isEnabled()) return {};
    if (UsesEgl) return {{"externalGLControl", "true"}};
    state().windowAnnounced = true;
    return {{"currentGLContext", "true"}, {"externalGLControl", "true"}};
}

bool isDisplayUsable() {
    const char* name = std::getenv("DISPLAY");
    if (!name || !*name) return false;
    Display* display = forward<&::XOpenDisplay>("XOpenDisplay", nullptr);
    if (!display) return false;
    // The first connection is kept: a server without other clients, as Xvfb is, resets itself when
    // its last one leaves, and refuses connections while resetting.
    static Display* kept = nullptr;
    if (kept)
        forward<&::XCloseDisplay>("XCloseDisplay", display);
    else
        kept = display;
    return true;
}

} // namespace Lixel::Headless

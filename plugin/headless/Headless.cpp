// How it works, against OGRE 1.12's GLXGLSupport and GLXWindow:
//
//  1. The render system's constructor asks glXGetCurrentDisplay for a display that the application
//     may have opened already, and we name the stand-in. It then opens a second connection to the
//     same server by that display's name, which only the stand-in has. Every later call names the
//     display that it is for, and so each function below knows whether to answer or to forward.
//  2. With "currentGLContext" the window takes over the application's context instead of making
//     one, and with "externalGLControl" it leaves swapping buffers to the application. So there is
//     no X window.
//  3. All OpenGL functions of GL3+ are looked up through glXGetProcAddressARB. The legacy render
//     system also calls some directly, which the dynamic linker finds in OSMesa if that was loaded
//     before libGL.
//
// OGRE 13 and newer, built with EGL instead of GLX, needs less: without an X display a render
// system draws into a buffer of the first EGL device. So XOpenDisplay finds none for it, and OSMesa
// and all functions of GLX stay out of it.

#include "Lixel/headless/Headless.h"

#include "Lixel/headless/Caller.h"
#include "Lixel/headless/EglDevice.h"

#include <GL/glx.h>
#include <GL/osmesa.h>
#include <X11/Xlib.h>

#include <dlfcn.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <list>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace Lixel::Headless;

/// How the OGRE that this was built with makes its OpenGL contexts.
constexpr bool UsesEgl = LIXEL_OGRE_USES_EGL != 0;

// ---------------------------------------------------------------------------- the real libraries

/// The function that we stand in front of, or nullptr where its library is missing. Looked up at
/// its first use: a machine without X has no use for either library.
template <auto* Function>
auto* real(const char* name) {
    static const auto function = [name] {
        // Both stay loaded for ever, as if the program had linked them.
        void* library =
            dlopen(name[0] == 'X' ? "libX11.so.6" : "libGL.so.1", RTLD_LAZY | RTLD_LOCAL);
        return reinterpret_cast<decltype(Function)>(library ? dlsym(library, name) : nullptr);
    }();
    return function;
}

/// Call the function that we stand in front of. Where its library is missing the answer is zero,
/// which for each of these functions says that there is no server.
template <auto* Function, typename... Arguments>
auto forward(const char* name, Arguments... arguments) {
    using Result = std::invoke_result_t<decltype(Function), Arguments...>;
    const auto function = real<Function>(name);
    return function ? function(arguments...) : Result();
}

// -------------------------------------------------------------------------------------------
// OSMesa

/// The functions of OSMesa that we use, from a library that is loaded at run time.
struct OSMesa {
    decltype(&OSMesaCreateContextAttribs) createContext = nullptr;
    decltype(&OSMesaDestroyContext) destroyContext = nullptr;
    decltype(&OSMesaMakeCurrent) makeCurrent = nullptr;
    decltype(&OSMesaGetCurrentContext) getCurrentContext = nullptr;
    decltype(&OSMesaGetProcAddress) getProcAddress = nullptr;
    void* handle = nullptr;
};

/// The largest side of a framebuffer that Mesa's software renderers draw to (OSMESA_MAX_WIDTH).
constexpr unsigned maxSide = 16384;

/// What one render window draws to. Its address serves as GLXContext and as GLXDrawable.
struct Surface {
    OSMesaContext context = nullptr;
    unsigned width = 1, height = 1;
    std::vector<std::uint32_t> pixels; ///< OSMesa reads and writes it while the context is current

    void growTo(unsigned newWidth, unsigned newHeight) {
        width = std::clamp(newWidth, width, maxSide);
        height = std::clamp(newHeight, height, maxSide);
    }
};

/// OGRE reads a Display through Xlib's macros, that is as this structure.
using PublicDisplay = std::remove_pointer_t<_XPrivDisplay>;

struct State {
    bool enabled = false;
    std::optional<OSMesa> mesa; ///< if headless rendering is on, and not by EGL
    Profile profile = Profile::Auto;

    PublicDisplay display = {};
    Screen screen = {};
    char displayName[16] = "lixel-headless";
    int connections = 0; ///< how many XOpenDisplay of the stand-in have not been closed

    std::list<Surface> surfaces; ///< a list, because their addresses have been given away
    bool windowAnnounced =
        false; ///< windowParameters() was called: the next window needs a surface
    Surface* newSurface = nullptr; ///< made for a window that has not yet asked for its drawable
};

State& state() {
    // Never destroyed: a static destructor would run after OSMesa's own exit handler.
    static State& theState = *[] {
        auto made = new State;
        made->display.screens = &made->screen;
        made->display.nscreens = 1;
        made->display.display_name = made->displayName;
        made->screen.root = 1;
        // The size of the desktop: OGRE offers it as the only video mode.
        made->screen.width = 1920;
        made->screen.height = 1080;
        return made;
    }();
    return theState;
}

/// Whether GLX is answered here: headless rendering is on, and by OSMesa.
bool isServed() {
    return state().mesa.has_value();
}

Display* standIn() {
    return reinterpret_cast<Display*>(&state().display);
}

OSMesaContext createContext(const OSMesa& mesa, Profile profile, OSMesaContext shareWith) {
    const bool core = profile == Profile::Core;
    // The least version that OGRE's render system needs: Mesa gives the highest one it has that is
    // compatible with it.
    const int attributes[][2] = {
        {OSMESA_FORMAT, OSMESA_RGBA},
        {OSMESA_DEPTH_BITS, 24},
        {OSMESA_STENCIL_BITS, 8},
        {OSMESA_PROFILE, core ? OSMESA_CORE_PROFILE : OSMESA_COMPAT_PROFILE},
        {OSMESA_CONTEXT_MAJOR_VERSION, core ? 3 : 2},
        {OSMESA_CONTEXT_MINOR_VERSION, core ? 3 : 1},
        {0, 0},
    };
    return mesa.createContext(&attributes[0][0], shareWith);
}

/// Make a surface's context current with a framebuffer of its size, or none if surface is nullptr.
bool makeCurrent(Surface* surface) {
    const OSMesa& mesa = *state().mesa;
    if (!surface) return mesa.makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    const std::size_t size = std::size_t{surface->width} * surface->height;
    std::vector<std::uint32_t> replaced; // lives on until OSMesa has let go of it
    if (surface->pixels.size() != size)
        replaced = std::exchange(surface->pixels, std::vector<std::uint32_t>(size));
    return mesa.makeCurrent(surface->context, surface->pixels.data(), GL_UNSIGNED_BYTE,
                            static_cast<GLsizei>(surface->width),
                            static_cast<GLsizei>(surface->height));
}

/// The surface whose context is current in this thread, or nullptr.
Surface* currentSurface() {
    State& s = state();
    const OSMesaContext current = s.mesa->getCurrentContext();
    const auto found =
        std::find_if(s.surfaces.begin(), s.surfaces.end(),
                     [current](const Surface& surface) { return surface.context == current; });
    return found == s.surfaces.end() ? nullptr : &*found;
}

GLXContext contextOf(Surface* surface) {
    return reinterpret_cast<GLXContext>(surface);
}
GLXDrawable drawableOf(Surface* surface) {
    return reinterpret_cast<GLXDrawable>(surface);
}

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

/// Load OSMesa and see that it can do what is asked. Without a value @a error tells why.
std::optional<OSMesa> loadOSMesa(const Options& options, std::string& error) {
    const std::string& name = options.library;
    OSMesa mesa;
    // RTLD_GLOBAL because the legacy render system calls glClear and its like directly.
    mesa.handle = dlopen(name.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (!mesa.handle) {
        const char* reason = dlerror();
        error = "Headless rendering needs OSMesa, but it cannot be loaded: " +
                std::string(reason ? reason : name) + ". On Debian it is the package libosmesa6.";
        return std::nullopt;
    }
    const auto lookUp = [&mesa](auto& function, const char* symbol) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(
            dlsym(mesa.handle, symbol));
        return function != nullptr;
    };
    if (!lookUp(mesa.createContext, "OSMesaCreateContextAttribs") ||
        !lookUp(mesa.destroyContext, "OSMesaDestroyContext") ||
        !lookUp(mesa.makeCurrent, "OSMesaMakeCurrent") ||
        !lookUp(mesa.getCurrentContext, "OSMesaGetCurrentContext") ||
        !lookUp(mesa.getProcAddress, "OSMesaGetProcAddress")) {
        error = "Headless rendering needs OSMesa 11.2 or newer, which " + name + " is not.";
        dlclose(mesa.handle);
        return std::nullopt;
    }
    return mesa;
}

/// Whether @a mesa can serve a render system of this profile, which is not Auto, in this program.
/// If not, @a error says why.
bool canServe(const OSMesa& mesa, Profile profile, std::string& error) {
    void* program = dlopen(nullptr, RTLD_LAZY);
    const bool clearIsMesas = dlsym(program, "glClear") == dlsym(mesa.handle, "glClear");
    dlclose(program);
    if (profile == Profile::Compatibility && !clearIsMesas) {
        error =
            "The legacy GL render system cannot be used headless here, because its direct OpenGL "
            "calls would go to a libGL that is already loaded. Do not link the program to libGL, "
            "enable headless rendering before any render system is loaded, or use "
            "RenderSystem_GL3Plus.";
        return false;
    }
    // Asked now, when it can still be told clearly; OGRE would only find no current context.
    const OSMesaContext trial = createContext(mesa, profile, nullptr);
    if (!trial) {
        error = std::string("This OSMesa has no OpenGL ") +
                (profile == Profile::Core ? "3.3 core" : "2.1 compatibility") + " profile.";
        return false;
    }
    mesa.destroyContext(trial);
    return true;
}

/// The profile of the context that a render system asks for, or Auto if it can have none; then
/// stderr has been told why.
Profile profileFor(Caller caller) {
    const State& s = state();
    const Profile needed = caller == Caller::GL ? Profile::Compatibility : Profile::Core;
    std::string error;
    if (s.profile == Profile::Auto) {
        // Core was found to be there when headless rendering was enabled.
        if (needed == Profile::Core || canServe(*s.mesa, needed, error)) return needed;
    } else {
        if (s.profile == needed || caller == Caller::Other) return s.profile;
        error = std::string("Headless rendering was enabled for another OpenGL profile than ") +
                (caller == Caller::GL ? "RenderSystem_GL" : "RenderSystem_GL3Plus") +
                " needs. Leave Options::profile at Auto.";
    }
    std::fprintf(stderr, "Lixel: %s\n", error.c_str());
    return Profile::Auto;
}

} // namespace

// -------------------------------------------------------------------------- the public functions

namespace Lixel::Headless {

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
    // its last one leaves, and meanwhile refuses the program that was told that it may come.
    static Display* kept = nullptr;
    if (kept)
        forward<&::XCloseDisplay>("XCloseDisplay", display);
    else
        kept = display;
    return true;
}

} // namespace Lixel::Headless

// ---------------------------------------------------------- what the render systems find first

#define LIXEL_ENTRY extern "C" LIXEL_HEADLESS_EXPORT

LIXEL_ENTRY Display* glXGetCurrentDisplay() {
    return isServed() ? standIn() : forward<&glXGetCurrentDisplay>(__func__);
}

LIXEL_ENTRY Display* XOpenDisplay(const char* name) {
    State& s = state();
    if (name && std::string_view(name) == s.displayName) {
        ++s.connections;
        return standIn();
    }
    // With EGL, a render system that finds no display uses an EGL device. Others find the user's.
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

LIXEL_ENTRY Bool glXQueryVersion(Display* display, int* major, int* minor) {
    if (display != standIn()) return forward<&glXQueryVersion>(__func__, display, major, minor);
    *major = 1;
    *minor = 4;
    return True;
}

LIXEL_ENTRY const char* glXGetClientString(Display* display, int name) {
    if (display != standIn()) return forward<&glXGetClientString>(__func__, display, name);
    return name == GLX_VERSION ? "1.4 (Lixel headless)" : "";
}

// One framebuffer configuration. It is found when OGRE lists all of them and when it asks for the
// one that a drawable has, but not when it looks for one to make a new window with.
LIXEL_ENTRY GLXFBConfig* glXChooseFBConfig(Display* display, int screen, const int* attributes,
                                           int* count) {
    if (display != standIn())
        return forward<&glXChooseFBConfig>(__func__, display, screen, attributes, count);
    *count = 0;
    if (attributes && attributes[0] != GLX_FBCONFIG_ID) return nullptr;
    // The caller releases it with XFree, which is free.
    const auto configs = static_cast<GLXFBConfig*>(std::malloc(sizeof(GLXFBConfig)));
    if (!configs) return nullptr;
    configs[0] = reinterpret_cast<GLXFBConfig>(&state());
    *count = 1;
    return configs;
}

// Called only if glXChooseFBConfig has found none.
LIXEL_ENTRY GLXFBConfig* glXGetFBConfigs(Display* display, int screen, int* count) {
    if (display != standIn()) return forward<&glXGetFBConfigs>(__func__, display, screen, count);
    std::fputs(
        "Lixel: a render window was asked for without the parameters that it needs headless. "
        "Pass Lixel::Headless::windowParameters() to Ogre::Root::createRenderWindow, and "
        "false to Ogre::Root::initialise.\n",
        stderr);
    *count = 0;
    return nullptr;
}

LIXEL_ENTRY int glXGetFBConfigAttrib(Display* display, GLXFBConfig config, int attribute,
                                     int* value) {
    if (display != standIn())
        return forward<&glXGetFBConfigAttrib>(__func__, display, config, attribute, value);
    const bool isColour = attribute == GLX_RED_SIZE || attribute == GLX_GREEN_SIZE ||
                          attribute == GLX_BLUE_SIZE || attribute == GLX_ALPHA_SIZE;
    *value = isColour ? 8 : 0;
    return Success;
}

LIXEL_ENTRY GLXContext glXGetCurrentContext() {
    if (!isServed()) return forward<&glXGetCurrentContext>(__func__);
    State& s = state();
    if (!s.windowAnnounced) return contextOf(currentSurface());
    // A window is about to be made and takes over what it believes to be the application's context.
    // It is not made current here, because OGRE goes on drawing to the window before.
    s.windowAnnounced = false;
    // Without a context OGRE throws; under the wrong profile it would end in an assertion.
    const Profile profile = profileFor(callerAt(__builtin_return_address(0)));
    if (profile == Profile::Auto) return nullptr;
    const OSMesaContext shareWith = s.surfaces.empty() ? nullptr : s.surfaces.front().context;
    const OSMesaContext context = createContext(*s.mesa, profile, shareWith);
    if (!context) return nullptr;
    s.newSurface = &s.surfaces.emplace_back();
    s.newSurface->context = context;
    return contextOf(s.newSurface);
}

LIXEL_ENTRY GLXDrawable glXGetCurrentDrawable() {
    if (!isServed()) return forward<&glXGetCurrentDrawable>(__func__);
    State& s = state();
    return drawableOf(s.newSurface ? std::exchange(s.newSurface, nullptr) : currentSurface());
}

LIXEL_ENTRY void glXQueryDrawable(Display* display, GLXDrawable drawable, int attribute,
                                  unsigned* value) {
    if (display != standIn()) {
        if (const auto function = real<&glXQueryDrawable>(__func__))
            function(display, drawable, attribute, value);
        return;
    }
    // The surface takes its size from its window: OGRE asks with variables that hold the size that
    // createRenderWindow was given, and uses what it then finds in them.
    const auto surface = reinterpret_cast<Surface*>(drawable);
    if (attribute == GLX_WIDTH) {
        surface->growTo(*value, 0);
        *value = std::clamp(*value, 1u, maxSide);
    } else if (attribute == GLX_HEIGHT) {
        surface->growTo(0, *value);
        *value = std::clamp(*value, 1u, maxSide);
    } else {
        *value = 0;
    }
}

LIXEL_ENTRY Bool glXMakeCurrent(Display* display, GLXDrawable drawable, GLXContext context) {
    if (display != standIn()) return forward<&glXMakeCurrent>(__func__, display, drawable, context);
    return makeCurrent(reinterpret_cast<Surface*>(context));
}

LIXEL_ENTRY __GLXextFuncPtr glXGetProcAddressARB(const GLubyte* name) {
    if (!isServed()) return forward<&glXGetProcAddressARB>(__func__, name);
    return state().mesa->getProcAddress(reinterpret_cast<const char*>(name));
}

// The functions of GLX, in libGL, through which render systems get their windows' contexts.

#include "Lixel/headless/Caller.h"
#include "Lixel/headless/RealFunctions.h"
#include "Lixel/headless/StandIn.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

using namespace Lixel::Headless;

namespace {

GLXContext contextOf(Surface* surface) {
    return reinterpret_cast<GLXContext>(surface);
}
GLXDrawable drawableOf(Surface* surface) {
    return reinterpret_cast<GLXDrawable>(surface);
}

const char* nameOf(Caller caller) {
    switch (caller) {
    case Caller::GL:
        return "RenderSystem_GL";
    case Caller::GLES2:
        return "RenderSystem_GLES2";
    default:
        return "RenderSystem_GL3Plus";
    }
}

/// The profile of the context that a render system asks for, or nothing if it can have none; then
/// stderr has been told why.
std::optional<Profile> profileFor(Caller caller) {
    const State& s = state();
    const Profile needed = caller == Caller::GL ? Profile::Compatibility : Profile::Core;
    std::string error;
    if (caller == Caller::GLES2) {
        error = std::string(nameOf(caller)) +
                " cannot be used headless here, because OSMesa has desktop OpenGL alone. Use "
                "RenderSystem_GL3Plus.";
    } else if (s.profile == Profile::Auto) {
        // Core was found to be there when headless rendering was enabled.
        if (needed == Profile::Core || canServe(*s.mesa, needed, error)) return needed;
    } else {
        if (s.profile == needed || caller == Caller::Other) return s.profile;
        error = std::string("Headless rendering was enabled for another OpenGL profile than ") +
                nameOf(caller) + " needs. Leave Options::profile at Auto.";
    }
    std::fprintf(stderr, "Lixel: %s\n", error.c_str());
    return std::nullopt;
}

} // namespace

LIXEL_ENTRY Display* glXGetCurrentDisplay() {
    return isServed() ? standIn() : forward<&glXGetCurrentDisplay>(__func__);
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
    const std::optional<Profile> profile = profileFor(callerAt(__builtin_return_address(0)));
    if (!profile) return nullptr;
    const OSMesaContext shareWith = s.surfaces.empty() ? nullptr : s.surfaces.front().context;
    const OSMesaContext context = createContext(*s.mesa, *profile, shareWith);
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
    if (display != standIn())
        return forward<&glXQueryDrawable>(__func__, display, drawable, attribute, value);
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

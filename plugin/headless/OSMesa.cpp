#include "Lixel/headless/OSMesa.h"

#include <dlfcn.h>

#include <type_traits>

namespace Lixel::Headless {

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

} // namespace Lixel::Headless

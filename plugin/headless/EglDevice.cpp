#include "Lixel/headless/EglDevice.h"

#include <dlfcn.h>

namespace Lixel::Headless {

bool hasEglDevice(std::string& error, const char* library) {
    // Declared here so the build needs no EGL headers.
    using GetProcAddress = void* (*)(const char*);
    using QueryDevices = unsigned (*)(int capacity, void** devices, int* count);

    // It stays loaded: OGRE's render systems are linked to it.
    void* const egl = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
    if (!egl) {
        const char* reason = dlerror();
        error = "Headless rendering needs EGL, but it cannot be loaded: " +
                std::string(reason ? reason : library) + ". On Debian it is the package libegl1.";
        return false;
    }
    const auto getProcAddress = reinterpret_cast<GetProcAddress>(dlsym(egl, "eglGetProcAddress"));
    const auto queryDevices = reinterpret_cast<QueryDevices>(
        getProcAddress ? getProcAddress("eglQueryDevicesEXT") : nullptr);
    if (!queryDevices) {
        error = "Headless rendering needs an EGL device, but " + std::string(library) +
                " cannot list devices: it lacks eglQueryDevicesEXT.";
        return false;
    }
    int count = 0;
    if (queryDevices(0, nullptr, &count) && count > 0) return true;
    error = "Headless rendering needs an EGL device, and EGL has none. On Debian the package "
            "libegl-mesa0 brings one that draws in software.";
    return false;
}

} // namespace Lixel::Headless

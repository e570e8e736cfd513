#include "Lixel/headless/EglDevice.h"

#include <dlfcn.h>

namespace Lixel::Headless {

bool hasEglDevice(std::string& error) {
    // Of <EGL/egl.h> and <EGL/eglext.h>, so that only who uses them needs them.
    using GetProcAddress = void* (*)(const char*);
    using QueryDevices = unsigned (*)(int capacity, void** devices, int* count);

    // It stays loaded: OGRE's render systems are linked to it.
    void* const library = dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL);
    const auto getProcAddress =
        reinterpret_cast<GetProcAddress>(library ? dlsym(library, "eglGetProcAddress") : nullptr);
    const auto queryDevices = reinterpret_cast<QueryDevices>(
        getProcAddress ? getProcAddress("eglQueryDevicesEXT") : nullptr);
    int count = 0;
    if (queryDevices && queryDevices(0, nullptr, &count) && count > 0) return true;
    error = "Headless rendering needs an EGL device, and EGL has none. On Debian the package "
            "libegl-mesa0 brings one that draws in software.";
    return false;
}

} // namespace Lixel::Headless

#pragma once

// OSMesa, Mesa's software OpenGL that draws into memory: loading it, and making contexts with it.

#include "Lixel/headless/Headless.h"

#include <GL/osmesa.h>

#include <optional>
#include <string>

namespace Lixel::Headless {

/// The functions of OSMesa that we use, from a library that is loaded at run time.
struct OSMesa {
    decltype(&OSMesaCreateContextAttribs) createContext = nullptr;
    decltype(&OSMesaDestroyContext) destroyContext = nullptr;
    decltype(&OSMesaMakeCurrent) makeCurrent = nullptr;
    decltype(&OSMesaGetCurrentContext) getCurrentContext = nullptr;
    decltype(&OSMesaGetProcAddress) getProcAddress = nullptr;
    void* handle = nullptr;
};

/// Load OSMesa and see that it can do what is asked. Without a value @a error tells why.
std::optional<OSMesa> loadOSMesa(const Options& options, std::string& error);

/// Make a context of @a profile, which is not Auto; null where OSMesa has none.
OSMesaContext createContext(const OSMesa& mesa, Profile profile, OSMesaContext shareWith);

/// Whether @a mesa can serve a render system of this profile, which is not Auto, in this program.
/// If not, @a error says why.
bool canServe(const OSMesa& mesa, Profile profile, std::string& error);

} // namespace Lixel::Headless

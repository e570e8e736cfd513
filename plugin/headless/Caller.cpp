#include "Lixel/headless/Caller.h"

#include <dlfcn.h>

#include <string_view>

namespace Lixel::Headless {

Caller callerAt(const void* returnAddress) {
    Dl_info library = {};
    if (dladdr(returnAddress, &library) == 0 || !library.dli_fname) return Caller::Other;
    const std::string_view path = library.dli_fname;
    const std::string_view name = path.substr(path.rfind('/') + 1); // all of it without a slash
    // What follows differs: "_d" in builds for debugging, ".so", a version.
    if (name.starts_with("RenderSystem_GL3Plus")) return Caller::GL3Plus;
    if (name.starts_with("RenderSystem_GLES2")) return Caller::GLES2;
    if (name.starts_with("RenderSystem_GL")) return Caller::GL;
    return Caller::Other;
}

} // namespace Lixel::Headless

#include "setup/GlFunctions.h"

#include <dlfcn.h>

#include <type_traits>

namespace Lixel {
namespace {

using GetProcAddress = void (*(*)(const char*))();

/// What gives OpenGL's functions of the context that is current. Null without.
GetProcAddress findGetProcAddress() {
    // EGL first: only with EGL is one of its contexts current.
    using GetCurrentContext = void* (*)();
    const auto eglContext =
        reinterpret_cast<GetCurrentContext>(dlsym(RTLD_DEFAULT, "eglGetCurrentContext"));
    const char* const name = eglContext != nullptr && eglContext() != nullptr
                                 ? "eglGetProcAddress"
                                 : "glXGetProcAddressARB";
    return reinterpret_cast<GetProcAddress>(dlsym(RTLD_DEFAULT, name));
}

} // namespace

GlFunctions::GlFunctions() {
    const GetProcAddress find = findGetProcAddress();
    if (find == nullptr) return;
    isLoaded = true;
    const auto load = [&](auto& function, const char* name) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(find(name));
        isLoaded = isLoaded && function != nullptr;
    };
    load(getIntegerv, "glGetIntegerv");
    load(getError, "glGetError");
    load(isEnabled, "glIsEnabled");
    load(enable, "glEnable");
    load(disable, "glDisable");
    load(pixelStorei, "glPixelStorei");
    load(readPixels, "glReadPixels");
    load(genFramebuffers, "glGenFramebuffers");
    load(deleteFramebuffers, "glDeleteFramebuffers");
    load(bindFramebuffer, "glBindFramebuffer");
    load(framebufferRenderbuffer, "glFramebufferRenderbuffer");
    load(checkFramebufferStatus, "glCheckFramebufferStatus");
    load(blitFramebuffer, "glBlitFramebuffer");
    load(getAttachmentParameter, "glGetFramebufferAttachmentParameteriv");
    load(genRenderbuffers, "glGenRenderbuffers");
    load(deleteRenderbuffers, "glDeleteRenderbuffers");
    load(bindRenderbuffer, "glBindRenderbuffer");
    load(renderbufferStorage, "glRenderbufferStorage");
    load(genBuffers, "glGenBuffers");
    load(deleteBuffers, "glDeleteBuffers");
    load(bindBuffer, "glBindBuffer");
    load(bufferData, "glBufferData");
    load(getBufferSubData, "glGetBufferSubData");
    load(fenceSync, "glFenceSync");
    load(clientWaitSync, "glClientWaitSync");
    load(deleteSync, "glDeleteSync");
}

} // namespace Lixel

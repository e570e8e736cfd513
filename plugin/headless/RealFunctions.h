#pragma once

// The functions of libX11 and libGL that this library stands in front of.

#include "Lixel/headless/Headless.h"

#include <dlfcn.h>

#include <type_traits>

/// A function that render systems find here before the real library's.
#define LIXEL_ENTRY extern "C" LIXEL_HEADLESS_EXPORT

namespace Lixel::Headless {

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

} // namespace Lixel::Headless

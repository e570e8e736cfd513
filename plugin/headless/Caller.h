#pragma once

namespace Lixel::Headless {

/// OGRE's OpenGL render systems, by the library that each is in.
enum class Caller {
    Other, ///< not one of them, or one that is linked into the program itself
    GL3Plus,
    GL, ///< the legacy one
    GLES2,
};

/// Which render system a function was called from.
/// @param returnAddress `__builtin_return_address(0)` of that function
Caller callerAt(const void* returnAddress);

} // namespace Lixel::Headless
